// La simetría respecto a un plano (ecuación 7.3). Sin OpenGL.
#pragma once
#include "error.h"
#include <cmath>
#include <glm/glm.hpp>

/// Plano N·x + d = 0, con N unitaria.
struct Plano {
    glm::vec3 N;
    float d;
};

/// El plano que pasa por P con perpendicular V, que no tiene que ser unitaria. El libro no dice que V haya de serlo:
/// con |V| = 2 su ecuación 7.3 no es una simetría. Si V es nula o no es finita, termina.
inline Plano planoPor(const glm::vec3 &P, const glm::vec3 &V) {
    const double longitud = glm::length(glm::dvec3(V)); // en doble no se desborda
    if (!(longitud > 0) || !std::isfinite(longitud))
        falla("un plano necesita una perpendicular que no sea nula");
    const glm::dvec3 N = glm::dvec3(V) / longitud;
    return {glm::vec3(N), float(-glm::dot(N, glm::dvec3(P)))};
}

/// Distancia con signo de un punto al plano: positiva en el lado al que mira N.
inline float distancia(const Plano &plano, const glm::vec3 &punto) {
    return glm::dot(plano.N, punto) + plano.d;
}

/// Simetría respecto al plano, ecuación 7.3. Su determinante es −1: la figura reflejada gira al revés, y sus caras de
/// delante son las de sentido horario.
inline glm::mat4 reflexion(const Plano &plano) {
    const glm::vec3 V = plano.N;
    return {{1 - 2 * V.x * V.x, -2 * V.x * V.y, -2 * V.x * V.z, 0},
            {-2 * V.x * V.y, 1 - 2 * V.y * V.y, -2 * V.y * V.z, 0},
            {-2 * V.x * V.z, -2 * V.y * V.z, 1 - 2 * V.z * V.z, 0},
            {-2 * plano.d * V, 1}}; // P·V = −d
}
