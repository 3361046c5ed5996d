// Dibujar la malla de una imagen y llevarla a la GPU: lo que comparten warping y morphing.
#pragma once
#include "buferes.h"
#include "colores.h"
#include "malla.h"
#include "malla_imagen.h"
#include "recuadro.h"
#include "trazo.h"
#include <GL/glew.h>
#include <GL/freeglut.h>

/// Cambia los vértices de unos buffers que ya tienen esos índices.
inline void cambiaVertices(const Buferes &buferes, const Malla &malla) {
    glBindBuffer(GL_ARRAY_BUFFER, buferes.vertices);
    glBufferData(GL_ARRAY_BUFFER, malla.vertices.size() * sizeof(Vertice), malla.vertices.data(),
                 GL_DYNAMIC_DRAW);
}

/// Sus curvas y sus puntos, en el área de dibujo.
inline void trazaMalla(const MallaImagen &m) {
    const glm::mat4 aRecortado(2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1, 0, -1, -1, 0, 1); // de [0, 1] a [−1, 1]
    const auto curva = [&](int largo, const auto &punto) {
        std::vector<glm::vec3> puntos;
        for (int k = 0; k <= 8 * (largo - 1); ++k)
            puntos.push_back(glm::vec3(punto(float(k) / 8), 0));
        trazaPolilinea(puntos, aRecortado, BLANCO, 3);
    };
    for (int j = 0; j < m.filas; ++j)
        curva(m.columnas, [&](float u) { return evalua(m, u, float(j)); });
    for (int i = 0; i < m.columnas; ++i)
        curva(m.filas, [&](float v) { return evalua(m, float(i), v); });
    std::vector<glm::vec3> puntos;
    for (const glm::vec2 &p : m.puntos)
        puntos.push_back(glm::vec3(p, 0));
    trazaPuntos(puntos, aRecortado, NARANJA, 14);
}

/// El píxel (x, y) del ratón, de 0 a 1 en ese rectángulo de la ventana.
inline glm::vec2 enRecuadro(const Recuadro &r, int x, int y) {
    const glm::vec2 p(x, glutGet(GLUT_WINDOW_HEIGHT) - 1 - y);
    return (p + 0.5f - glm::vec2(r.x, r.y)) / glm::vec2(r.ancho, r.alto);
}
