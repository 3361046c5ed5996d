// Una matriz escrita, para rotularla.
#pragma once
#include "colores.h"
#include "proyeccion.h"
#include "rotulo.h"
#include "texto.h"
#include <algorithm>
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

/// La matriz en ese sitio del panel, que es el de su primera barra, columna a columna: en morado, las que no son de la
/// identidad.
inline void rotulaMatriz(const glm::mat4 &M, glm::vec2 lugar, float talla = 0.032f) {
    // una columna y lo que la separa de la siguiente ocupan cinco letras y media
    const float paso = 5.5f * 0.83f * talla * std::min(1 / relacionAspecto(), 0.75f);
    const std::string barra = "|\n|\n|\n|";
    rotula(barra, lugar, OSCURO, Lado::DERECHA, talla);
    lugar.x += paso / 4;
    for (int columna = 0; columna < 4; ++columna, lugar.x += paso) {
        std::string numeros;
        for (int fila = 0; fila < 4; ++fila)
            numeros += formatea(fila ? "\n%5.3g" : "%5.3g", aCentesimas(M[columna][fila]));
        rotula(numeros, lugar, M[columna] == glm::mat4(1)[columna] ? OSCURO : MORADO, Lado::DERECHA, talla);
    }
    rotula(barra, lugar, OSCURO, Lado::DERECHA, talla);
}
