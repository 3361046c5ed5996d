// borde [--queda] IMAGEN.ppm…: comprueba que en el borde de cada imagen solo hay fondo (colores.h), o la raya que
// separa los paneles: lo que toca el borde está cortado. Con --queda, que en cada imagen se ve algo más que fondo.
// Estado: 0 bien; 1 mal, y dice dónde.
#include "colores.h"
#include "imagen.h"
#include <algorithm>
#include <cstdio>
#include <cstdlib>

static bool esFondo(const unsigned char *rgb) {
    for (const glm::vec3 &fondo : {FONDO_CLARO, FONDO_OSCURO, CIELO, GRIS}) {
        const glm::ivec3 d = glm::abs(glm::ivec3(rgb[0], rgb[1], rgb[2]) - glm::ivec3(255.0f * fondo + 0.5f));
        if (std::max({d.r, d.g, d.b}) <= 1)
            return true;
    }
    return false;
}

int main(int argc, char **argv) {
    int estado = 0;
    const bool queda = argc > 1 && std::string(argv[1]) == "--queda";
    for (int i = queda ? 2 : 1; i < argc; ++i) {
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
            std::printf("%s: no se ve más que fondo\n", argv[i]);
            estado = 1;
        }
        const char *const LADOS[] = {"izquierdo", "derecho", "de abajo", "de arriba"};
        for (int lado = 0; lado < 4; ++lado)
            if (!queda && cortados[lado]) {
                std::printf("%s: %d píxeles del borde %s no son fondo\n", argv[i], cortados[lado],
                            LADOS[lado]);
                estado = 1;
            }
    }
    return estado;
}
