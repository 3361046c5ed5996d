// Las texturas que hace assets/genera_assets.cpp: byte a byte las mismas en cualquier máquina, y con el aspecto que dicen sus nombres.
#include "imagenes.h"
#include "rutas.h"
#include <gtest/gtest.h>
#include <map>

namespace {

struct Asset {
    int ancho, alto;
    std::uint64_t fnv; // FNV-1a de 64 bits del fichero
};
const std::map<std::string, Asset> ASSETS = {
    {"baldosas", {256, 256, 0x924097405279b660}},
    {"carta", {256, 256, 0xd0b0343d205e62ed}},
    {"entorno_abajo", {256, 256, 0x4f16b4ebd5f6eb0e}},
    {"entorno_arriba", {256, 256, 0x98c5618617e65c40}},
    {"entorno_delante", {256, 256, 0x4711fa06f1d5b4e5}},
    {"entorno_derecha", {256, 256, 0x2c793efa184c251f}},
    {"entorno_detras", {256, 256, 0xae49f838ed34bfed}},
    {"entorno_izquierda", {256, 256, 0xf368182e7b1b0849}},
    {"foto", {250, 190, 0xf09d249e3c352a9b}},
    {"ladrillo", {256, 256, 0xc9613647c73087fe}},
    {"luz", {64, 48, 0xab297e315418ba49}},
    {"madera", {256, 256, 0xd59efbf1c2a755e6}},
    {"mascara", {128, 96, 0xd5008eb324b7128d}},
    {"metal", {256, 256, 0x03e32f46840c109a}},
    {"mosaico", {32, 32, 0x556882cb8fcf2020}},
    {"musgo", {256, 256, 0xe9aacc54408d513f}},
};

Imagen lee(const std::string &nombre) {
    const Asset &a = ASSETS.at(nombre);
    return leeTextura(recurso("assets/" + nombre + ".rgb"), a.ancho, a.alto);
}

/// La media y la desviación típica de cada componente.
struct Estadistica {
    glm::dvec3 media{0}, desviacion{0};

    explicit Estadistica(const Imagen &im) {
        const double n = im.ancho * im.alto;
        glm::dvec3 cuadrados(0);
        for (int i = 0; i < int(im.rgb.size()); ++i) {
            media[i % 3] += im.rgb[i] / n;
            cuadrados[i % 3] += im.rgb[i] * im.rgb[i] / n;
        }
        desviacion = glm::sqrt(cuadrados - media * media);
    }
};
double mayor(const glm::dvec3 &v) {
    return std::max({v.x, v.y, v.z});
}

const Pixel TINTA = {41, 43, 51};

TEST(Assets, LosMismosBytesEnCualquierMaquina) {
    for (const auto &[nombre, a] : ASSETS) {
        const std::string bytes = leeFichero(recurso("assets/" + nombre + ".rgb"));
        EXPECT_EQ(bytes.size(), std::size_t(3 * a.ancho * a.alto)) << nombre;
        std::uint64_t h = 0xcbf29ce484222325;
        for (const char c : bytes)
            h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3;
        EXPECT_EQ(h, a.fnv) << nombre << " 0x" << std::hex << h;
    }
}

// Ni lisas, ni quemadas, ni a oscuras: más de 12 niveles de desviación, y menos de un 2 % de texels blancos o negros.
TEST(Assets, TienenDetalleYTonosMedios) {
    for (const char *nombre :
         {"baldosas", "carta", "foto", "ladrillo", "madera", "metal", "mosaico", "musgo"}) {
        const Imagen im = lee(nombre);
        EXPECT_GT(mayor(Estadistica(im).desviacion), 12) << nombre;
        const int extremos = cuenta(im, [](int, int, const Pixel &p) {
            return p.r == p.g && p.g == p.b && (p.r == 0 || p.r == 255);
        });
        EXPECT_LT(extremos, im.ancho * im.alto / 50) << nombre;
    }
}

TEST(Assets, SonDelColorQueDiceSuNombre) {
    const auto deMedia = [](const char *nombre) { return Estadistica(lee(nombre)).media; };
    const glm::dvec3 gris = deMedia("metal"), rojizo = deMedia("ladrillo"), pardo = deMedia("madera"),
                     verde = deMedia("musgo");
    EXPECT_LT(mayor(gris) + mayor(-gris), 15);
    EXPECT_TRUE(rojizo.r > 1.4 * rojizo.g && rojizo.g > 1.1 * rojizo.b);
    EXPECT_TRUE(pardo.r > 1.2 * pardo.g && pardo.g > 1.4 * pardo.b);
    EXPECT_TRUE(verde.g > 1.2 * verde.r && verde.r > 1.5 * verde.b);
}

// Al repetirse no se ve la juntura: de la última fila o columna a la primera no se cambia más que entre las que más cambian.
TEST(Assets, LasQueSeRepitenCasanConsigoMismas) {
    for (const char *nombre : {"baldosas", "ladrillo", "madera", "metal", "musgo"}) {
        const Imagen im = lee(nombre);
        for (const bool enX : {true, false}) {
            std::vector<int> saltos(256); // de la fila o columna i a la siguiente, en total
            const auto en = [&](int i, int j) { return enX ? pixel(im, i % 256, j) : pixel(im, j, i % 256); };
            for (int i = 0; i < 256; ++i)
                for (int j = 0; j < 256; ++j) {
                    const Pixel p = en(i, j), q = en(i + 1, j);
                    saltos[i] += std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b);
                }
            EXPECT_LE(saltos[255], *std::max_element(saltos.begin(), saltos.begin() + 255)) << nombre;
        }
    }
}

// La carta dice cuál es cada esquina: origen oscuro, eje s rojo abajo, eje t verde a la izquierda; A a D y 1 a 4.
TEST(Assets, LaCartaTieneElOrigenAbajoALaIzquierda) {
    const Imagen im = lee("carta");
    EXPECT_EQ(pixel(im, 2, 2), TINTA);
    EXPECT_EQ(pixel(im, 100, 2), (Pixel{217, 51, 46}));
    EXPECT_EQ(pixel(im, 2, 100), (Pixel{51, 158, 71}));
    const Pixel a1 = pixel(im, 60, 20), d4 = pixel(im, 252, 252);
    EXPECT_TRUE(a1.r > 200 && a1.b < 100) << "A1, amarilla, abajo a la izquierda";
    EXPECT_TRUE(d4.b > 150 && d4.b > d4.r + 60) << "D4, azul, arriba a la derecha";
    // El 1 de B1: su serifa, que solo tiene abajo, es más ancha que su cabeza. Cabeza abajo o en espejo no lo sería.
    const auto tinta = [&](int fila) {
        return cuenta(
            im, [&](int x, int y, const Pixel &p) { return y == fila && x >= 98 && x < 118 && p == TINTA; });
    };
    EXPECT_EQ(tinta(28), 12); // tres puntos de cuatro texels
    EXPECT_EQ(tinta(52), 4);
    EXPECT_EQ(tinta(48), 8); // el trazo que sube, a la izquierda
    EXPECT_EQ(pixel(im, 104, 48), TINTA);
}

// Cielo azulado arriba, prado abajo a la izquierda; sol y brillos casi blancos, y una piel anaranjada y suave.
TEST(Assets, LaFotoTieneCieloFollajePielYBrillos) {
    const Imagen im = lee("foto");
    const auto trozo = [&](int x0, int y0, int ancho, int alto) {
        return Estadistica(imagen(ancho, alto, [&](int x, int y) { return pixel(im, x0 + x, y0 + y); }));
    };
    const glm::dvec3 cielo = trozo(190, 160, 60, 30).media, prado = trozo(20, 5, 90, 35).media,
                     piel = trozo(206, 52, 10, 10).media;
    EXPECT_GT(cielo.b, cielo.r);
    EXPECT_TRUE(prado.g > 1.3 * prado.b && prado.g > 0.9 * prado.r && prado.g < 120);
    EXPECT_TRUE(piel.r > piel.g + 30 && piel.g > piel.b);
    EXPECT_LT(trozo(206, 52, 10, 10).desviacion.r, 25);
    const int brillos = cuenta(im, [](int, int, const Pixel &p) { return std::min({p.r, p.g, p.b}) > 200; });
    EXPECT_TRUE(brillos > 60 && brillos < 250 * 190 / 50) << brillos;
}

// La máscara es gris y llega a los dos extremos; la luz nunca es cero y en algún sitio llega a 255.
TEST(Assets, LaMascaraYLaLuz) {
    const Imagen mascara = lee("mascara"), luz = lee("luz");
    EXPECT_EQ(cuenta(mascara, [](int, int, const Pixel &p) { return p.r != p.g || p.g != p.b; }), 0);
    const auto [nada, todo] = std::minmax_element(mascara.rgb.begin(), mascara.rgb.end());
    EXPECT_EQ(*nada, 0);
    EXPECT_EQ(*todo, 255);
    const auto [poca, mucha] = std::minmax_element(luz.rgb.begin(), luz.rgb.end());
    EXPECT_GT(*poca, 40);
    EXPECT_EQ(*mucha, 255);
}

} // namespace
