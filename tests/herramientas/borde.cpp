// borde IMAGEN.ppm…: comprueba que en el borde de cada imagen solo hay fondo (colores.h), o la raya que separa los paneles: lo
// que toca el borde está cortado. Estado: 0 bien; 1 algo toca el borde, y dice dónde.
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
    for (int i = 1; i < argc; ++i) {
        const Imagen imagen = leePpm(argv[i]);
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
