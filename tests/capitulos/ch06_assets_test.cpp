// Las texturas que hace assets/genera_assets.cpp: byte a byte las mismas en cualquier máquina.
#include "rutas.h"
#include <gtest/gtest.h>
#include <map>

namespace {

// FNV-1a de 64 bits de cada fichero
const std::map<std::string, std::uint64_t> ASSETS = {
    {"baldosas", 0x924097405279b660},
    {"carta", 0xd0b0343d205e62ed},
    {"entorno_abajo", 0x4f16b4ebd5f6eb0e},
    {"entorno_arriba", 0x98c5618617e65c40},
    {"entorno_delante", 0x4711fa06f1d5b4e5},
    {"entorno_derecha", 0x2c793efa184c251f},
    {"entorno_detras", 0xae49f838ed34bfed},
    {"entorno_izquierda", 0xf368182e7b1b0849},
    {"foto", 0xf09d249e3c352a9b},
    {"foto_grande", 0x7633944b363f3c1e},
    {"ladrillo", 0xc9613647c73087fe},
    {"luz", 0xab297e315418ba49},
    {"madera", 0xd59efbf1c2a755e6},
    {"mascara", 0xd5008eb324b7128d},
    {"metal", 0x03e32f46840c109a},
    {"mosaico", 0x556882cb8fcf2020},
    {"musgo", 0xe9aacc54408d513f},
};

TEST(Assets, LosMismosBytesEnCualquierMaquina) {
    for (const auto &[nombre, fnv] : ASSETS) {
        const std::string bytes = leeFichero(recurso("assets/" + nombre + ".rgb"));
        std::uint64_t h = 0xcbf29ce484222325;
        for (const char c : bytes)
            h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3;
        EXPECT_EQ(h, fnv) << nombre << " 0x" << std::hex << h;
    }
}

} // namespace
