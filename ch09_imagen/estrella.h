// La escena de antialiasing: rayos finos con todas las inclinaciones, en coordenadas normalizadas del dispositivo de
// una ventana cuadrada. Sin OpenGL; la usan el programa y las pruebas, que calculan el área exacta que cubre en cada
// píxel.
#pragma once
#include "malla.h"
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

const int RAYOS = 24;
const double RADIO_DENTRO = 0.45, RADIO_FUERA = 0.95, SEMIANCHO = 0.035; // en unidades de medio lado

/// Tres vértices por rayo, que acaba en punta; ninguno se toca con otro.
inline std::vector<glm::dvec2> estrella() {
    std::vector<glm::dvec2> vertices;
    for (int i = 0; i < RAYOS; ++i) {
        const double a = 2 * 3.14159265358979323846 * (i + 0.3) / RAYOS;
        const glm::dvec2 d(std::cos(a), std::sin(a));
        const glm::dvec2 n(-d.y, d.x);
        vertices.insert(vertices.end(), {RADIO_DENTRO * d - SEMIANCHO * n, RADIO_FUERA * d,
                                         RADIO_DENTRO * d + SEMIANCHO * n});
    }
    return vertices;
}

inline Malla mallaEstrella() {
    Malla malla;
    for (const glm::dvec2 &v : estrella()) {
        malla.indices.push_back(unsigned(malla.vertices.size()));
        malla.vertices.push_back({glm::vec3(v, 0), {0, 0, 1}, {}});
    }
    return malla;
}
