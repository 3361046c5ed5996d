// El ruido que guarda la textura 3D de textura3d.cpp. Sin OpenGL.
#pragma once
#include "imagen.h"
#include "ruido.h"
#include <vector>

const int LADO_TEXTURA = 64, CELDAS = 4, OCTAVAS = 3; // la celda más pequeña mide cuatro texeles

/// LADO_TEXTURA³ bytes: la turbulencia, de 0 a 255, en el centro de cada texel. Su periodo es el de la textura, que con
/// GL_REPEAT no tiene costura.
inline std::vector<unsigned char> texelsRuido() {
    std::vector<unsigned char> texels;
    texels.reserve(LADO_TEXTURA * LADO_TEXTURA * LADO_TEXTURA);
    for (int z = 0; z < LADO_TEXTURA; ++z)
        for (int y = 0; y < LADO_TEXTURA; ++y)
            for (int x = 0; x < LADO_TEXTURA; ++x) {
                const glm::vec3 p = (glm::vec3(x, y, z) + 0.5f) * (float(CELDAS) / LADO_TEXTURA);
                texels.push_back(enOchoBits(0.5f + 0.5f * turbulencia(p, OCTAVAS, glm::ivec3(CELDAS))));
            }
    return texels;
}
