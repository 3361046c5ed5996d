// Una matriz escrita, para rotularla.
#pragma once
#include "texto.h"
#include <glm/glm.hpp>
#include <string>

/// Sus filas, una por línea, con cada número a centésimas y en `ancho` letras.
inline std::string filasDe(const glm::mat4 &M, int ancho = 6) {
    std::string filas;
    for (int fila = 0; fila < 4; ++fila) {
        filas += fila ? "\n|" : "|";
        for (int columna = 0; columna < 4; ++columna)
            filas += formatea("%*.3g", ancho, aCentesimas(M[columna][fila]));
        filas += " |";
    }
    return filas;
}
