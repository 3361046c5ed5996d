// El número de un objeto escrito como color (§10.3): 24 bits, y con el 0 para lo que no se elige, 2²⁴ − 1 objetos.
// Sin OpenGL.
#pragma once
#include "error.h"
#include <array>
#include <glm/glm.hpp>
#include <string>

using Rgb = std::array<unsigned char, 3>; // como se leen de un framebuffer de 8 bits por componente

const unsigned NADA = 0, IDENTIFICADOR_MAXIMO = (1u << 24) - 1;

/// Los bits van, desde el menor, al rojo, al verde y al azul por turno, y en cada uno desde el de más valor: los
/// números seguidos dan colores que se distinguen también a la vista.
inline Rgb rgbDe(unsigned identificador) {
    if (identificador > IDENTIFICADOR_MAXIMO)
        falla("el identificador " + std::to_string(identificador) + " no cabe en 24 bits");
    Rgb rgb{};
    for (unsigned bit = 0; bit < 24; ++bit)
        rgb[bit % 3] = static_cast<unsigned char>(rgb[bit % 3] | (identificador >> bit & 1) << (7 - bit / 3));
    return rgb;
}

inline unsigned identificadorDe(const Rgb &rgb) {
    unsigned identificador = 0;
    for (unsigned bit = 0; bit < 24; ++bit)
        identificador |= (rgb[bit % 3] >> (7 - bit / 3) & 1u) << bit;
    return identificador;
}

/// El color con que pintarlo: k/255 se guarda en 8 bits como k, exacto.
inline glm::vec3 colorDe(unsigned identificador) {
    const Rgb rgb = rgbDe(identificador);
    return glm::vec3(rgb[0], rgb[1], rgb[2]) / 255.0f;
}
