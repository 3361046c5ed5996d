// La malla de puntos que deforma una imagen (§9.4): entre los puntos pasa una superficie suave (Catmull–Rom), sin los
// dobleces que dejarían sus triángulos. Las posiciones van de (0, 0), abajo a la izquierda, a (1, 1). Sin OpenGL; la
// usan warping y morphing.
#pragma once
#include "malla.h"
#include <algorithm>
#include <glm/glm.hpp>
#include <vector>

/// columnas × filas puntos, al menos 2 × 2, por filas desde abajo.
struct MallaImagen {
    int columnas, filas;
    std::vector<glm::vec2> puntos;
};

/// La malla de esas abscisas y ordenadas.
inline MallaImagen creaMallaImagen(const std::vector<float> &x, const std::vector<float> &y) {
    MallaImagen malla{int(x.size()), int(y.size()), {}};
    for (const float b : y)
        for (const float a : x)
            malla.puntos.push_back({a, b});
    return malla;
}

/// n números de 0 a 1, igual de separados.
inline std::vector<float> repartidos(int n) {
    std::vector<float> x;
    for (int i = 0; i < n; ++i)
        x.push_back(float(i) / float(n - 1));
    return x;
}

/// Un punto de la malla o, más allá del borde, el que sigue en línea recta: así la malla regular no se deforma.
inline glm::vec2 puntoOProlongado(const MallaImagen &m, int i, int j) {
    const auto en = [&m](int a, int b) { return m.puntos[b * m.columnas + a]; };
    const auto enFila = [&](int a, int b) {
        const int dentro = std::clamp(a, 0, m.columnas - 1);
        return a == dentro ? en(a, b) : 2.0f * en(dentro, b) - en(2 * dentro - a, b);
    };
    const int dentro = std::clamp(j, 0, m.filas - 1);
    return j == dentro ? enFila(i, j) : 2.0f * enFila(i, dentro) - enFila(i, 2 * dentro - j);
}

inline glm::vec2 catmullRom(const glm::vec2 (&p)[4], float t) {
    return p[1] + 0.5f * t *
                      (p[2] - p[0] +
                       t * (2.0f * p[0] - 5.0f * p[1] + 4.0f * p[2] - p[3] +
                            t * (3.0f * (p[1] - p[2]) + p[3] - p[0])));
}

/// El punto de la superficie a (u, v) pasos de la malla: con enteros, el punto (u, v).
inline glm::vec2 evalua(const MallaImagen &m, float u, float v) {
    const int i = std::clamp(int(u), 0, m.columnas - 2), j = std::clamp(int(v), 0, m.filas - 2);
    glm::vec2 columna[4];
    for (int b = 0; b < 4; ++b) {
        glm::vec2 fila[4];
        for (int a = 0; a < 4; ++a)
            fila[a] = puntoOProlongado(m, i + a - 1, j + b - 1);
        columna[b] = catmullRom(fila, u - float(i));
    }
    return catmullRom(columna, v - float(j));
}

/// Triángulos de dos mallas iguales de puntos: en `posicion` va la primera y en `coordTextura`, la segunda. Van de
/// abajo arriba y de izquierda a derecha: donde la malla se pliega se ve lo último, lo de la fila más alta y, en ella,
/// lo de más a la derecha.
inline Malla triangulaImagen(const MallaImagen &a, const MallaImagen &b) {
    const int TRAMOS = 8; // de un punto al siguiente
    const int columnas = TRAMOS * (a.columnas - 1), filas = TRAMOS * (a.filas - 1);
    Malla malla;
    for (int j = 0; j <= filas; ++j)
        for (int i = 0; i <= columnas; ++i) {
            const float u = float(i) / TRAMOS, v = float(j) / TRAMOS;
            malla.vertices.push_back({glm::vec3(evalua(a, u, v), 0), {0, 0, 1}, evalua(b, u, v)});
        }
    for (int j = 0; j < filas; ++j)
        for (int i = 0; i < columnas; ++i) {
            const unsigned k = j * (columnas + 1) + i;
            const unsigned arriba = k + columnas + 1;
            malla.indices.insert(malla.indices.end(), {k, k + 1, arriba + 1, k, arriba + 1, arriba});
        }
    return malla;
}

/// El punto más cercano a p; `talla`: la de la imagen, para medir en píxeles.
inline std::size_t nudoMasCercano(const MallaImagen &m, const glm::vec2 &p, const glm::vec2 &talla) {
    const auto distancia = [&](const glm::vec2 &q) { return glm::length((q - p) * talla); };
    return std::min_element(
               m.puntos.begin(), m.puntos.end(),
               [&](const glm::vec2 &q, const glm::vec2 &r) { return distancia(q) < distancia(r); }) -
           m.puntos.begin();
}
