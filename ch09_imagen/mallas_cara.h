// Las mallas de morphing: en cada imagen, los mismos puntos sobre los mismos rasgos. Sin OpenGL.
#pragma once
#include "malla_imagen.h"
#include <vector>

/// Los rasgos de una cara: los ojos y el eje; barbilla, boca, nariz, ojos, frente y coronilla. Por la segunda columna,
/// y su simétrica, baja el contorno de la cabeza, que al final sube a `oreja`, la base de la oreja por dentro: así va
/// el pelo de una a las orejas del otro y no se ve ninguno de los dos fuera de su sitio.
inline MallaImagen creaMallaCara(float ojo, const std::vector<float> &alturas,
                                 const std::vector<glm::vec2> &contorno, const glm::vec2 &oreja) {
    const float lado = contorno.back().x;
    MallaImagen m = creaMallaImagen({0, lado, ojo, 0.5f, 1 - ojo, 1 - lado, 1}, alturas);
    const auto pon = [&m](int columna, int fila, const glm::vec2 &p) {
        m.puntos[fila * m.columnas + columna] = p;
        m.puntos[(fila + 1) * m.columnas - 1 - columna] = {1 - p.x, p.y};
    };
    for (int fila = 1; fila < m.filas - 1; ++fila)
        pon(1, fila, contorno[fila - 1]);
    pon(2, m.filas - 2, oreja);
    return m;
}

/// Las de las dos caras de assets/ y, para las imágenes del usuario, una regular con los mismos puntos.
const MallaImagen CARA = creaMallaCara(
    0.406f, {0, 0.12f, 0.225f, 0.375f, 0.50f, 0.62f, 0.95f, 1},
    {{0.20f, 0.12f}, {0.15f, 0.225f}, {0.16f, 0.375f}, {0.219f, 0.5f}, {0.228f, 0.62f}, {0.29f, 0.806f}},
    {0.4f, 0.922f});
const MallaImagen GATO = creaMallaCara(
    0.369f, {0, 0.12f, 0.245f, 0.335f, 0.485f, 0.60f, 0.76f, 1},
    {{0.31f, 0.16f}, {0.268f, 0.245f}, {0.224f, 0.335f}, {0.21f, 0.485f}, {0.23f, 0.6f}, {0.235f, 0.93f}},
    {0.3875f, 0.735f});
const MallaImagen REGULAR = creaMallaImagen(repartidos(7), repartidos(8));
