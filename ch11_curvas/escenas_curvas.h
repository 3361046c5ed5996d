// Los puntos con que empiezan los programas de curvas, todos en z = 0 y dentro de [−4/3, 4/3]×[−1, 1], y sus matrices
// escritas. Sin OpenGL.
#pragma once
#include "texto.h"
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <string>
#include <vector>

const std::vector<glm::vec3> PUNTOS_BEZIER = {
    {-1.02f, -0.68f, 0}, {-0.72f, 0.62f, 0}, {0.62f, 0.74f, 0}, {1.02f, -0.56f, 0}};

/// P1, P4 y las puntas de R1 y R4; y P4' y la punta de R4' del segundo tramo.
const std::vector<glm::vec3> PUNTOS_HERMITE = {
    {-0.98f, -0.62f, 0}, {0.30f, 0.22f, 0}, {-0.72f, 0.72f, 0}, {1.00f, -0.66f, 0}};
const std::vector<glm::vec3> SEGUNDO_HERMITE = {{1.75f, 0.55f, 0}, {1.95f, 1.0f, 0}};
const float K_HERMITE = 0.5f; // lo que mide la tangente del segundo tramo, en veces R4
/// La transformación de hermite: escalar, girar alrededor de Z y trasladar.
const glm::vec3 T_ESCALADO(0.75f, 0.5f, 1), T_TRASLACION(0.42f, 0.3f, 0);
const float T_GIRO = -0.5f;

const std::vector<glm::vec3> PUNTOS_BSPLINE = {{-1.05f, -0.05f, 0}, {-0.88f, 0.68f, 0}, {-0.28f, 0.40f, 0},
                                               {0.12f, 0.76f, 0},   {0.86f, 0.66f, 0},  {1.06f, -0.10f, 0},
                                               {0.50f, -0.70f, 0},  {0.02f, -0.30f, 0}, {-0.62f, -0.72f, 0}};
const float TALLA_MATRIZ = 0.034f; // la de las matrices base rotuladas
const float LARGO_PUAS = 0.035f;   // la del peine donde la curvatura es 1

/// La matriz en cuatro líneas, con cada número a centésimas y en `ancho` letras, y lo que va delante de la segunda.
inline std::string filasDe(const std::string &delante, const glm::mat4 &M, int ancho) {
    std::string filas;
    for (int fila = 0; fila < 4; ++fila) {
        filas += (fila == 1 ? delante : std::string(delante.size(), ' ')) + ABRE[fila];
        for (int columna = 0; columna < 4; ++columna)
            filas += formatea("%*.3g", ancho, aCentesimas(M[columna][fila]));
        filas += CIERRA[fila] + std::string(fila < 3, '\n');
    }
    return filas;
}

/// Una onda con un zigzag encima, de x = 0 a x = 1.
inline std::vector<glm::vec3> puntosZigzag(std::size_t n) {
    std::vector<glm::vec3> P;
    for (std::size_t i = 0; i < n; ++i) {
        const float t = float(i) / float(n - 1);
        P.push_back({t, 0.42f * std::sin(glm::two_pi<float>() * t) + (i % 2 ? 0.42f : -0.42f), 0});
    }
    return P;
}
