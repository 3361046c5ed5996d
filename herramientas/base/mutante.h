// Lo que herramientas/pruebas/muta.py incluye en cada fichero que estropea: qué mutantes están puestos ($LAB_MUTANTE,
// «5012» o «5012,5013») y, en $LAB_LEIDOS, donde common/rutas.cpp apunta los ficheros del laboratorio, qué mutantes
// llega a usar cada proceso.
#pragma once
#include <cstdio>
#include <cstdlib>

inline bool mutante(int n) {
    static bool puesto[1 << 16];
    static const bool leidos = [] {
        const char *texto = std::getenv("LAB_MUTANTE");
        for (char *fin; texto && *texto; texto = *fin == ',' ? fin + 1 : "")
            puesto[std::strtoul(texto, &fin, 10) % (1 << 16)] = true;
        return true;
    }();
    static std::FILE *const vistos =
        std::getenv("LAB_LEIDOS") ? std::fopen(std::getenv("LAB_LEIDOS"), "a") : nullptr;
    static bool yaVisto[1 << 16];
    if (vistos && !yaVisto[n]) {
        yaVisto[n] = true;
        std::fprintf(vistos, "%d\n", n);
        std::fflush(vistos); // el proceso puede acabar de cualquier manera
    }
    return leidos && puesto[n];
}
