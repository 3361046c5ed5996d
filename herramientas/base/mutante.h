// Lo que herramientas/pruebas/muta.py incluye en cada fichero que estropea: qué mutantes están puestos ($LAB_MUTANTE,
// «5012» o «5012,5013») y, en $LAB_LEIDOS, donde common/rutas.cpp apunta los ficheros del laboratorio, qué mutantes
// llega a usar cada proceso.
#pragma once
#include <cstdio>
#include <cstdlib>

inline std::FILE *const mutantesVistos = // desde que se carga: una prueba puede poner otro
    std::getenv("LAB_LEIDOS") ? std::fopen(std::getenv("LAB_LEIDOS"), "a") : nullptr;

inline bool mutante(int n) {
    static bool puesto[1 << 16];
    static const bool leidos = [] {
        const char *texto = std::getenv("LAB_MUTANTE");
        for (char *fin; texto && *texto; texto = *fin == ',' ? fin + 1 : "")
            puesto[std::strtoul(texto, &fin, 10) % (1 << 16)] = true;
        return true;
    }();
    static bool yaVisto[1 << 16];
    if (mutantesVistos && !yaVisto[n]) {
        yaVisto[n] = true;
        std::fprintf(mutantesVistos, "%d\n", n);
        std::fflush(mutantesVistos); // el proceso puede acabar de cualquier manera
    }
    return leidos && puesto[n];
}
