// Los cuatro paneles de etapas_pipeline: dónde están, qué matrices usan y qué vértice señala el ratón.
// Sin OpenGL.
#pragma once
#include "ch03_transformaciones/transformaciones.h"
#include "etapas.h"
#include "vista.h"
#include <array>

/// Un trozo de la ventana, en píxeles desde abajo a la izquierda. El objeto pasa por `hasta` a las coordenadas
/// que enseña, las de recortado por `deRecortado`, y de unas y otras las dibuja `camara`.
struct Panel {
    int x, y, ancho, alto;
    glm::dmat4 hasta, deRecortado, camara;
};
enum { OBJETO, MUNDO, NDC, VENTANA, PANELES };

/// Dos filas de dos paneles iguales, que llenan una ventana de cualquier tamaño.
inline std::array<Panel, PANELES> reparte(int ancho, int alto) {
    const int x = ancho / 2, y = alto / 2, nx = ancho - x, ny = alto - y;
    const glm::dmat4 uno(1);
    return {{{0, y, nx, ny, uno, uno, uno},
             {x, y, nx, ny, uno, uno, uno},
             {0, 0, nx, ny, uno, uno, uno},
             {x, 0, nx, ny, uno, uno, uno}}};
}

/// Pone en cada panel sus dos matrices, `hasta` y `deRecortado`.
inline void colocaMatrices(std::array<Panel, PANELES> &paneles, const Matrices &m) {
    const glm::dmat4 recortado = m.MProy * m.MC, todo = recortado * m.MM;
    paneles[MUNDO].hasta = m.MM;
    paneles[NDC].hasta = paneles[VENTANA].hasta = todo;
    paneles[OBJETO].deRecortado = glm::inverse(todo);
    paneles[MUNDO].deRecortado = glm::inverse(recortado);
}

/// El vértice que se ve más cerca del centro del píxel (x, y), a menos de un octavo del panel en que está el
/// píxel; si no hay ninguno, `siNinguno`.
inline std::size_t verticeSenalado(const std::array<Panel, PANELES> &paneles,
                                   const std::vector<glm::vec3> &vertices, int x, int y,
                                   std::size_t siNinguno) {
    for (const Panel &p : paneles) {
        if (x < p.x || x >= p.x + p.ancho || y < p.y || y >= p.y + p.alto)
            continue;
        const glm::dmat4 Mvp = transformacionViewport(p.x, p.y, p.ancho, p.alto);
        double menor = p.alto / 8.0;
        for (std::size_t k = 0; k < vertices.size(); ++k) {
            const glm::dvec4 v = p.camara * p.hasta * glm::dvec4(vertices[k], 1);
            const glm::dvec4 w = Mvp * glm::dvec4(divide(v), 1);
            const double distancia = std::hypot(w.x - x - 0.5, w.y - y - 0.5);
            if (v.w > 0 && distancia < menor) {
                menor = distancia;
                siNinguno = k;
            }
        }
    }
    return siNinguno;
}

/// Las aristas del volumen canónico, dos puntos por segmento: las del plano cerca (z = −1), las del plano lejos
/// (z = 1) o, con z = 0, las que los unen.
inline std::vector<glm::vec4> aristasVolumen(int z) {
    const int lados[5][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
    std::vector<glm::vec4> puntos;
    for (int k = 0; k < 4; ++k) {
        const int *a = lados[k], *b = z ? lados[k + 1] : a;
        puntos.insert(puntos.end(), {{a[0], a[1], z ? z : -1, 1}, {b[0], b[1], z ? z : 1, 1}});
    }
    return puntos;
}
