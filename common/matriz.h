// Una matriz escrita, para rotularla.
#pragma once
#include <cmath>
#include <cstdio>
#include <glm/glm.hpp>
#include <string>

/// Sus filas, una por línea, con cada número a centésimas y en `ancho` letras.
inline std::string filasDe(const glm::mat4 &M, int ancho = 6) {
    std::string filas;
    for (int fila = 0; fila < 4; ++fila) {
        filas += fila ? "\n|" : "|";
        for (int columna = 0; columna < 4; ++columna) {
            char texto[32]; // redondeado, que cos 90° no sea −4.4e−8; y + 0 quita el signo de −0
            std::snprintf(texto, sizeof texto, "%*.3g", ancho,
                          std::round(100 * M[columna][fila]) / 100 + 0.0);
            filas += texto;
        }
        filas += " |";
    }
    return filas;
}
