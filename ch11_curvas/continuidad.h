// Dos tramos de Hermite unidos con cada tipo de continuidad (§11.1.2). Sin OpenGL.
#pragma once
#include "curvas.h"

enum Continuidad { C0, G1, C1, C2, CONTINUIDADES };

const Geometria<float> PRIMER_TRAMO = {
    glm::vec3{-1.1f, 0.1f, 0}, {0, 0.45f, 0}, {0.6f, 1.9f, 0}, {1.4f, -1.2f, 0}};
const glm::vec3 FINAL(1.1f, -0.1f, 0);
const float FACTOR_G1 = 0.3f; // la tangente del segundo tramo, en veces la del primero

const int PERIODO = 4000,
          AL_EMPEZAR = 1900; // milisegundos: lo que tarda el recorrido, y por dónde va al empezar
const float RAPIDEZ_MAXIMA = 3, ACELERACION_MAXIMA = 10; // lo más alto de las gráficas
const float VELOCIDAD = 0.25f;                           // lo que mide la flecha, en veces la velocidad

/// El segundo tramo: empieza donde acaba el primero, y lo que sigue depende de lo que se exija.
inline Geometria<float> segundoTramo(Continuidad continuidad) {
    const glm::vec3 P4 = PRIMER_TRAMO[1], R4 = PRIMER_TRAMO[3], llegada(0.7f, 1.2f, 0);
    switch (continuidad) {
    case C0: return {P4, FINAL, {0.5f, 1.5f, 0}, {0.9f, -1.6f, 0}};
    case G1: return {P4, FINAL, FACTOR_G1 * R4, llegada};
    case C1: return {P4, FINAL, R4, llegada};
    default: // Q''(0) = 6(P4' − P1') − 4R1' − 2R4' ha de ser la segunda derivada con que acaba el primero
        return {P4, FINAL, R4,
                3.0f * (FINAL - P4) - 2.0f * R4 - 0.5f * cubica(Base::HERMITE, PRIMER_TRAMO, 1.0f, 2)};
    }
}

/// La derivada (0: el punto) en el parámetro de la trayectoria entera, de 0 a 2.
inline glm::vec3 recorrido(Continuidad continuidad, float u, int derivada = 0) {
    return u < 1 ? cubica(Base::HERMITE, PRIMER_TRAMO, u, derivada)
                 : cubica(Base::HERMITE, segundoTramo(continuidad), u - 1, derivada);
}
