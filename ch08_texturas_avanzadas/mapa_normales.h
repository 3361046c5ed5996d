// El bulto de bump.cpp y su mapa de normales. Sin OpenGL.
#pragma once
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

/// Radio y altura del bulto, en lados del mapa.
const float RADIO_BULTO = 0.42f, ALTO_BULTO = 0.15f;

/// Derivadas (∂h/∂s, ∂h/∂t) de la altura en (s, t): h = ALTO·(1 − r²)², donde r es la distancia al centro del mapa en
/// radios del bulto; 0 fuera. El borde del mapa es llano: al repetirlo no hay costura, y en un polo no hay pico.
inline glm::vec2 pendienteBulto(const glm::vec2 &st) {
    const glm::vec2 d = (st - 0.5f) / RADIO_BULTO;
    const float queda = 1 - glm::dot(d, d);
    return queda > 0 ? d * (-4 * ALTO_BULTO / RADIO_BULTO * queda) : glm::vec2(0);
}

/// La normal de la superficie (s, t, h), de −1 a 1 guardada de 0 a 255 en cada texel de lado × lado. Lo llano es
/// (0, 0, 1), y por eso un mapa de normales se ve azul.
inline std::vector<unsigned char> mapaNormales(int lado) {
    std::vector<unsigned char> rgb;
    for (int y = 0; y < lado; ++y)
        for (int x = 0; x < lado; ++x) {
            const glm::vec2 pendiente = pendienteBulto((glm::vec2(x, y) + 0.5f) / float(lado));
            const glm::vec3 n = glm::normalize(glm::vec3(-pendiente, 1));
            for (int k = 0; k < 3; ++k)
                rgb.push_back(static_cast<unsigned char>(std::lround(127.5f * (n[k] + 1))));
        }
    return rgb;
}
