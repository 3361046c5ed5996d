// El par de superficies: el teselador de NURBS de GLU, que entrega sus triángulos a funciones propias y no dibuja.
#pragma once
#include "ch02_modelado/bezier.h"
#include "mide.h"
#include <GL/glu.h>

namespace mide {

/// Lo que entrega GLU: los vértices con su (u, v), y los triángulos de sus abanicos y tiras.
struct Recogido {
    std::vector<glm::vec3> vertices;
    std::vector<glm::vec2> uv;
    std::vector<std::array<std::size_t, 3>> triangulos;
    std::vector<std::size_t> parche; // de cada triángulo
    std::size_t primero = 0, cual = 0;
    GLenum clase = 0;
    glm::vec2 uvActual;

    void vertice(const GLfloat *v) {
        vertices.push_back({v[0], v[1], v[2]});
        uv.push_back(uvActual);
        const std::size_t n = vertices.size(), k = n - primero;
        if (k < 3 || (clase == GL_TRIANGLES && k % 3))
            return;
        triangulos.push_back({clase == GL_TRIANGLE_FAN ? primero : n - 3, n - 2, n - 1});
        parche.push_back(cual);
    }
};

inline void teselaGlu(const std::vector<Parche> &parches, double pixel, float tolerancia, Recogido &r) {
    GLUnurbs *nurbs = gluNewNurbsRenderer();
    gluNurbsProperty(nurbs, GLU_NURBS_MODE, GLU_NURBS_TESSELLATOR);
    gluNurbsProperty(nurbs, GLU_AUTO_LOAD_MATRIX, GL_FALSE);
    gluNurbsProperty(nurbs, GLU_SAMPLING_METHOD, GLU_PARAMETRIC_ERROR);
    gluNurbsProperty(nurbs, GLU_PARAMETRIC_TOLERANCE, tolerancia);
    gluNurbsProperty(nurbs, GLU_CULLING, GL_FALSE);
    // paralela: una unidad de la tetera son 1/pixel píxeles
    const GLint ventana[4] = {0, 0, 2000, 2000};
    const auto k = GLfloat(1 / pixel / 1000);
    const GLfloat uno[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
                  escala[16] = {k, 0, 0, 0, 0, k, 0, 0, 0, 0, k, 0, 0, 0, 0, 1};
    gluLoadSamplingMatrices(nurbs, escala, uno, ventana);
    using F = void (*)();
    gluNurbsCallbackData(nurbs, &r);
    gluNurbsCallback(nurbs, GLU_NURBS_BEGIN_DATA, reinterpret_cast<F>(+[](GLenum clase, void *d) {
                         Recogido &e = *static_cast<Recogido *>(d);
                         e.clase = clase;
                         e.primero = e.vertices.size();
                     }));
    gluNurbsCallback(nurbs, GLU_NURBS_TEXTURE_COORD_DATA, reinterpret_cast<F>(+[](GLfloat *v, void *d) {
                         static_cast<Recogido *>(d)->uvActual = {v[0], v[1]};
                     }));
    gluNurbsCallback(nurbs, GLU_NURBS_VERTEX_DATA, reinterpret_cast<F>(+[](GLfloat *v, void *d) {
                         static_cast<Recogido *>(d)->vertice(v);
                     }));
    GLfloat nudos[8] = {0, 0, 0, 0, 1, 1, 1, 1}, nudosUv[4] = {0, 0, 1, 1},
            uv[2][2][2] = {{{0, 0}, {1, 0}}, {{0, 1}, {1, 1}}};
    r = {};
    for (const Parche &q : parches) {
        GLfloat puntos[4][4][3];
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
                for (int c = 0; c < 3; ++c)
                    puntos[i][j][c] = GLfloat(q.p[i][j][c]);
        gluBeginSurface(nurbs);
        gluNurbsSurface(nurbs, 4, nudosUv, 4, nudosUv, 4, 2, &uv[0][0][0], 2, 2, GL_MAP2_TEXTURE_COORD_2);
        gluNurbsSurface(nurbs, 8, nudos, 8, nudos, 12, 3, &puntos[0][0][0], 4, 4, GL_MAP2_VERTEX_3);
        gluEndSurface(nurbs);
        ++r.cual;
    }
    gluDeleteNurbsRenderer(nurbs);
}

/// Como las demás variantes: error en los lados y en el centro de cada triángulo.
inline void mideGlu(Medidor &m, const std::vector<Parche> &parches, double pixel, float tolerancia,
                    const char *nombre) {
    Recogido r;
    teselaGlu(parches, pixel, tolerancia, r);
    double mayor = 0;
    for (std::size_t t = 0; t < r.triangulos.size(); ++t)
        for (const glm::dvec3 w : {glm::dvec3(.5, .5, 0), {0, .5, .5}, {.5, 0, .5}, glm::dvec3(1 / 3.0)}) {
            glm::dvec3 enPlano(0);
            glm::dvec2 uv(0);
            for (std::size_t k = 0; k < 3; ++k) {
                enPlano += w[int(k)] * glm::dvec3(r.vertices[r.triangulos[t][k]]);
                uv += w[int(k)] * glm::dvec2(r.uv[r.triangulos[t][k]]);
            }
            const auto exacto = [&](double u, double v) {
                return parche::posicion(parches[r.parche[t]], parche::pesos0(u, 1 - u),
                                        parche::pesos0(v, 1 - v));
            };
            mayor = std::max(mayor, std::min(glm::length(exacto(uv.x, uv.y) - enPlano),
                                             glm::length(exacto(uv.y, uv.x) - enPlano)));
        }
    m.variante(
        nombre, mayor / pixel, 1, [&] { teselaGlu(parches, pixel, tolerancia, r); },
        std::to_string(r.triangulos.size()) + " triángulos");
}

} // namespace mide
