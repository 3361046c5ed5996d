// Buscar un rótulo en una imagen, letra a letra (common/letra.h).
#pragma once
#include "imagen.h"
#include "letra.h"
#include <glm/glm.hpp>
#include <string>
#include <vector>

/// Los centros (píxeles desde abajo a la izquierda) de los sitios en que está esa línea, de ese color y con letras de cuadrados de
/// `celda` píxeles: los encendidos son del color y los apagados no.
inline std::vector<glm::ivec2> buscaRotulo(const Imagen &imagen, const std::u32string &texto,
                                           const glm::vec3 &color, int celda) {
    const glm::ivec3 buscado(255.0f * color + 0.5f);
    const auto es = [&](int x, int y) {
        const unsigned char *p = &imagen.rgb[3 * static_cast<std::size_t>(y * imagen.ancho + x)];
        const glm::ivec3 d = glm::abs(glm::ivec3(p[0], p[1], p[2]) - buscado);
        return d.r <= 1 && d.g <= 1 && d.b <= 1;
    };
    const int ancho = (6 * static_cast<int>(texto.size()) - 1) * celda, alto = 7 * celda;
    const auto esta = [&](int x0, int y0) {
        for (std::size_t i = 0; i < texto.size(); ++i) {
            if (texto[i] == U' ')
                continue;
            const auto &filas = LETRA.at(texto[i]);
            for (int f = 0; f < 7; ++f)
                for (int k = 0; k < 5; ++k) {
                    const int x = x0 + (6 * static_cast<int>(i) + k) * celda, y = y0 + (6 - f) * celda;
                    const bool encendido = filas[static_cast<std::size_t>(f)] >> (4 - k) & 1;
                    // de un cuadrado encendido, dos esquinas: el sitio es exacto
                    if (encendido ? !es(x, y) || !es(x + celda - 1, y + celda - 1)
                                  : es(x + celda / 2, y + celda / 2))
                        return false;
                }
        }
        return true;
    };
    std::vector<glm::ivec2> sitios;
    for (int y = 0; y + alto <= imagen.alto; ++y)
        for (int x = 0; x + ancho <= imagen.ancho; ++x)
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
