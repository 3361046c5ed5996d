// Lo exacto de una curva de Bézier, en cuádruple precisión, y lo que se separa de ello lo que se mide.
#pragma once
#include "herramientas/oraculo/cuadruple.h"
#include <glm/glm.hpp>
#include <vector>

using PuntoExacto = glm::vec<3, Cuadruple>;

/// |a − b| en double.
template<class T>
double separacion(const glm::vec<3, T> &a, const PuntoExacto &b) {
    const PuntoExacto d(Cuadruple(a.x) - b.x, Cuadruple(a.y) - b.y, Cuadruple(a.z) - b.z);
    return glm::length(glm::dvec3(double(d.x), double(d.y), double(d.z)));
}

/// Q(u) de una curva de Bézier de cualquier grado, con de Casteljau.
template<class Puntos>
PuntoExacto bezierExacta(const Puntos &puntos, Cuadruple u) {
    std::vector<PuntoExacto> q;
    for (const auto &p : puntos)
        q.push_back({Cuadruple(p.x), Cuadruple(p.y), Cuadruple(p.z)});
    for (std::size_t n = q.size() - 1; n > 0; --n)
        for (std::size_t i = 0; i < n; ++i)
            q[i] = (Cuadruple(1) - u) * q[i] + u * q[i + 1];
    return q[0];
}
