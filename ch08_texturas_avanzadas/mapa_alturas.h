// El mapa de desplazamiento de desplazamiento.cpp: una isla de ruido. Sin OpenGL.
#pragma once
#include "ruido.h"
#include <vector>

/// Texels de lado: uno por vértice de una rejilla de LADO_MAPA − 1 cuadrados.
const int LADO_MAPA = 193;

/// Altura, de 0 a 1, en (s, t): montañas en el centro que bajan hasta 0 antes de llegar al borde.
inline float alturaIsla(const glm::vec2 &st) {
    const float r = 2.1f * glm::length(st - 0.5f);
    const float isla = glm::smoothstep(0.0f, 1.0f, 1 - r);
    const float monte = 0.62f + 0.75f * turbulencia(glm::vec3(5.0f * st, 2.5f), 6);
    return glm::clamp(isla * monte, 0.0f, 1.0f);
}

/// Las alturas por filas, desde t = 0: el texel (i, j) es la del punto (i, j) / (LADO_MAPA − 1).
inline std::vector<float> mapaAlturas() {
    std::vector<float> alturas;
    for (int j = 0; j < LADO_MAPA; ++j)
        for (int i = 0; i < LADO_MAPA; ++i)
            alturas.push_back(alturaIsla(glm::vec2(i, j) / float(LADO_MAPA - 1)));
    return alturas;
}
