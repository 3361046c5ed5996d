// Uno o varios paneles, cada uno con una imagen: así son casi todos los programas del capítulo 9.
#pragma once
#include "colores.h"
#include "imagenes.h"
#include "oraculo/compara.h"

using oraculo::Vec3;

const double REDONDEO = 0.51; // a 8 bits; con números enteros, exacto

inline Vec3 absoluto(const Vec3 &v) {
    return {std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)};
}

struct Caso {
    std::vector<std::string> guiones; // dan lo mismo
    std::vector<Esperado> paneles;    // dos, uno al lado de otro; cuatro, de dos en dos
};

/// El programa con esas imágenes, en una ventana en que cada panel mide lo que la primera: así un texel es un píxel.
inline void compruebaPaneles(const std::string &programa, const std::vector<Imagen> &imagenes,
                             const std::vector<Caso> &casos, double cota = REDONDEO) {
    const int ancho = imagenes[0].ancho, alto = imagenes[0].alto;
    for (const auto &[guiones, paneles] : casos)
        for (const std::string &guion : guiones) {
            SCOPED_TRACE(programa + " «" + guion + "»");
            const int n = int(paneles.size()), columnas = n > 1 ? 2 : 1, filas = n / columnas;
            const Imagen gpu = vistaDe(programa, guion, columnas * (ancho + 1) - 1, filas * (alto + 1) - 1,
                                       enFicheros(imagenes))
                                   .escena;
            for (int k = 0; k < n; ++k) {
                const int x = k % columnas * (ancho + 1), y = (filas - 1 - k / columnas) * (alto + 1);
                const Imagen panel = oraculo::recorta(gpu, x, y, ancho, alto);
                EXPECT_LE(diferenciaMaxima(panel, paneles[std::size_t(k)]), cota) << k;
            }
        }
}
