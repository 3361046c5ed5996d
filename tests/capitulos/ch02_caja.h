// La caja del ejercicio 2.1 vista como la ven malla_vf y tiras, en doble precisión.
#pragma once
#include "colores.h"
#include "ejecuta.h"
#include "oraculo/oraculo.h"
#include "rotulos.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <map>
#include <vector>

const int ANCHO = 480, ALTO = 360; // de las imágenes que se comparan
const double CAJA[8][3] = {{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0},
                           {0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}};
const std::array<std::array<int, 3>, 10> CARAS = {{{1, 3, 2},
                                                   {1, 4, 3},
                                                   {1, 2, 5},
                                                   {2, 6, 5},
                                                   {3, 2, 6},
                                                   {3, 6, 7},
                                                   {3, 4, 7},
                                                   {4, 8, 7},
                                                   {4, 1, 8},
                                                   {1, 5, 8}}};

/// Un vértice (desde 1) llevado a la esfera de radio 1: la media diagonal de la caja mide √3/2.
inline oraculo::Vec3 verticeCaja(int i) {
    const double *p = CAJA[i - 1], r = std::sqrt(3.0) / 2;
    return {(p[0] - 0.5) / r, (p[1] - 0.5) / r, (p[2] - 0.5) / r};
}

/// La cámara de los dos programas: a la menor distancia desde la que caben a 4:3 los ocho vértices, aumentados un 17 %.
struct VistaCaja {
    oraculo::Camara camara;
    int ancho, alto;

    VistaCaja(double azimut, double elevacion, int elAncho = ANCHO, int elAlto = ALTO)
        : ancho(elAncho), alto(elAlto) {
        const double t = std::tan(0.3);
        const oraculo::Camara lejana = oraculo::orbita(azimut, elevacion, 100);
        double distancia = 0;
        for (int i = 1; i <= 8; ++i) {
            const oraculo::Vec3 p = oraculo::enCamara(lejana, verticeCaja(i));
            distancia = std::max({distancia, 1.17 * (p.z + 100 + std::fabs(p.y) / t),
                                  1.17 * (p.z + 100 + std::fabs(p.x) * 0.75 / t)});
        }
        camara = oraculo::perspectiva(oraculo::orbita(azimut, elevacion, distancia), 0.6, 0.1, 100);
    }
    oraculo::Vec3 vertice(int i) const {
        return verticeCaja(i);
    }
    glm::dvec2 enPixel(const oraculo::Vec3 &p) const {
        const oraculo::Vec3 q = oraculo::proyecta(camara, ancho, alto, p);
        return {q.x, q.y};
    }
};

/// Unos triángulos de la caja, dados por sus vértices desde 1.
inline oraculo::Objeto mallaCaja(const std::vector<std::array<int, 3>> &triangulos) {
    std::vector<oraculo::VerticeRef> vertices;
    for (int i = 1; i <= 8; ++i)
        vertices.push_back({verticeCaja(i), {0, 0, 1}});
    std::vector<oraculo::Triangulos::Indices> indices;
    for (const auto &t : triangulos)
        indices.push_back({static_cast<std::size_t>(t[0] - 1), static_cast<std::size_t>(t[1] - 1),
                           static_cast<std::size_t>(t[2] - 1)});
    return oraculo::malla(oraculo::escala({1, 1, 1}), vertices, indices);
}

/// Cuánto se separa un píxel, en niveles, de un color de 0 a 1.
inline double distanciaColor(const Imagen &imagen, int x, int y, const glm::dvec3 &color) {
    const unsigned char *p = &imagen.rgb[3 * static_cast<std::size_t>(y * imagen.ancho + x)];
    const glm::dvec3 d = glm::abs(glm::dvec3(p[0], p[1], p[2]) - 255.0 * color);
    return std::max({d.r, d.g, d.b});
}

/// El color que más se repite en los píxeles en que la referencia ve ese triángulo (−1: ninguno), sin contar los de las líneas y
/// los números, que van encima.
struct Mayoria {
    int pixeles = 0;
    double parte = 0; // la de ese color
    glm::dvec3 color{0};
    oraculo::Impacto impacto; // uno cualquiera

    double diferencia(const glm::dvec3 &esperado) const {
        const glm::dvec3 d = glm::abs(color - 255.0 * esperado);
        apuntaDiferencia(std::max({d.r, d.g, d.b}));
        return std::max({d.r, d.g, d.b});
    }
};
inline Mayoria mayoria(const Imagen &imagen, const oraculo::Escena &escena, const oraculo::Camara &camara,
                       int triangulo) {
    Mayoria m;
    std::map<std::array<unsigned char, 3>, int> colores;
    for (int y = 0; y < imagen.alto; ++y)
        for (int x = 0; x < imagen.ancho; ++x) {
            const oraculo::Impacto i = oraculo::primerImpacto(
                escena, oraculo::rayo(camara, imagen.ancho, imagen.alto, x + 0.5, y + 0.5));
            if ((i ? i.corte.triangulo : -1) != triangulo)
                continue;
            const unsigned char *p = &imagen.rgb[3 * static_cast<std::size_t>(y * imagen.ancho + x)];
            if (distanciaColor(imagen, x, y, OSCURO) > 1 && distanciaColor(imagen, x, y, BLANCO) > 1)
                ++colores[{p[0], p[1], p[2]}];
            ++m.pixeles;
            m.impacto = i;
        }
    int mas = 0;
    for (const auto &[color, n] : colores)
        if (n > mas) {
            mas = n;
            m.color = glm::dvec3(color[0], color[1], color[2]);
        }
    m.parte = m.pixeles ? static_cast<double>(mas) / m.pixeles : 0;
    return m;
}
