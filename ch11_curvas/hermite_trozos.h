// Las matrices de geometría de los dos trozos de superficie_hermite (ecuación 11.37, ejercicio 11.8). Sin OpenGL.
#pragma once
#include "superficies.h"

const float LARGO_FLECHA = 1 / 3.0f; // de una tangente: así acaba en el punto de control de Bézier

/// Los elementos que se dan: los 16 de la primera matriz y las filas segunda y cuarta de la segunda. De las columnas,
/// las dos primeras son esquinas y sus tangentes en u; las otras, las tangentes en v y las torsiones.
const std::vector<glm::vec3> ELEMENTOS_INICIALES = {
    {-1.5f, -0.5f, 1.4f}, {-1.5f, 0.1f, -1.4f}, {0, 2.2f, -2.4f}, {0, -1.8f, -2.4f}, //
    {1.3f, -0.2f, 1.4f},  {1.3f, 0.4f, -1.4f},  {0, 1.0f, -2.8f}, {0, -1.0f, -2.8f}, //
    {2.0f, 2.6f, 0},      {2.0f, 2.2f, 0},      {0, 1.6f, 0},     {0, 1.6f, 0},      //
    {2.2f, -1.4f, 0},     {2.2f, 0.6f, 0},      {0, 2.5f, 0},     {0, 2.5f, 0},      //
    {4.0f, 0.1f, 1.4f},   {4.0f, -0.4f, -1.4f}, {0, 2.2f, -2.4f}, {0, -2.0f, -2.4f}, //
    {1.6f, 1.5f, 0},      {1.6f, -1.5f, 0},     {0, -1.6f, 0},    {0, 1.6f, 0}};
const std::size_t DEL_PRIMERO = 16;

/// La esquina de la que sale el elemento; ella misma, si lo es.
inline std::size_t esquinaDe(std::size_t k) {
    return k < DEL_PRIMERO ? k / 4 % 2 * 4 + k % 2 : DEL_PRIMERO + k % 2;
}

/// Donde se dibuja y se arrastra cada elemento: una esquina, en su sitio, y un vector, en la punta de su flecha.
inline std::vector<glm::vec3> puntas(std::vector<glm::vec3> elementos) {
    for (std::size_t k = 0; k < elementos.size(); ++k)
        if (esquinaDe(k) != k)
            elementos[k] = elementos[esquinaDe(k)] + LARGO_FLECHA * elementos[k];
    return elementos;
}
/// Al revés.
inline std::vector<glm::vec3> elementosDe(const std::vector<glm::vec3> &puntas) {
    std::vector<glm::vec3> elementos = puntas;
    for (std::size_t k = 0; k < puntas.size(); ++k)
        if (esquinaDe(k) != k)
            elementos[k] = (puntas[k] - puntas[esquinaDe(k)]) / LARGO_FLECHA;
    return elementos;
}

/// Arriba a la izquierda, las esquinas; a la derecha, sus tangentes en v; abajo, sus tangentes en u y las torsiones.
inline Geometria2<float> primerTrozo(const std::vector<glm::vec3> &elementos) {
    Geometria2<float> G;
    for (std::size_t k = 0; k < DEL_PRIMERO; ++k) {
        // E11.8: el sitio del elemento k en la matriz de geometría, por filas
        G[k / 4][k % 4] = elementos[k];
        // de partida: G[k / 4][k % 4] = esquinaDe(k) == k ? elementos[k] : glm::vec3(0);
        // fin de E11.8
    }
    return G;
}

/// El segundo, que empieza donde acaba el primero. De los elementos, los cuatro siguientes son su segunda fila y los
/// cuatro últimos, la cuarta; con k se alarga lo que cruza la unión.
inline Geometria2<float> segundoTrozo(const std::vector<glm::vec3> &elementos, float k) {
    const Geometria2<float> primero = primerTrozo(elementos);
    Geometria2<float> G;
    for (std::size_t j = 0; j < 4; ++j) {
        // E11.8: la columna j, con lo que ha de coincidir con el primero para que la unión sea G1
        G[0][j] = primero[1][j]; // el borde entero
        G[1][j] = elementos[DEL_PRIMERO + j];
        G[2][j] = k * primero[3][j]; // las tangentes que lo cruzan, torsiones incluidas
        G[3][j] = elementos[DEL_PRIMERO + 4 + j];
        // de partida: G[0][j] = G[1][j] = primero[1][j];
        // de partida: G[2][j] = G[3][j] = k * glm::vec3(0);
        // fin de E11.8
    }
    return G;
}
