// Lo que tienen en común los programas de superficies: la cámara, la luz y dibujar una superficie que cambia mientras
// se edita.
#pragma once
#include "ch05_iluminacion/iluminacion.h"
#include "colores.h"
#include "editor.h"
#include "superficies.h"
#include <algorithm>
#include <cmath>
#include <vector>

const Material LAMINA_AZUL = {{0.14f, 0.23f, 0.38f}, {0.18f, 0.37f, 0.60f}, {0.30f, 0.30f, 0.30f}, 30},
               LAMINA_NARANJA = {{0.40f, 0.22f, 0.07f}, {0.58f, 0.33f, 0.10f}, {0.30f, 0.30f, 0.30f}, 30};
const glm::vec4 LUZ_LAMINA = {-0.6f, 0.85f, 0.3f, 0};
const float ANGULO_LAMINA = 0.5f, CERCA_LAMINA = 1, LEJOS_LAMINA = 100;
const double TOLERANCIA_LAMINA = 0.2; // píxeles; con menos triángulos se notaría en los brillos

/// Lo que guarda el programa.
struct Lamina {
    GLuint programa;
    Orbita orbita;
};

inline glm::mat4 proyeccionLamina() {
    return perspectivaVentana(ANGULO_LAMINA, CERCA_LAMINA, LEJOS_LAMINA);
}

/// De coordenadas del mundo a las de recortado.
inline glm::mat4 vistaLamina(const Lamina &lamina) {
    return proyeccionLamina() * camaraOrbita(lamina.orbita);
}

/// Los segmentos con que la superficie no se separa de sus triángulos más de `pixeles`. Lo que mide un píxel es lo que
/// mide en el punto de control más cercano a la cámara: la superficie, dentro de su casco convexo, no está más cerca.
inline Segmentos segmentosLamina(const Lamina &lamina, Base base, const Geometria2<float> &G,
                                 double pixeles) {
    const glm::mat4 camara = camaraOrbita(lamina.orbita);
    float distancia = LEJOS_LAMINA;
    for (const Geometria<float> &fila : aBezier2(base, G))
        for (const glm::vec3 &p : fila)
            distancia = std::min(distancia, std::max(CERCA_LAMINA, -(camara * glm::vec4(p, 1)).z));
    return segmentosSuperficie(base, G, pixeles * 2 * std::tan(ANGULO_LAMINA / 2) * distancia / altoUtil());
}

inline Lamina creaLamina(const Orbita &orbita) {
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glEnable(GL_POLYGON_OFFSET_FILL); // la superficie, un poco detrás de las líneas que van por ella
    glPolygonOffset(1, 1);
    glClearColor(FONDO_CLARO.r, FONDO_CLARO.g, FONDO_CLARO.b, 1);
    return {creaSombreado("phong"), orbita};
}

/// Dibuja la malla por las dos caras. La de detrás tiene la normal opuesta y otra luz, la opuesta: así ninguna queda a
/// oscuras.
inline void dibujaLamina(const Lamina &lamina, Malla malla, const Material &material) {
    const glm::mat4 camara = camaraOrbita(lamina.orbita);
    glUseProgram(lamina.programa);
    envia(lamina.programa, "proyeccion", proyeccionLamina());
    envia(lamina.programa, "camara", camara);
    envia(lamina.programa, "La", glm::vec3(1));
    for (const float cara : {-1.0f, 1.0f}) {
        for (Vertice &v : malla.vertices)
            v.normal *= -1;
        enviaLuz(lamina.programa, "luz", Luz{cara * LUZ_LAMINA}, camara);
        glCullFace(cara < 0 ? GL_FRONT : GL_BACK);
        const Buferes buferes = creaBuferes(malla);
        dibujaObjeto(lamina.programa, buferes, glm::mat4(1), camara, material);
        glDeleteVertexArrays(1, &buferes.vao);
        glDeleteBuffers(1, &buferes.vertices);
        glDeleteBuffers(1, &buferes.indices);
    }
}

/// Los segmentos de la red de control de n×n puntos, dados por filas.
inline std::vector<glm::vec3> redDeControl(const std::vector<glm::vec3> &P, std::size_t n) {
    std::vector<glm::vec3> red;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j + 1 < n; ++j)
            red.insert(red.end(), {P[n * i + j], P[n * i + j + 1], P[n * j + i], P[n * (j + 1) + i]});
    return red;
}

/// La matriz de geometría de los 16 puntos que empiezan en (fila, columna) de una red de n×n.
inline Geometria2<float> geometriaDeRed(const std::vector<glm::vec3> &P, std::size_t n, std::size_t fila = 0,
                                        std::size_t columna = 0) {
    Geometria2<float> G;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            G[i][j] = P[n * (fila + i) + columna + j];
    return G;
}
