// Las matrices de geometría de los dos trozos de superficie_hermite (ecuación 11.37, ejercicio 11.8). Sin OpenGL.
#pragma once
#include "superficies.h"

/// Las esquinas del primer trozo, (u,v) = 00, 01, 10 y 11, y el borde u = 1 del segundo.
enum { ESQUINA_00, ESQUINA_01, ESQUINA_10, ESQUINA_11, FINAL_0, FINAL_1, ESQUINAS };
const std::vector<glm::vec3> ESQUINAS_INICIALES = {{-1.5f, -0.5f, 1.4f}, {-1.5f, 0.1f, -1.4f},
                                                   {1.3f, -0.2f, 1.4f},  {1.3f, 0.4f, -1.4f},
                                                   {4.0f, 0.1f, 1.4f},   {4.0f, -0.4f, -1.4f}};

/// Arriba a la izquierda, las esquinas; a la derecha, sus tangentes en v; abajo, sus tangentes en u y las torsiones.
inline Geometria2<float> primerTrozo(const std::vector<glm::vec3> &e) {
    const glm::vec3 cero(0), torsion(0, 2.5f, 0);
    using Fila = Geometria<float>;
    return {Fila{e[ESQUINA_00], e[ESQUINA_01], glm::vec3(0, 2.2f, -2.4f), glm::vec3(0, -1.8f, -2.4f)},
            Fila{e[ESQUINA_10], e[ESQUINA_11], glm::vec3(0, 1.0f, -2.8f), glm::vec3(0, -1.0f, -2.8f)},
            Fila{glm::vec3(2.0f, 2.6f, 0), glm::vec3(2.0f, 2.2f, 0), cero, cero},
            Fila{glm::vec3(2.2f, -1.4f, 0), glm::vec3(2.2f, 0.6f, 0), torsion, torsion}};
}

/// Lo que coincide para que la unión sea G1: el borde entero, que es la segunda fila del primero y la primera del
/// segundo; y, salvo un factor k, las tangentes que la cruzan, que son la cuarta fila y la tercera, torsiones
/// incluidas.
inline Geometria2<float> segundoTrozo(const std::vector<glm::vec3> &e, float k) {
    const Geometria2<float> primero = primerTrozo(e);
    using Fila = Geometria<float>;
    Geometria2<float> G = {
        primero[1], Fila{e[FINAL_0], e[FINAL_1], glm::vec3(0, 2.2f, -2.4f), glm::vec3(0, -2.0f, -2.4f)},
        Fila{}, Fila{glm::vec3(1.6f, 1.5f, 0), glm::vec3(1.6f, -1.5f, 0), glm::vec3(0), glm::vec3(0)}};
    for (std::size_t j = 0; j < 4; ++j)
        G[2][j] = k * primero[3][j];
    return G;
}
