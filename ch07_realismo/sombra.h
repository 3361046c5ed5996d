// La proyección de una sombra sobre un plano (ecuación 7.4). Sin OpenGL.
#pragma once
#include "reflexion.h"

/// Altura de la luz sobre el plano: N·L + d·w. Con L.w = 0 (una luz en el infinito), el coseno con la perpendicular.
inline float alturaLuz(const glm::vec4 &L, const Plano &plano) {
    return glm::dot(plano.N, glm::vec3(L)) + plano.d * L.w;
}

/// Proyección desde la luz L sobre el plano, ecuación 7.4, que aquí vale también con L.w = 0. Un punto x queda con
/// w = alturaLuz − L.w·altura(x). Lo que está más alto que la luz tiene w < 0: si se dividiera por ella caería al otro
/// lado (la «antisombra»), pero OpenGL recorta antes de dividir y lo quita. La luz ha de estar del lado al que mira el
/// plano (alturaLuz > 0), y lo que da sombra también: si no, no hay sombra que dibujar.
inline glm::mat4 proyeccionSombra(const glm::vec4 &L, const Plano &plano) {
    const glm::vec4 p(plano.N, plano.d);
    return glm::mat4(alturaLuz(L, plano)) - glm::outerProduct(L, p);
}
