// El par de superficies: el teselador de NURBS de GLU, que entrega sus triángulos a funciones propias y no dibuja.
#pragma once
#include "ch02_modelado/bezier.h"
#include <GL/glu.h>

namespace mide {

struct EnParche {
    glm::dvec2 uv;
    glm::dvec3 p;
};

/// Lo que entrega GLU: los triángulos de sus abanicos y tiras, cada uno con el parche del que es.
struct Recogido {
    std::vector<std::pair<std::size_t, std::array<EnParche, 3>>> triangulos;
    std::vector<EnParche> vertices; // del abanico o la tira que está entregando
    std::size_t parche = 0;
    GLenum clase = 0;
    glm::dvec2 uv{};

    void vertice(const GLfloat *v) {
        vertices.push_back({uv, {v[0], v[1], v[2]}});
        const std::size_t n = vertices.size();
        if (n >= 3 && (clase != GL_TRIANGLES || n % 3 == 0))
            triangulos.push_back(
                {parche, {vertices[clase == GL_TRIANGLE_FAN ? 0 : n - 3], vertices[n - 2], vertices[n - 1]}});
    }
};

inline Recogido teselaGlu(const std::vector<Parche> &parches, double pixel, float tolerancia) {
    Recogido r;
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
                         static_cast<Recogido *>(d)->clase = clase;
                         static_cast<Recogido *>(d)->vertices.clear();
                     }));
    gluNurbsCallback(nurbs, GLU_NURBS_TEXTURE_COORD_DATA, reinterpret_cast<F>(+[](GLfloat *v, void *d) {
                         static_cast<Recogido *>(d)->uv = {v[0], v[1]};
                     }));
    gluNurbsCallback(nurbs, GLU_NURBS_VERTEX_DATA, reinterpret_cast<F>(+[](GLfloat *v, void *d) {
                         static_cast<Recogido *>(d)->vertice(v);
                     }));
    GLfloat nudos[8] = {0, 0, 0, 0, 1, 1, 1, 1}, nudosUv[4] = {0, 0, 1, 1},
            uv[2][2][2] = {{{0, 0}, {1, 0}}, {{0, 1}, {1, 1}}};
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
        ++r.parche;
    }
    gluDeleteNurbsRenderer(nurbs);
    return r;
}

} // namespace mide
