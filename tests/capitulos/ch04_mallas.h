// Para comparar con el oráculo lo que dibujan los shaders: mallas llevadas al mundo y la normal interpolada.
#pragma once
#include "malla.h"
#include "oraculo/oraculo.h"

/// Una malla de common/ llevada al mundo por M, con las normales de sus vértices ya transformadas.
inline oraculo::Objeto enMundo(const oraculo::Mat4 &M, const Malla &malla) {
    const oraculo::Mat4 inv = oraculo::inversa(M);
    std::vector<oraculo::VerticeRef> vertices;
    for (const Vertice &v : malla.vertices)
        vertices.push_back({oraculo::punto(M, {v.posicion.x, v.posicion.y, v.posicion.z}),
                            oraculo::transformaNormal(inv, {v.normal.x, v.normal.y, v.normal.z})});
    std::vector<std::array<std::size_t, 3>> indices;
    for (std::size_t k = 0; k < malla.indices.size(); k += 3)
        indices.push_back({malla.indices[k], malla.indices[k + 1], malla.indices[k + 2]});
    return oraculo::malla(oraculo::Mat4{}, vertices, indices);
}

/// La normal como la recibe el fragment shader: interpolada entre las de los vértices, sin normalizar.
inline oraculo::Vec3 normalInterpolada(const oraculo::Escena &escena, const oraculo::Impacto &i) {
    const oraculo::Objeto &objeto = escena[static_cast<std::size_t>(i.objeto)];
    if (!objeto.triangulos)
        return i.normal;
    const auto &t = objeto.triangulos->indices[static_cast<std::size_t>(i.corte.triangulo)];
    const auto n = [&](std::size_t k) { return objeto.triangulos->vertices[t[k]].normal; };
    return (1 - i.corte.b1 - i.corte.b2) * n(0) + i.corte.b1 * n(1) + i.corte.b2 * n(2);
}
