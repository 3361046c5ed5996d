// Lo que comparten las pruebas del capítulo 4: los paneles, lo que no se compara y los rótulos leídos de la imagen.
#pragma once
#include "colores.h"
#include "ejecuta.h"
#include "letra.h"
#include "oraculo/oraculo.h"
#include <cmath>
#include <string>

const double TALLA_NORMAL = 0.04; // TALLA_ROTULO

/// Esquina y tamaño de un panel, en píxeles desde abajo a la izquierda.
struct Hueco {
    int x, y, ancho, alto;
};

/// El panel (columna, fila contada desde arriba) de una rejilla que llena la ventana con rayas de una 180ª parte de su alto útil.
inline Hueco hueco(int columna, int columnas, int fila, int filas, int ancho, int alto) {
    const double util = std::min(alto, 3 * ancho / 4);
    const int raya = std::max(static_cast<int>(util / 180), 1), f = filas - 1 - fila;
    const auto corte = [raya](int i, int n, int largo) { return i * (largo + raya) / n; };
    const int x = corte(columna, columnas, ancho), y = corte(f, filas, alto);
    return {x, y, corte(columna + 1, columnas, ancho) - raya - x, corte(f + 1, filas, alto) - raya - y};
}

inline Imagen recorta(const Imagen &imagen, const Hueco &h) {
    return oraculo::recorta(imagen, h.x, h.y, h.ancho, h.alto);
}

/// Da por buenos los píxeles que cumplen `sobra(x, y)`: lo que otra prueba mira (rótulos y trazos).
template<class Sobra>
void daPorBuenos(oraculo::ImagenRef &ref, const Imagen &imagen, Sobra sobra) {
    for (int y = 0; y < ref.alto; ++y)
        for (int x = 0; x < ref.ancho; ++x)
            if (sobra(x, y)) {
                const Pixel p = pixel(imagen, x, y);
                ref.pixeles[static_cast<std::size_t>(y * ref.ancho + x)] = {
                    {p.r / 255.0, p.g / 255.0, p.b / 255.0}, -2, 0, 0, {}, {}};
            }
}

inline oraculo::Vec3 vec3De(const glm::vec3 &v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}
inline bool es(const Pixel &p, const glm::vec3 &color) {
    const auto byte = [](float c) { return static_cast<int>(std::lround(255 * c)); };
    return std::abs(p.r - byte(color.r)) <= 1 && std::abs(p.g - byte(color.g)) <= 1 &&
           std::abs(p.b - byte(color.b)) <= 1;
}

/// 0.58 + 0.42·N·L, la luz fija de los capítulos 3 y 4, con la normal exacta.
inline double luzExacta(const oraculo::Vec3 &normal) {
    return 0.58 + 0.42 * oraculo::escalar(normal, {0.20, 0.78, 0.593});
}

/// Centros de los rótulos de ese texto (una línea) y ese color que hay en la imagen: donde cada cuadrado de cada letra es del
/// color y los huecos, salvo algún trazo del mismo color que pase por detrás, no lo son.
inline std::vector<oraculo::Vec2> buscaRotulo(const Imagen &imagen, const std::u32string &texto,
                                              const glm::vec3 &color, double talla = TALLA_NORMAL) {
    const double util = std::min(imagen.alto, 3 * imagen.ancho / 4);
    const int celda = std::max(static_cast<int>(std::lround(talla * util / 7)), 1);
    const int ancho = (6 * static_cast<int>(texto.size()) - 1) * celda, alto = 7 * celda;
    const auto esta = [&](int x0, int y0) {
        for (std::size_t letra = 0; letra < texto.size(); ++letra) {
            if (texto[letra] == U' ')
                continue;
            const auto &filas = LETRA.at(texto[letra]);
            int sobran = 0;
            for (int fila = 0; fila < 7; ++fila)
                for (int columna = 0; columna < 5; ++columna) {
                    const int x = x0 + (6 * static_cast<int>(letra) + columna) * celda + celda / 2,
                              y = y0 + alto - 1 - fila * celda - celda / 2;
                    const bool esColor = es(pixel(imagen, x, y), color);
                    const bool encendido = filas[static_cast<std::size_t>(fila)] >> (4 - columna) & 1;
                    if (encendido && !esColor)
                        return false;
                    sobran += !encendido && esColor;
                }
            if (sobran > 3)
                return false;
        }
        return true;
    };
    std::vector<oraculo::Vec2> centros;
    for (int y = 0; y + alto <= imagen.alto; ++y)
        for (int x = 0; x + ancho <= imagen.ancho; ++x)
            if (esta(x, y)) {
                const oraculo::Vec2 c{x + 0.5 * ancho, y + 0.5 * alto};
                bool nuevo = true;
                for (const oraculo::Vec2 &otro : centros)
                    nuevo = nuevo && std::hypot(c.x - otro.x, c.y - otro.y) > 2 * celda;
                if (nuevo)
                    centros.push_back(c);
            }
    return centros;
}

/// Distancia de un rótulo que está una sola vez a un punto de la imagen, en alturas de la ventana; infinita si no está.
inline double distanciaRotulo(const Imagen &imagen, const std::u32string &texto, const glm::vec3 &color,
                              double x, double y, double talla = TALLA_NORMAL) {
    double menor = INFINITY;
    for (const oraculo::Vec2 &c : buscaRotulo(imagen, texto, color, talla))
        menor = std::min(menor, std::hypot(c.x - x, c.y - y) / imagen.alto);
    return menor;
}
