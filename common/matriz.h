// Una matriz escrita, para rotularla.
#pragma once
#include "colores.h"
#include "proyeccion.h"
#include "rotulo.h"
#include "texto.h"
#include <algorithm>
#include <glm/glm.hpp>
#include <string>

/// La matriz desde ese sitio del panel, el de su primer corchete; en morado, las columnas que no son de la identidad.
inline void rotulaMatriz(const glm::mat4 &M, glm::vec2 lugar, float talla = 0.032f) {
    const float paso = 6 * 0.83f * talla * std::min(1 / relacionAspecto(), 0.75f); // seis letras por columna
    rotula("⎡\n⎢\n⎢\n⎣", lugar, OSCURO, Lado::DERECHA, talla);
    lugar.x += paso / 4;
    for (int columna = 0; columna < 4; ++columna, lugar.x += paso) {
        std::string numeros;
        for (int fila = 0; fila < 4; ++fila)
            numeros += formatea(fila ? "\n%5.3g" : "%5.3g", aCentesimas(M[columna][fila]));
        rotula(numeros, lugar, M[columna] == glm::mat4(1)[columna] ? OSCURO : MORADO, Lado::DERECHA, talla);
    }
    rotula("⎤\n⎥\n⎥\n⎦", lugar, OSCURO, Lado::DERECHA, talla);
}
