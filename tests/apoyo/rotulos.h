// Leer en una imagen lo que dibuja common/rotulo.h: dónde está un texto, letra a letra (common/letra.h).
#pragma once
#include "ejecuta.h"
#include "letra.h"
#include "rotulo.h"
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <string>
#include <vector>

/// Rótulos y trazos no llevan luz: su color es el suyo, y un nivel por el redondeo.
inline bool esColor(const Pixel &p, const glm::vec3 &color) {
    const glm::ivec3 d = glm::abs(glm::ivec3(p.r, p.g, p.b) - glm::ivec3(255.0f * color + 0.5f));
    return d.r <= 1 && d.g <= 1 && d.b <= 1;
}
inline bool esColor(const Imagen &imagen, int x, int y, const glm::vec3 &color) {
    return x >= 0 && y >= 0 && x < imagen.ancho && y < imagen.alto && esColor(pixel(imagen, x, y), color);
}

/// Rectángulo de la tinta de un rótulo y su centro (x, y), en píxeles desde abajo a la izquierda; `celda` es el lado de los
/// cuadrados de sus letras.
struct Rotulo {
    int x0, y0, x1, y1, celda;
    double x, y;
    double lejosDe(double px, double py) const {
        return std::hypot(x - px, y - py);
    }
};

/// Lado (píxeles) de los cuadrados de las letras de una talla en una ventana, o panel de una, de ese tamaño.
inline int celdaDe(int ancho, int alto, double talla = TALLA_ROTULO) {
    return std::max(static_cast<int>(std::lround(talla * std::min(alto, 3 * ancho / 4) / 7)), 1);
}

inline std::u32string enLetras(const std::string &utf8) {
    std::u32string letras;
    for (const char c : utf8) {
        const unsigned char byte = static_cast<unsigned char>(c);
        if ((byte & 0xC0) == 0x80)
            letras.back() = letras.back() << 6 | (byte & 0x3Fu);
        else
            letras += byte < 0x80 ? byte : byte < 0xE0 ? byte & 0x1Fu : byte & 0x0Fu;
    }
    return letras;
}
inline std::u32string enLetras(int n) {
    return enLetras(std::to_string(n));
}

/// Dónde se lee ese texto, de una línea y de ese color: la tinta está toda y en los huecos de cada letra hay, de ese mismo color,
/// `sobran` cuadrados como mucho (por si un trazo pasa por detrás). `celda` 0: la de TALLA_ROTULO en la imagen entera.
inline std::vector<Rotulo> buscaRotulo(const Imagen &imagen, const std::u32string &texto,
                                       const glm::vec3 &color, int celda = 0, int sobran = 0) {
    const int lado = celda > 0 ? celda : celdaDe(imagen.ancho, imagen.alto);
    const int ancho = (6 * static_cast<int>(texto.size()) - 1) * lado, alto = 7 * lado;
    const auto esLetra = [&](char32_t letra, int x0, int y0) {
        int deMas = 0;
        for (int fila = 0; fila < 7; ++fila)
            for (int columna = 0; columna < 5; ++columna) {
                const int x = x0 + columna * lado, y = y0 + (6 - fila) * lado;
                const bool tinta = LETRA.at(letra)[static_cast<std::size_t>(fila)] >> (4 - columna) & 1,
                           pintado = esColor(imagen, x, y, color) &&
                                     esColor(imagen, x + lado - 1, y + lado - 1, color);
                if (tinta && !pintado)
                    return false;
                deMas += !tinta && pintado;
            }
        return deMas <= sobran;
    };
    std::vector<Rotulo> rotulos;
    for (int y = 0; y + alto <= imagen.alto; ++y)
        for (int x = 0; x + ancho <= imagen.ancho; ++x) {
            bool esta = true;
            for (std::size_t i = 0; esta && i < texto.size(); ++i)
                esta = texto[i] == U' ' || esLetra(texto[i], x + 6 * static_cast<int>(i) * lado, y);
            if (esta)
                rotulos.push_back({x, y, x + ancho - 1, y + alto - 1, lado, x + 0.5 * ancho, y + 0.5 * alto});
        }
    return rotulos;
}

/// Lo mismo, de cualquier tamaño.
inline std::vector<Rotulo> leeRotulo(const Imagen &imagen, const std::string &texto, const glm::vec3 &color) {
    std::vector<Rotulo> rotulos;
    for (int celda = 1; celda <= 8; ++celda)
        for (const Rotulo &r : buscaRotulo(imagen, enLetras(texto), color, celda))
            rotulos.push_back(r);
    return rotulos;
}

/// Si se lee el texto, de cualquier tamaño, con su centro a menos de `lejos` píxeles de (x, y).
inline bool seLee(const Imagen &imagen, const std::string &texto, const glm::vec3 &color, double x, double y,
                  double lejos) {
    const std::vector<Rotulo> rotulos = leeRotulo(imagen, texto, color);
    return std::any_of(rotulos.begin(), rotulos.end(),
                       [&](const Rotulo &r) { return r.lejosDe(x, y) < lejos; });
}

/// El centro del más cercano a un punto; en el infinito si no hay ninguno.
inline glm::dvec2 rotuloJunto(const Imagen &imagen, const std::u32string &texto, const glm::vec3 &color,
                              int celda, const glm::dvec2 &punto, int sobran = 0) {
    glm::dvec2 mejor(INFINITY);
    for (const Rotulo &r : buscaRotulo(imagen, texto, color, celda, sobran))
        if (!(glm::distance({r.x, r.y}, punto) >= glm::distance(mejor, punto)))
            mejor = {r.x, r.y};
    return mejor;
}
