// Lo que herramientas/muta.py incluye en cada fichero que estropea: qué mutante está puesto ($LAB_MUTANTE) y, si se pide en
// $LAB_VISTOS, qué mutantes y ficheros del laboratorio llega a usar cada proceso.
#pragma once
#include <cstdio>
#include <cstdlib>
#include <string>

inline void apuntaVisto(const std::string &que) {
    static std::FILE *const vistos =
        std::getenv("LAB_VISTOS") ? std::fopen(std::getenv("LAB_VISTOS"), "a") : nullptr;
    if (vistos) {
        std::fprintf(vistos, "%s\n", que.c_str());
        std::fflush(vistos); // el proceso puede acabar de cualquier manera
    }
}

inline const std::string &mutantePuesto() {
    static const std::string numero = std::getenv("LAB_MUTANTE") ? std::getenv("LAB_MUTANTE") : "0";
    return numero;
}

inline bool mutante(int n) {
    static const int puesto = std::atoi(mutantePuesto().c_str());
    static bool yaVisto[1 << 16];
    if (!yaVisto[n]) {
        yaVisto[n] = true;
        apuntaVisto(std::to_string(n));
    }
    return n == puesto;
}

/// La carpeta en que están los shaders que estropea el mutante puesto.
inline std::string raizMutante(const std::string &carpeta, const std::string &relativa) {
    apuntaVisto(relativa);
    return carpeta + "/glsl/" + mutantePuesto();
}
