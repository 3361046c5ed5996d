// La F de escalado y basicas: ni la simetría de una esfera ni la de un cubo, así que siempre se ve cómo está puesta. No
// pasa por el origen: escalar o girar también la cambian de sitio. El brazo corto acaba en una cara inclinada, para que
// un escalado no uniforme cambie una normal: las demás están en los ejes. Sin OpenGL.
#pragma once
#include "malla.h"

const glm::vec3 MINIMO_F(0.15f, 0.15f, -0.25f), MAXIMO_F(1.30f, 1.65f, 0.25f);

/// Su contorno, en sentido antihorario, y los triángulos que lo llenan.
const int LADOS_F = 10;
const glm::vec2 CONTORNO_F[LADOS_F] = {{0.15f, 0.15f}, {0.55f, 0.15f}, {0.55f, 0.70f}, {1.10f, 0.70f},
                                       {1.00f, 1.05f}, {0.55f, 1.05f}, {0.55f, 1.30f}, {1.30f, 1.30f},
                                       {1.30f, 1.65f}, {0.15f, 1.65f}};
const unsigned TRIANGULOS_F[8][3] = {{0, 1, 2}, {2, 3, 4}, {2, 4, 5}, {0, 2, 5},
                                     {0, 5, 6}, {0, 6, 9}, {6, 7, 8}, {6, 8, 9}};

inline Malla letraF() {
    Malla letra;
    for (float z : {MINIMO_F.z, MAXIMO_F.z}) {
        const unsigned base = unsigned(letra.vertices.size());
        const bool delante = z > 0;
        for (const glm::vec2 &p : CONTORNO_F)
            letra.vertices.push_back({{p, z}, {0, 0, delante ? 1 : -1}, p});
        for (const auto &t : TRIANGULOS_F) // la tapa de atrás se ve por el otro lado: gira al revés
            letra.indices.insert(letra.indices.end(),
                                 {base + t[0], base + t[delante ? 1 : 2], base + t[delante ? 2 : 1]});
    }
    for (int i = 0; i < LADOS_F; ++i) {
        const glm::vec2 p = CONTORNO_F[i], q = CONTORNO_F[(i + 1) % LADOS_F];
        const glm::vec3 normal = glm::normalize(glm::vec3(q.y - p.y, p.x - q.x, 0));
        const unsigned base = unsigned(letra.vertices.size());
        for (const glm::vec3 &v : {glm::vec3(p, MINIMO_F.z), glm::vec3(q, MINIMO_F.z),
                                   glm::vec3(q, MAXIMO_F.z), glm::vec3(p, MAXIMO_F.z)})
            letra.vertices.push_back({v, normal, glm::vec2(v)});
        letra.indices.insert(letra.indices.end(), {base, base + 1, base + 2, base, base + 2, base + 3});
    }
    return letra;
}

/// Sus aristas: los dos extremos de cada una.
inline std::vector<glm::vec3> aristasF() {
    std::vector<glm::vec3> extremos;
    for (int i = 0; i < LADOS_F; ++i) {
        const glm::vec2 p = CONTORNO_F[i], q = CONTORNO_F[(i + 1) % LADOS_F];
        for (const glm::vec3 &v :
             {glm::vec3(p, MINIMO_F.z), glm::vec3(q, MINIMO_F.z), glm::vec3(p, MAXIMO_F.z),
              glm::vec3(q, MAXIMO_F.z), glm::vec3(p, MINIMO_F.z), glm::vec3(p, MAXIMO_F.z)})
            extremos.push_back(v);
    }
    return extremos;
}
