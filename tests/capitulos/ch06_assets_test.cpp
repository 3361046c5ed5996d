// Las texturas que hace assets/genera_assets.cpp: byte a byte las mismas en cualquier máquina, y con el
// aspecto que dicen sus nombres.
#include "ejecuta.h"
#include "rutas.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>

namespace {

struct Asset {
    const char *nombre;
    int ancho, alto;
    std::uint64_t fnv; // FNV-1a de 64 bits del fichero
};
const Asset ASSETS[] = {
    {"baldosas", 256, 256, 0x924097405279b660},
    {"carta", 256, 256, 0xd0b0343d205e62ed},
    {"entorno_abajo", 256, 256, 0x4f16b4ebd5f6eb0e},
    {"entorno_arriba", 256, 256, 0x98c5618617e65c40},
    {"entorno_delante", 256, 256, 0x4711fa06f1d5b4e5},
    {"entorno_derecha", 256, 256, 0x2c793efa184c251f},
    {"entorno_detras", 256, 256, 0xae49f838ed34bfed},
    {"entorno_izquierda", 256, 256, 0xf368182e7b1b0849},
    {"foto", 250, 190, 0xf09d249e3c352a9b},
    {"ladrillo", 256, 256, 0xc9613647c73087fe},
    {"luz", 64, 48, 0xab297e315418ba49},
    {"madera", 256, 256, 0xd59efbf1c2a755e6},
    {"mascara", 128, 96, 0xd5008eb324b7128d},
    {"metal", 256, 256, 0x03e32f46840c109a},
    {"mosaico", 32, 32, 0x556882cb8fcf2020},
    {"musgo", 256, 256, 0xe9aacc54408d513f},
};

Imagen lee(const std::string &nombre) {
    for (const Asset &a : ASSETS)
        if (nombre == a.nombre)
            return leeTextura(recurso("assets/" + nombre + ".rgb"), a.ancho, a.alto);
    throw std::invalid_argument(nombre);
}

/// Media y desviación típica de cada componente en un rectángulo.
struct Estadistica {
    std::array<double, 3> media{}, desviacion{};
};
Estadistica estadistica(const Imagen &im, int x0, int y0, int x1, int y1) {
    Estadistica e;
    std::array<double, 3> cuadrados{};
    const double n = (x1 - x0) * (y1 - y0);
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
            const Pixel p = pixel(im, x, y);
            const double c[3] = {double(p.r), double(p.g), double(p.b)};
            for (std::size_t k = 0; k < 3; ++k)
                e.media[k] += c[k] / n, cuadrados[k] += c[k] * c[k] / n;
        }
    for (std::size_t k = 0; k < 3; ++k)
        e.desviacion[k] = std::sqrt(std::max(0.0, cuadrados[k] - e.media[k] * e.media[k]));
    return e;
}
Estadistica estadistica(const Imagen &im) {
    return estadistica(im, 0, 0, im.ancho, im.alto);
}

bool es(const Pixel &p, int r, int g, int b) {
    return p.r == r && p.g == g && p.b == b;
}

} // namespace

TEST(Assets, LosMismosBytesEnCualquierMaquina) {
    for (const Asset &a : ASSETS) {
        const std::string bytes = leeFichero(recurso("assets/" + std::string(a.nombre) + ".rgb"));
        EXPECT_EQ(bytes.size(), static_cast<std::size_t>(3 * a.ancho * a.alto)) << a.nombre;
        std::uint64_t h = 0xcbf29ce484222325;
        for (const char c : bytes)
            h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3;
        EXPECT_EQ(h, a.fnv) << a.nombre << " 0x" << std::hex << h;
    }
}

// Ni lisas, ni quemadas, ni a oscuras: más de 12 niveles de desviación, y menos de un 2 % de texels blancos o
// negros.
TEST(Assets, TienenDetalleYTonosMedios) {
    for (const char *nombre :
         {"baldosas", "carta", "foto", "ladrillo", "madera", "metal", "mosaico", "musgo"}) {
        const Imagen im = lee(nombre);
        const Estadistica e = estadistica(im);
        EXPECT_GT(*std::max_element(e.desviacion.begin(), e.desviacion.end()), 12) << nombre;
        int extremos = 0;
        for (int y = 0; y < im.alto; ++y)
            for (int x = 0; x < im.ancho; ++x) {
                const Pixel p = pixel(im, x, y);
                extremos += es(p, 255, 255, 255) || es(p, 0, 0, 0);
            }
        EXPECT_LT(extremos, im.ancho * im.alto / 50) << nombre;
    }
}

TEST(Assets, SonDelColorQueDiceSuNombre) {
    const auto media = [](const char *nombre) { return estadistica(lee(nombre)).media; };
    const auto gris = media("metal"), rojizo = media("ladrillo"), pardo = media("madera"),
               verde = media("musgo");
    EXPECT_LT(*std::max_element(gris.begin(), gris.end()) - *std::min_element(gris.begin(), gris.end()), 15);
    EXPECT_TRUE(rojizo[0] > 1.4 * rojizo[1] && rojizo[1] > 1.1 * rojizo[2]);
    EXPECT_TRUE(pardo[0] > 1.2 * pardo[1] && pardo[1] > 1.4 * pardo[2]);
    EXPECT_TRUE(verde[1] > 1.2 * verde[0] && verde[0] > 1.5 * verde[2]);
}

// Al repetirse no se ve la juntura: de la última fila o columna a la primera no se cambia más que entre las
// que más cambian.
TEST(Assets, LasQueSeRepitenCasanConsigoMismas) {
    for (const char *nombre : {"baldosas", "ladrillo", "madera", "metal", "musgo"}) {
        const Imagen im = lee(nombre);
        const int n = 256;
        for (const bool enX : {true, false}) {
            std::array<double, 256> salto{}; // del texel i al siguiente, en media
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    const Pixel p = enX ? pixel(im, i, j) : pixel(im, j, i),
                                q = enX ? pixel(im, (i + 1) % n, j) : pixel(im, j, (i + 1) % n);
                    salto[static_cast<std::size_t>(i)] +=
                        (std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b)) / (3.0 * n);
                }
            EXPECT_LE(salto[255], *std::max_element(salto.begin(), salto.begin() + 255)) << nombre;
        }
    }
}

// La carta dice cuál es cada esquina: origen oscuro, eje s rojo abajo, eje t verde a la izquierda; A a D y 1
// a 4.
TEST(Assets, LaCartaTieneElOrigenAbajoALaIzquierda) {
    const Imagen im = lee("carta");
    EXPECT_TRUE(es(pixel(im, 2, 2), 41, 43, 51));
    EXPECT_TRUE(es(pixel(im, 100, 2), 217, 51, 46));
    EXPECT_TRUE(es(pixel(im, 2, 100), 51, 158, 71));
    const Pixel a1 = pixel(im, 60, 20), d4 = pixel(im, 252, 252);
    EXPECT_TRUE(a1.r > 200 && a1.b < 100) << "A1, amarilla, abajo a la izquierda";
    EXPECT_TRUE(d4.b > 150 && d4.b > d4.r + 60) << "D4, azul, arriba a la derecha";
    // El 1 de B1: su serifa, que solo tiene abajo, es más ancha que su cabeza. Cabeza abajo o en espejo no lo
    // sería.
    const auto tinta = [&](int y) {
        int n = 0;
        for (int x = 98; x < 118; ++x)
            n += es(pixel(im, x, y), 41, 43, 51);
        return n;
    };
    EXPECT_EQ(tinta(28), 12); // tres puntos de cuatro texels
    EXPECT_EQ(tinta(52), 4);
    EXPECT_EQ(tinta(48), 8); // el trazo que sube, a la izquierda
    EXPECT_TRUE(es(pixel(im, 104, 48), 41, 43, 51));
}

// Cielo azulado arriba, prado abajo a la izquierda; sol y brillos casi blancos, y una piel anaranjada y
// suave.
TEST(Assets, LaFotoTieneCieloFollajePielYBrillos) {
    const Imagen im = lee("foto");
    const auto cielo = estadistica(im, 190, 160, 250, 190).media,
               prado = estadistica(im, 20, 5, 110, 40).media;
    EXPECT_GT(cielo[2], cielo[0]);
    EXPECT_TRUE(prado[1] > prado[2] * 1.3 && prado[1] > prado[0] * 0.9 && prado[1] < 120);
    const Estadistica piel = estadistica(im, 206, 52, 216, 62);
    EXPECT_TRUE(piel.media[0] > piel.media[1] + 30 && piel.media[1] > piel.media[2] &&
                piel.desviacion[0] < 25);
    int brillos = 0;
    for (int y = 0; y < 190; ++y)
        for (int x = 0; x < 250; ++x) {
            const Pixel p = pixel(im, x, y);
            brillos += std::min({p.r, p.g, p.b}) > 200;
        }
    EXPECT_GT(brillos, 60);
    EXPECT_LT(brillos, 250 * 190 / 50);
}

// La máscara es gris y llega a los dos extremos; la luz nunca es cero y en algún sitio llega a 255.
TEST(Assets, LaMascaraYLaLuz) {
    const Imagen mascara = lee("mascara"), luz = lee("luz");
    int menor = 255, mayor = 0;
    for (int y = 0; y < mascara.alto; ++y)
        for (int x = 0; x < mascara.ancho; ++x) {
            const Pixel p = pixel(mascara, x, y);
            ASSERT_TRUE(p.r == p.g && p.g == p.b);
            menor = std::min(menor, p.r), mayor = std::max(mayor, p.r);
        }
    EXPECT_EQ(menor, 0);
    EXPECT_EQ(mayor, 255);
    EXPECT_GT(*std::min_element(luz.rgb.begin(), luz.rgb.end()), 40);
    EXPECT_EQ(*std::max_element(luz.rgb.begin(), luz.rgb.end()), 255);
}
