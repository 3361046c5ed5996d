// Buscar un rótulo en una imagen, letra a letra (common/letra.h).
#pragma once
#include "imagen.h"
#include "letra.h"
#include <glm/glm.hpp>
#include <string>
#include <vector>

/// Los centros (píxeles desde abajo a la izquierda) de los sitios en que está esa línea, de ese color y con letras de cuadrados de
/// `celda` píxeles.
inline std::vector<glm::ivec2> buscaRotulo(const Imagen &imagen, const std::u32string &texto,
                                           const glm::vec3 &color, int celda) {
    const glm::ivec3 buscado(255.0f * color + 0.5f);
    const auto es = [&](int x, int y) {
        const unsigned char *p = &imagen.rgb[3 * static_cast<std::size_t>(y * imagen.ancho + x)];
        const glm::ivec3 d = glm::abs(glm::ivec3(p[0], p[1], p[2]) - buscado);
        return d.r <= 1 && d.g <= 1 && d.b <= 1;
    };
    const int n = static_cast<int>(texto.size()), ancho = (6 * n - 1) * celda, alto = 7 * celda;
    const auto encendido = [&](int columna, int fila) { // del rótulo, con los huecos entre letras
        const int i = columna / 6, k = columna % 6;
        return columna >= 0 && columna < 6 * n && fila >= 0 && fila < 7 && k < 5 &&
               texto[static_cast<std::size_t>(i)] != U' ' &&
               (LETRA.at(texto[static_cast<std::size_t>(i)])[static_cast<std::size_t>(fila)] >> (4 - k) &
                1) != 0;
    };
    // De cada cuadrado encendido, dos esquinas; y por donde linda con uno apagado, el halo.
    const auto esta = [&](int x0, int y0) {
        for (int fila = 0; fila < 7; ++fila)
            for (int columna = 0; columna < 6 * n; ++columna) {
                if (!encendido(columna, fila))
                    continue;
                const int x = x0 + columna * celda, y = y0 + (6 - fila) * celda, m = celda / 2;
                if (!es(x, y) || !es(x + celda - 1, y + celda - 1) ||
                    (!encendido(columna - 1, fila) && es(x - 1, y + m)) ||
                    (!encendido(columna + 1, fila) && es(x + celda, y + m)) ||
                    (!encendido(columna, fila - 1) && es(x + m, y + celda)) ||
                    (!encendido(columna, fila + 1) && es(x + m, y - 1)))
                    return false;
            }
        return true;
    };
    std::vector<glm::ivec2> sitios;
    for (int y = 1; y + alto < imagen.alto; ++y)
        for (int x = 1; x + ancho < imagen.ancho; ++x)
            if (esta(x, y))
                sitios.push_back({x + ancho / 2, y + alto / 2});
    return sitios;
}

/// El más cercano a un punto; muy lejos si no hay ninguno.
inline glm::ivec2 rotuloJunto(const Imagen &imagen, const std::u32string &texto, const glm::vec3 &color,
                              int celda, const glm::dvec2 &punto) {
    glm::ivec2 mejor(-10000);
    for (const glm::ivec2 &s : buscaRotulo(imagen, texto, color, celda))
        if (glm::distance(glm::dvec2(s), punto) < glm::distance(glm::dvec2(mejor), punto))
            mejor = s;
    return mejor;
}

inline std::u32string enLetras(int n) {
    const std::string s = std::to_string(n);
    return {s.begin(), s.end()};
}
