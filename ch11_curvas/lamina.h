// Lo que tienen en común los programas de superficies: la cámara, la luz y dibujar una superficie que cambia mientras se edita.
#pragma once
#include "ch05_iluminacion/iluminacion.h"
#include "colores.h"
#include "editor.h"
#include "superficies.h"

const Material LAMINA_AZUL = {{0.10f, 0.16f, 0.30f}, {0.24f, 0.45f, 0.80f}, {0.45f, 0.45f, 0.45f}, 40},
               LAMINA_NARANJA = {{0.28f, 0.15f, 0.05f}, {0.85f, 0.47f, 0.14f}, {0.45f, 0.45f, 0.45f}, 40};
const Luz LUZ_LAMINA{{-0.55f, 0.75f, 0.45f, 0}};
const float ANGULO_LAMINA = 0.5f;

inline GLuint programaLamina;
inline Orbita orbitaLamina = {0.55f, 0.55f, 8.6f};

/// De coordenadas del mundo a las de recortado.
inline glm::mat4 vistaLamina() {
    return perspectivaVentana(ANGULO_LAMINA, 1, 100) * camaraOrbita(orbitaLamina);
}

/// Lo que mide en el centro de la escena un píxel de la ventana.
inline double pixelLamina() {
    return 2 * std::tan(ANGULO_LAMINA / 2) * orbitaLamina.distancia / altoUtil();
}

inline void iniciaLamina() {
    programaLamina = creaSombreado("phong");
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glEnable(GL_POLYGON_OFFSET_FILL); // la superficie, un poco detrás de las líneas que van por ella
    glPolygonOffset(1, 1);
    glClearColor(FONDO_CLARO.r, FONDO_CLARO.g, FONDO_CLARO.b, 1);
}

/// Dibuja la malla por las dos caras: por detrás, con la normal opuesta.
inline void dibujaLamina(Malla malla, const Material &material) {
    const std::size_t vertices = malla.vertices.size(), indices = malla.indices.size();
    for (std::size_t i = 0; i < vertices; ++i) {
        malla.vertices.push_back(malla.vertices[i]);
        malla.vertices.back().normal *= -1.0f;
    }
    for (std::size_t i = 0; i < indices; ++i) // al revés, el triángulo gira en el otro sentido
        malla.indices.push_back(malla.indices[indices - 1 - i] + static_cast<GLuint>(vertices));
    const glm::mat4 camara = camaraOrbita(orbitaLamina);
    glUseProgram(programaLamina);
    envia(programaLamina, "proyeccion", perspectivaVentana(ANGULO_LAMINA, 1, 100));
    envia(programaLamina, "camara", camara);
    envia(programaLamina, "La", glm::vec3(1));
    enviaLuz(programaLamina, "luz", LUZ_LAMINA, camara);
    const Buferes buferes = creaBuferes(malla);
    dibujaObjeto(programaLamina, buferes, glm::mat4(1), camara, material);
    glDeleteVertexArrays(1, &buferes.vao);
    glDeleteBuffers(1, &buferes.vertices);
    glDeleteBuffers(1, &buferes.indices);
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
