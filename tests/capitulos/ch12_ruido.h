// La textura de ruido de los programas del capítulo 12, hecha otra vez según la definición del ruido.
#pragma once
#include "ch08_oraculo.h"
#include "imagenes.h"

struct TexturaDeRuido {
    Imagen imagen{64, 64, {}};

    TexturaDeRuido() {
        for (int i = 0; i < 64 * 64; ++i)
            for (int canal = 0; canal < 3; ++canal) { // tres cortes del mismo ruido, de 4×4 celdas
                const glm::dvec3 p((i % 64 + 0.5) / 16, (i / 64 + 0.5) / 16, canal + 0.5);
                imagen.rgb.push_back(enOchoBits(0.5 + 0.5 * definicion::ruido(p, {4, 4, 0})));
            }
    }
    /// Lo que se lee en (s, t), de 0 a 1 en cada canal: lineal y repetida.
    glm::dvec3 operator()(double s, double t) const {
        const oraculo::Vec3 c =
            bilineal(imagen, 64 * (s - std::floor(s)), 64 * (t - std::floor(t)), true, true);
        return glm::dvec3(c.x, c.y, c.z) / 255.0;
    }
};
