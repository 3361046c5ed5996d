// Uno o varios paneles, cada uno con una imagen y su rótulo: así son casi todos los programas del capítulo 9.
#pragma once
#include "colores.h"
#include "imagenes.h"
#include "oraculo/compara.h"
#include <gtest/gtest.h>

using oraculo::Vec3;

inline Vec3 absoluto(const Vec3 &v) {
    return {std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)};
}

struct Cuadro {
    Esperado esperado;
    std::string rotulo;
    double cota = 0.51; // el redondeo a 8 bits; con números enteros, exacto
};
struct Caso {
    std::vector<std::string> guiones; // dan lo mismo
    std::vector<Cuadro> paneles;
    int columnas = 1;
};

/// El programa con esas imágenes, en una ventana en que cada panel mide lo que la primera: así un texel es un píxel.
inline void compruebaPaneles(const std::string &programa, const std::vector<Imagen> &imagenes,
                             const std::vector<Caso> &casos) {
    const int ancho = imagenes[0].ancho, alto = imagenes[0].alto;
    for (const auto &[guiones, paneles, columnas] : casos)
        for (const std::string &guion : guiones) {
            SCOPED_TRACE(programa + " «" + guion + "»");
            const int n = int(paneles.size()), filas = n / columnas;
            const Vista v = vistaDe(programa, "tecla r; " + guion, columnas * (ancho + 1) - 1,
                                    filas * (alto + 1) - 1, enFicheros(imagenes)); // con la r, los rótulos
            ASSERT_EQ(v.encima.size(), paneles.size());
            for (int k = 0; k < n; ++k) {
                const int x = k % columnas * (ancho + 1), y = (filas - 1 - k / columnas) * (alto + 1);
                const Cuadro &p = paneles[std::size_t(k)];
                const Pintado &rotulo = v.encima[std::size_t(k)];
                EXPECT_LE(diferenciaMaxima(oraculo::recorta(v.escena, x, y, ancho, alto), p.esperado), p.cota)
                    << k;
                EXPECT_EQ(rotulo.texto, p.rotulo);
                EXPECT_TRUE(rotulo.es(BLANCO));
                EXPECT_LE(glm::distance(rotulo.punto(2), glm::dvec2(x, y + 0.02 * alto)), 0.1) << k;
            }
        }
}
