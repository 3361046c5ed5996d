// borde [--queda | --corta LADOS] IMAGEN…: comprueba que en el borde de cada imagen solo hay fondo (colores.h), o la
// raya que separa los paneles: lo que toca el borde está cortado. Con --corta, puede estarlo por esos lados («izquierda
// abajo», «todos»), y por cada uno lo está en alguna imagen. Con --queda, que en cada una se ve algo más que fondo.
// Estado: 0 bien; 1 mal, y dice dónde.
#include "colores.h"
#include "imagen.h"
#include <algorithm>
#include <cstdio>

static bool esFondo(const unsigned char *rgb) {
    for (const glm::vec3 &fondo : {FONDO_CLARO, FONDO_OSCURO, CIELO, GRIS}) {
        const glm::ivec3 d = glm::abs(glm::ivec3(rgb[0], rgb[1], rgb[2]) - glm::ivec3(255.0f * fondo + 0.5f));
        if (std::max({d.r, d.g, d.b}) <= 1)
            return true;
    }
    return false;
}

struct Lado {
    std::string nombre, delBorde;
    bool puede, cortado; // por él, en alguna imagen
};

int main(int argc, char **argv) {
    int estado = 0, primera = 1;
    const std::string opcion = argc > 1 ? argv[1] : "";
    const bool queda = opcion == "--queda";
    std::string corta;
    if (opcion == "--corta" && argc > 2)
        corta = " " + std::string(argv[2]) + " ";
    primera += opcion == "--corta" ? 2 : queda;
    Lado lados[] = {{"izquierda", "izquierdo", false, false},
                    {"derecha", "derecho", false, false},
                    {"abajo", "de abajo", false, false},
                    {"arriba", "de arriba", false, false}};
    for (Lado &lado : lados)
        lado.puede = corta == " todos " || corta.find(" " + lado.nombre + " ") != std::string::npos;
    for (int i = primera; i < argc; ++i) {
        const Imagen imagen = leePpm(argv[i]);
        int pintados = 0, cortados[4] = {};
        for (int y = 0; y < imagen.alto; ++y)
            for (int x = 0; x < imagen.ancho; ++x)
                if (!esFondo(&imagen.rgb[3 * (y * imagen.ancho + x)])) {
                    ++pintados;
                    cortados[0] += x == 0;
                    cortados[1] += x == imagen.ancho - 1;
                    cortados[2] += y == 0;
                    cortados[3] += y == imagen.alto - 1;
                }
        // lo menos que debe verse de una escena de la que alguien se ha alejado: el 0.5 % de los píxeles
        if (queda && 200 * pintados < imagen.ancho * imagen.alto) {
            std::printf("%s: solo se ven %d píxeles, y la escena debe ocupar el 0.5 %%\n", argv[i], pintados);
            estado = 1;
        }
        for (int k = 0; k < 4; ++k) {
            lados[k].cortado = lados[k].cortado || cortados[k];
            if (!queda && cortados[k] && !lados[k].puede) {
                std::printf("%s: %d píxeles del borde %s no son fondo\n", argv[i], cortados[k],
                            lados[k].delBorde.c_str());
                estado = 1;
            }
        }
    }
    for (const Lado &lado : lados)
        if (lado.puede && !lado.cortado) {
            std::printf("en ninguna imagen hay nada cortado por el borde %s: sobra «%s»\n",
                        lado.delBorde.c_str(), lado.nombre.c_str());
            estado = 1;
        }
    return estado;
}
