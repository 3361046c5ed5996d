// Lo que tienen en común los programas de superficies: la cámara, la luz y dibujar una superficie que cambia mientras
// se edita.
#pragma once
#include "buferes.h"
#include "ch05_iluminacion/iluminacion.h"
#include "ch05_iluminacion/materiales.h"
#include "colores.h"
#include "malla.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "shader.h"
#include "superficies.h"
#include "trazo.h"
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
    float angulo = ANGULO_LAMINA; // de la vista: se abre si hay más que ver, y la rueda no cambia de límites
};

inline glm::mat4 proyeccionLamina(const Lamina &lamina) {
    return perspectivaVentana(lamina.angulo, CERCA_LAMINA, LEJOS_LAMINA);
}

/// De coordenadas del mundo a las de recortado.
inline glm::mat4 vistaLamina(const Lamina &lamina) {
    return proyeccionLamina(lamina) * camaraOrbita(lamina.orbita);
}

/// Los segmentos con que la superficie no se separa de sus triángulos más de `pixeles`. Lo que mide un píxel es lo que
/// mide en el punto de control más cercano a la cámara: la superficie, dentro de su casco convexo, no está más cerca.
inline Segmentos segmentosLamina(const Lamina &lamina, const RedBezier<float> &red, double pixeles) {
    const glm::mat4 camara = camaraOrbita(lamina.orbita);
    float distancia = LEJOS_LAMINA;
    for (const glm::vec3 &p : red.P)
        distancia = std::min(distancia, std::max(CERCA_LAMINA, -(camara * glm::vec4(p, 1)).z));
    return segmentosSuperficie(red, pixeles * 2 * std::tan(lamina.angulo / 2) * distancia / altoUtil());
}

inline Lamina creaLamina(const Orbita &orbita) {
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    ponFondo(FONDO_CLARO);
    return {creaSombreado("phong"), orbita};
}

/// Dibuja la malla por las dos caras. La de detrás tiene la normal opuesta y otra luz, la opuesta: así ninguna queda a
/// oscuras.
inline void dibujaLamina(const Lamina &lamina, Malla malla, const Material &material) {
    const glm::mat4 camara = camaraOrbita(lamina.orbita);
    usaPrograma(lamina.programa, camara, proyeccionLamina(lamina));
    envia(lamina.programa, "La", glm::vec3(1));
    glEnable(GL_POLYGON_OFFSET_FILL); // un poco detrás de las líneas que van por ella
    glPolygonOffset(2, 2);
    for (const float cara : {-1.0f, 1.0f}) {
        for (Vertice &v : malla.vertices)
            v.normal *= -1;
        enviaLuz(lamina.programa, "luz", Luz{cara * LUZ_LAMINA}, camara);
        glCullFace(cara < 0 ? GL_FRONT : GL_BACK);
        const Buferes buferes = creaBuferes(malla);
        dibujaIluminado(lamina.programa, buferes, glm::mat4(1), camara, material);
        borraBuferes(buferes);
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
}

/// Las curvas de u y de v constantes de la superficie.
inline void trazaCurvas(const Lamina &lamina, const RedBezier<float> &red, const glm::vec3 &color) {
    const int CURVAS = 5, TRAMOS = 32;
    for (const bool deU : {false, true})
        for (int k = 0; k <= CURVAS; ++k) {
            std::vector<glm::vec3> curva;
            for (int i = 0; i <= TRAMOS; ++i) {
                const float fija = float(k) / CURVAS, otra = float(i) / TRAMOS;
                curva.push_back(deU ? superficie(red, fija, otra) : superficie(red, otra, fija));
            }
            trazaPolilinea(curva, vistaLamina(lamina), color, GROSOR / 2);
        }
}

/// Si algo se ha movido, en blanco la superficie y en negro la de antes, que se ve aunque ahora quede debajo.
inline void trazaCambio(const Lamina &lamina, const RedBezier<float> &antes, const RedBezier<float> &ahora) {
    if (antes.P == ahora.P)
        return;
    trazaCurvas(lamina, ahora, BLANCO);
    glDisable(GL_DEPTH_TEST);
    trazaCurvas(lamina, antes, OSCURO);
    glEnable(GL_DEPTH_TEST);
}

/// Los lados de una red de control de `columnas` columnas, dada por filas.
inline std::vector<glm::vec3> redDeControl(const std::vector<glm::vec3> &P, std::size_t columnas) {
    std::vector<glm::vec3> lados;
    for (std::size_t k = 0; k < P.size(); ++k) {
        if ((k + 1) % columnas != 0)
            lados.insert(lados.end(), {P[k], P[k + 1]});
        if (k + columnas < P.size())
            lados.insert(lados.end(), {P[k], P[k + columnas]});
    }
    return lados;
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
