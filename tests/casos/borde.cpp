// borde [--queda] IMAGEN.ppm…: comprueba que en el borde de cada imagen solo hay fondo (colores.h), o la raya que separa los
// paneles: lo que toca el borde está cortado. Con --queda, que en cada imagen se ve algo más que fondo. Estado: 0 bien;
// 1 mal, y dice dónde.
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

// Lo menos que debe verse de una escena de la que alguien se ha alejado: el 0.5 % de los píxeles.
static bool quedaAlgo(const Imagen &imagen) {
    std::size_t pintados = 0;
    for (std::size_t i = 0; i < imagen.rgb.size(); i += 3)
        pintados += !esFondo(&imagen.rgb[i]);
    return 200 * 3 * pintados >= imagen.rgb.size();
}

int main(int argc, char **argv) {
    int estado = 0;
    const bool queda = argc > 1 && std::string(argv[1]) == "--queda";
    for (int i = queda ? 2 : 1; i < argc; ++i) {
        const Imagen imagen = leePpm(argv[i]);
        if (queda) {
            if (!quedaAlgo(imagen)) {
                std::printf("%s: no se ve más que fondo\n", argv[i]);
                estado = 1;
            }
            continue;
        }
        const int n = imagen.ancho, m = imagen.alto;
        int cortados[4] = {}; // izquierda, derecha, abajo, arriba
        const auto mira = [&](int x, int y, int lado) {
            cortados[lado] += !esFondo(&imagen.rgb[3 * static_cast<std::size_t>(y * n + x)]);
        };
        for (int y = 0; y < m; ++y)
            mira(0, y, 0), mira(n - 1, y, 1);
        for (int x = 0; x < n; ++x)
            mira(x, 0, 2), mira(x, m - 1, 3);
        for (int lado = 0; lado < 4; ++lado)
            if (cortados[lado]) {
                const char *const nombres[] = {"izquierdo", "derecho", "de abajo", "de arriba"};
                std::printf("%s: %d píxeles del borde %s no son fondo\n", argv[i], cortados[lado],
                            nombres[lado]);
                estado = 1;
            }
    }
    return estado;
}
