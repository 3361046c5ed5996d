// Que cualquier malla llene la ventana, sean cuales sean sus unidades, los números de sus vértices y las líneas de sus
// aristas. Lo usan malla_vf y tiras.
#pragma once
#include "colores.h"
#include "orbita.h"
#include "rotulo.h"
#include <GL/glew.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

/// Las mallas con más vértices o caras no llevan números: no se leerían.
const std::size_t MAXIMO_NUMERADO = 40;

/// Los vértices llevados a la esfera de radio 1 centrada en el origen: su centro es el de la caja que los
/// envuelve.
inline std::vector<glm::vec3> encuadra(const std::vector<glm::vec3> &vertices) {
    glm::dvec3 minimo(vertices.at(0));
    glm::dvec3 maximo(minimo);
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

/// Distancia a la que la cámara, mirando al origen desde la dirección de `orbita`, ve a 4:3 todos los vértices con
/// margen para sus números. `angulo` (radianes) es el de perspectivaVentana.
inline float distanciaQueEncuadra(const std::vector<glm::vec3> &vertices, const Orbita &orbita,
                                  float angulo) {
    const float margen = 1.22f, ty = std::tan(angulo / 2);
    const float tx = ty * 4 / 3;
    const glm::mat3 giro(camaraOrbita(orbita)); // a ejes de la cámara: derecha, arriba y hacia quien mira
    float distancia = 1.3f; // la malla cabe en la esfera de radio 1: al orbitar no llega a la cámara
    for (const glm::vec3 &v : vertices) {
        const glm::vec3 p = margen * (giro * v);
        distancia = std::max({distancia, p.z + std::fabs(p.x) / tx, p.z + std::fabs(p.y) / ty});
    }
    return distancia;
}

using IndicesTriangulo = std::array<std::uint32_t, 3>;

/// Deja en el z-buffer las caras algo más lejos, para que no tapen la mitad de las líneas que van por sus lados. No se
/// pueden pintar ya así: cuanto más de canto está una, más se aleja, y junto a su lado asomaría la de detrás.
template<class DibujaCaras>
void alejaEnProfundidad(DibujaCaras dibujaCaras) {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(4, 1);
    dibujaCaras();
    glDisable(GL_POLYGON_OFFSET_FILL);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

/// Si desde el ojo se ve el punto, o lo tapa algún triángulo: dónde corta cada uno a la recta que los une.
inline bool seVe(const glm::vec3 &punto, const glm::vec3 &ojo, const std::vector<glm::vec3> &vertices,
                 const std::vector<IndicesTriangulo> &triangulos) {
    return std::none_of(triangulos.begin(), triangulos.end(), [&](const IndicesTriangulo &t) {
        // a + s(b − a) + t(c − a) = ojo + r(punto − ojo)
        const glm::vec3 &a = vertices[t[0]], &b = vertices[t[1]], &c = vertices[t[2]];
        const glm::mat3 sistema(b - a, c - a, ojo - punto);
        if (std::fabs(glm::determinant(sistema)) < 1e-9f)
            return false; // se ve de canto
        const glm::vec3 str = glm::inverse(sistema) * (ojo - a);
        return str.s >= 0 && str.t >= 0 && str.s + str.t <= 1 && str.p > 0 && str.p < 0.999f;
    });
}

/// El número de cada vértice que se ve, desde el 1 como en el fichero, por fuera de la malla.
inline void rotulaVertices(const std::vector<glm::vec3> &vertices,
                           const std::vector<IndicesTriangulo> &triangulos, const glm::vec3 &ojo,
                           const glm::mat4 &transformacion) {
    if (std::max(vertices.size(), triangulos.size()) > MAXIMO_NUMERADO)
        return;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (!seVe(vertices[i], ojo, vertices, triangulos))
            continue;
        const glm::vec4 p =
            transformacion * glm::vec4(vertices[i], 1); // el centro de la malla está en x = y = 0
        const bool aLoAncho = std::fabs(p.x) > std::fabs(p.y);
        const Lado enX = p.x > 0 ? Lado::DERECHA : Lado::IZQUIERDA;
        const Lado enY = p.y > 0 ? Lado::ENCIMA : Lado::DEBAJO;
        rotulaPunto(std::to_string(i + 1), vertices[i], transformacion, OSCURO, aLoAncho ? enX : enY);
    }
}
