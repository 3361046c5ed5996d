// Que cualquier malla llene la ventana, sean cuales sean sus unidades. Sin OpenGL; la usan malla_vf y tiras.
#pragma once
#include "orbita.h"
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

/// Los vértices llevados a la esfera de radio 1 centrada en el origen: su centro es el de la caja que los
/// envuelve.
inline std::vector<glm::vec3> encuadra(const std::vector<glm::vec3> &vertices) {
    glm::dvec3 minimo(vertices.at(0)), maximo(minimo);
    for (const glm::vec3 &v : vertices) {
        minimo = glm::min(minimo, glm::dvec3(v));
        maximo = glm::max(maximo, glm::dvec3(v));
    }
    const glm::dvec3 centro = (minimo + maximo) / 2.0;
    double radio = 0;
    for (const glm::vec3 &v : vertices)
        radio = std::max(radio, glm::length(glm::dvec3(v) - centro));
    std::vector<glm::vec3> encuadrados;
    for (const glm::vec3 &v : vertices)
        encuadrados.push_back((glm::dvec3(v) - centro) / (radio > 0 ? radio : 1.0));
    return encuadrados;
}

/// Distancia a la que la cámara, mirando al origen desde la dirección de `orbita`, ve todos los vértices con
/// un pequeño margen. `angulo` (radianes) y `aspecto` son los de perspectivaVentana.
inline float distanciaQueEncuadra(const std::vector<glm::vec3> &vertices, const Orbita &orbita, float angulo,
                                  float aspecto) {
    const float margen = 1.06f, t = std::tan(angulo / 2), tx = t * std::max(aspecto, 1.0f),
                ty = t * std::max(1 / aspecto, 1.0f);
    const glm::mat3 giro(camaraOrbita(orbita)); // a ejes de la cámara: derecha, arriba y hacia quien mira
    float distancia = 1.2f; // la malla cabe en la esfera de radio 1: al orbitar no llega a la cámara
    for (const glm::vec3 &v : vertices) {
        const glm::vec3 p = margen * (giro * v);
        distancia = std::max({distancia, p.z + std::fabs(p.x) / tx, p.z + std::fabs(p.y) / ty});
    }
    return distancia;
}
