// Lo que comparten las pruebas del capítulo 9: imágenes de prueba y la comparación, píxel a píxel, con lo que se calcula en la
// CPU en doble precisión, en niveles de 0 a 255.
#pragma once
#include "ejecuta.h"
#include "oraculo/algebra.h"
#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>

using oraculo::Vec3;
using Texel = std::function<Pixel(int x, int y)>; // y desde abajo, como t

inline Imagen imagen(int ancho, int alto, const Texel &texel) {
    Imagen i{ancho, alto, {}};
    for (int y = 0; y < alto; ++y)
        for (int x = 0; x < ancho; ++x) {
            const Pixel p = texel(x, y);
            for (const int k : {p.r, p.g, p.b})
                i.rgb.push_back(static_cast<unsigned char>(k));
        }
    return i;
}
/// Colores que no se parecen entre vecinos, con todos los valores de 0 a 255.
inline Imagen alAzar(int ancho, int alto, unsigned semilla = 1) {
    return imagen(ancho, alto, [semilla](int x, int y) {
        unsigned h = static_cast<unsigned>(x) * 2654435761u ^ static_cast<unsigned>(y) * 2246822519u ^
                     semilla * 3266489917u;
        h = (h ^ h >> 15) * 0x2C1B3C6Du;
        h = (h ^ h >> 12) * 0x297A2D39u;
        h ^= h >> 15;
        return Pixel{static_cast<int>(h >> 24), static_cast<int>(h >> 16 & 255),
                     static_cast<int>(h >> 8 & 255)};
    });
}
/// El fichero, escrito sin pasar por common/: la fila de arriba, primero.
inline std::string escribe(const Imagen &i, bool conCabecera = true) {
    static int n = 0;
    const std::string ruta =
        (carpetaTemporal() / ("ch09_" + std::to_string(++n) + (conCabecera ? ".ppm" : ".rgb"))).string();
    std::ofstream f(ruta, std::ios::binary);
    if (conCabecera)
        f << "P6\n" << i.ancho << " " << i.alto << "\n255\n";
    for (int y = i.alto - 1; y >= 0; --y)
        f.write(reinterpret_cast<const char *>(&i.rgb[static_cast<std::size_t>(3 * i.ancho * y)]),
                3 * i.ancho);
    return ruta;
}
/// El texel (x, y); fuera de la imagen, el del borde.
inline Vec3 texel(const Imagen &i, int x, int y) {
    const Pixel p = pixel(i, std::clamp(x, 0, i.ancho - 1), std::clamp(y, 0, i.alto - 1));
    return {double(p.r), double(p.g), double(p.b)};
}
/// El punto (x, y), en texels, con el filtro lineal: el centro del texel (i, j) es (i + 0.5, j + 0.5).
inline Vec3 bilineal(const Imagen &im, double x, double y) {
    const double i = std::floor(x - 0.5), j = std::floor(y - 0.5), a = x - 0.5 - i, b = y - 0.5 - j;
    const int I = static_cast<int>(i), J = static_cast<int>(j);
    return (1 - b) * ((1 - a) * texel(im, I, J) + a * texel(im, I + 1, J)) +
           b * ((1 - a) * texel(im, I, J + 1) + a * texel(im, I + 1, J + 1));
}

/// Programa del capítulo con esas imágenes, en una ventana del tamaño de la primera.
inline Imagen procesa(const std::string &programa, const std::vector<Imagen> &imagenes,
                      const std::string &guion = "") {
    std::vector<std::string> argumentos;
    for (const Imagen &i : imagenes)
        argumentos.push_back(escribe(i));
    const Ejecucion e =
        ejecuta("ch09_imagen/" + programa, guion, imagenes[0].ancho, imagenes[0].alto, argumentos);
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_EQ(e.errores, "");
    EXPECT_EQ(e.imagen.ancho, imagenes[0].ancho);
    EXPECT_EQ(e.imagen.alto, imagenes[0].alto);
    return e.imagen;
}
/// La mayor diferencia con `esperado(x, y)`, recortado a [0, 255], en niveles.
using Esperado = std::function<Vec3(int x, int y)>;
inline double diferenciaMaxima(const Imagen &obtenida, const Esperado &esperado) {
    double maxima = obtenida.rgb.empty() ? 999 : 0, suma = 0;
    for (int y = 0; y < obtenida.alto; ++y)
        for (int x = 0; x < obtenida.ancho; ++x) {
            const Pixel p = pixel(obtenida, x, y);
            const Vec3 c = esperado(x, y);
            for (const auto &[a, b] : {std::pair(double(p.r), c.x), {p.g, c.y}, {p.b, c.z}}) {
                const double d = std::fabs(a - std::clamp(b, 0.0, 255.0));
                maxima = std::max(maxima, d);
                suma += d * d;
            }
        }
    apuntaDiferencia(maxima, std::sqrt(suma / static_cast<double>(obtenida.rgb.size())));
    return maxima;
}
/// Como Esperado, sin más, un texel de otra imagen.
inline Esperado igualQue(const Imagen &i) {
    return [&i](int x, int y) { return texel(i, x, y); };
}
inline std::string repite(const std::string &orden, int veces) {
    std::string guion;
    for (int i = 0; i < veces; ++i)
        guion += (guion.empty() ? "" : "; ") + orden;
    return guion;
}
