// Las texturas que hace assets/genera_assets.cpp: byte a byte las mismas en cualquier máquina.
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
    {"foto_grande", {1000, 760, 0x7633944b363f3c1e}},
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

// La foto grande es la misma: cada 4 × 4 de sus texels dan, salvo el redondeo y lo fino, uno de la pequeña.
TEST(Assets, LaFotoGrandeEsLaMisma) {
    const Imagen grande = lee("foto_grande"), foto = lee("foto");
    double suma = 0;
    for (int y = 0; y < 190; ++y)
        for (int x = 0; x < 250; ++x) {
            oraculo::Vec3 media;
            for (int k = 0; k < 16; ++k)
                media = media + 1 / 16.0 * color(pixel(grande, 4 * x + k % 4, 4 * y + k / 4));
            suma += distancia(pixel(foto, x, y), media);
        }
    EXPECT_LE(suma / (250 * 190), 2);
}

// La carta dice cuál es cada esquina: origen oscuro, eje s rojo abajo, eje t verde a la izquierda.
TEST(Assets, LaCartaTieneElOrigenAbajoALaIzquierda) {
    const Imagen im = lee("carta");
    EXPECT_EQ(pixel(im, 2, 2), (Pixel{41, 43, 51}));
    EXPECT_EQ(pixel(im, 100, 2), (Pixel{217, 51, 46}));
    EXPECT_EQ(pixel(im, 2, 100), (Pixel{51, 158, 71}));
}

} // namespace
