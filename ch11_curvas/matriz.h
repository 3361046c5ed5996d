// Una matriz base escrita como en el libro, para ponerla junto a la curva que da.
#pragma once
#include <cstdio>
#include <glm/glm.hpp>
#include <string>

const float TALLA_MATRIZ = 0.034f;

/// El nombre y, debajo, las filas.
inline std::string escribe(const std::string &nombre, const glm::mat4 &M) {
    std::string texto = nombre;
    for (int fila = 0; fila < 4; ++fila) {
        char numeros[64];
        std::snprintf(numeros, sizeof numeros, "\n|%2g %2g %2g %2g|", M[0][fila], M[1][fila], M[2][fila],
                      M[3][fila]);
        texto += numeros;
    }
    return texto;
}
