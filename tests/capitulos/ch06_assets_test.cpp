// Las texturas que hace assets/genera_assets.cpp: byte a byte las mismas en cualquier máquina.
#include "prueba.h"
#include "rutas.h"

// En tests/golden/assets.fnv, el FNV-1a de 64 bits de cada fichero.
TEST(Assets, LosMismosBytesEnCualquierMaquina) {
    std::istringstream filas(leeFichero(recurso("tests/golden/assets.fnv")));
    std::string nombre;
    int cuantas = 0;
    for (std::uint64_t fnv; filas >> nombre >> std::hex >> fnv; ++cuantas) {
        std::uint64_t h = 0xcbf29ce484222325;
        for (const char c : leeFichero(recurso("assets/" + nombre + ".rgb")))
            h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3;
        EXPECT_EQ(h, fnv) << nombre << " 0x" << std::hex << h;
    }
    EXPECT_EQ(cuantas, 20);
}
