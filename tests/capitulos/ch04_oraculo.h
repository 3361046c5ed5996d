// Lo que comparten las pruebas del capítulo 4: los paneles, lo que no se compara y los rótulos leídos de la imagen.
#pragma once
#include "colores.h"
#include "ejecuta.h"
#include "oraculo/oraculo.h"
#include "rotulos.h"
#include <cmath>
#include <string>

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

/// 0.58 + 0.42·N·L, la luz fija de los capítulos 3 y 4, con la normal exacta.
inline double luzExacta(const oraculo::Vec3 &normal) {
    return 0.58 + 0.42 * oraculo::escalar(normal, {0.20, 0.78, 0.593});
}

/// Distancia de un rótulo que está una sola vez a un punto de la imagen, en alturas de la ventana; infinita si no está.
inline double distanciaRotulo(const Imagen &imagen, const std::u32string &texto, const glm::vec3 &color,
                              double x, double y, double talla = TALLA_ROTULO) {
    const int celda = celdaDe(imagen.ancho, imagen.alto, talla);
    return glm::distance(rotuloJunto(imagen, texto, color, celda, {x, y}, 3), {x, y}) / imagen.alto;
}
