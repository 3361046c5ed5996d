// Las partículas de las figuras 12.1 y 12.2: cuadrados en una rejilla, y de cada uno, los instantes al azar en que nace
// y muere. Van todas en un buffer object, y el vertex shader decide en qué estado está cada una. Sin OpenGL.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

const double PERIODO_PIEZAS = 10; // segundos: al acabar, todo vuelve a empezar
const double INICIO = 2;          // al abrir el programa ya han nacido unas cuantas
const float NACEN = 3.5f, MUEREN = 6,
            MUEREN_ANTES = 9.5f; // nacen en [0, NACEN) y mueren en [MUEREN, MUEREN_ANTES)

/// Lo que les pasa en el instante t, de 0 a PERIODO_PIEZAS.
inline const char *etapa(float t) {
    if (t < NACEN)
        return "nacen";
    if (t < MUEREN)
        return "viven";
    return t < MUEREN_ANTES ? "mueren" : "no queda ninguna";
}

struct VerticePieza {
    glm::vec2 celda;   // columna y fila
    glm::vec2 esquina; // del cuadrado, de −1 a 1
    glm::vec2 vida;    // instantes en que nace y en que muere
};

/// De 0 a 1; el mismo con el mismo número.
inline float azar(std::uint32_t n) {
    n = (n ^ (n >> 16)) * 0x7feb352du;
    n = (n ^ (n >> 15)) * 0x846ca68bu;
    n ^= n >> 16;
    return float(n >> 8) / 16777216.0f;
}

/// Seis vértices (dos triángulos) por pieza, por filas.
inline std::vector<VerticePieza> creaPiezas(int columnas, int filas) {
    const glm::vec2 esquinas[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};
    std::vector<VerticePieza> vertices;
    for (int i = 0; i < columnas * filas; ++i) {
        const std::uint32_t n = 2 * std::uint32_t(i);
        const glm::vec2 celda(i % columnas, i / columnas),
            vida(NACEN * azar(n), glm::mix(MUEREN, MUEREN_ANTES, azar(n + 1)));
        for (const glm::vec2 &esquina : esquinas)
            vertices.push_back({celda, esquina, vida});
    }
    return vertices;
}
