// El número de un objeto escrito como color (§10.3): 24 bits, y con el 0 para lo que no se elige, 2²⁴ − 1 objetos.
// Sin OpenGL.
#pragma once
#include "error.h"
#include <array>
#include <glm/glm.hpp>
#include <string>

using Rgb = std::array<unsigned char, 3>; // como se leen de un framebuffer de 8 bits por componente

const unsigned NADA = 0, IDENTIFICADOR_MAXIMO = (1u << 24) - 1;

/// Los números seguidos, tal cual, son colores que no se distinguen: del 1 al 9, nueve casi negros. Multiplicarlos por
/// uno impar, módulo 2²⁴, los reparte sin repetir ninguno y deja el 0 de negro; multiplicar por su inverso lo deshace.
const unsigned REPARTE = 0xC66E35, RECOGE = 0xEFF41D;
static_assert((REPARTE * RECOGE & IDENTIFICADOR_MAXIMO) == 1);

inline Rgb rgbDe(unsigned identificador) {
    if (identificador > IDENTIFICADOR_MAXIMO)
        falla("el identificador " + std::to_string(identificador) + " no cabe en 24 bits");
    const unsigned n = identificador * REPARTE;
    const auto byte = [n](int cual) { return static_cast<unsigned char>(n >> 8 * cual & 255); };
    return {byte(0), byte(1), byte(2)};
}

inline unsigned identificadorDe(const Rgb &rgb) {
    return (rgb[0] | unsigned(rgb[1]) << 8 | unsigned(rgb[2]) << 16) * RECOGE & IDENTIFICADOR_MAXIMO;
}

/// El color con que pintarlo: k/255 se guarda en 8 bits como k, exacto.
inline glm::vec3 colorDe(unsigned identificador) {
    const Rgb rgb = rgbDe(identificador);
    return glm::vec3(rgb[0], rgb[1], rgb[2]) / 255.0f;
}
