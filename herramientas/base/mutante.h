// Lo que herramientas/pruebas/muta.py incluye en cada fichero que estropea: qué mutante está puesto ($LAB_MUTANTE) y,
// en $LAB_LEIDOS, donde common/rutas.cpp apunta los ficheros del laboratorio, qué mutantes llega a usar cada proceso.
#pragma once
#include <cstdio>
#include <cstdlib>

inline bool mutante(int n) {
    static const char *const puesto = std::getenv("LAB_MUTANTE");
    static std::FILE *const vistos =
        std::getenv("LAB_LEIDOS") ? std::fopen(std::getenv("LAB_LEIDOS"), "a") : nullptr;
    static bool yaVisto[1 << 16];
    if (vistos && !yaVisto[n]) {
        yaVisto[n] = true;
        std::fprintf(vistos, "%d\n", n);
        std::fflush(vistos); // el proceso puede acabar de cualquier manera
    }
    return puesto && n == std::atoi(puesto);
}
