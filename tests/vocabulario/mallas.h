// Lo que se le pide a una malla, sea de quien sea.
#pragma once
#include "malla.h"
#include "prueba.h"

/// Cuántas aristas son de un solo triángulo, soldando los vértices que coinciden bit a bit. Las demás son de dos, que
/// las recorren en sentidos opuestos.
inline int aristasSueltas(const Malla &m) {
    using Bits = std::array<float, 3>;
    std::map<std::pair<Bits, Bits>, std::vector<bool>> usos; // y en qué sentido
    for (std::size_t t = 0; t < m.indices.size(); ++t) {
        const glm::vec3 p = m.vertices.at(m.indices[t]).posicion + 0.0f, // −0 y +0 son el mismo sitio
            q = m.vertices.at(m.indices[t % 3 == 2 ? t - 2 : t + 1]).posicion + 0.0f;
        const Bits a = {p.x, p.y, p.z}, b = {q.x, q.y, q.z};
        usos[std::minmax(a, b)].push_back(a < b);
    }
    int sueltas = 0;
    for (const auto &[arista, sentidos] : usos) {
        sueltas += sentidos.size() == 1;
        EXPECT_TRUE(sentidos.size() == 1 || (sentidos.size() == 2 && sentidos[0] != sentidos[1]));
    }
    return sueltas;
}

/// Lo más que se separan los triángulos de una malla y su superficie: en una rejilla de cada uno, de n puntos por lado,
/// distancia(primer vértice, punto, (u, v)).
template<class Distancia>
double separacionMaxima(const Malla &malla, int n, Distancia distancia) {
    double mayor = 0;
    for (std::size_t t = 0; t < malla.indices.size(); t += 3)
        for (int i = 0; i <= n; ++i)
            for (int j = 0; i + j <= n; ++j) {
                const double pesos[] = {double(i) / n, double(j) / n, double(n - i - j) / n};
                glm::dvec3 p(0);
                glm::dvec2 uv(0);
                for (std::size_t k = 0; k < 3; ++k) {
                    const Vertice &v = malla.vertices[malla.indices[t + k]];
                    p += pesos[k] * glm::dvec3(v.posicion);
                    uv += pesos[k] * glm::dvec2(v.coordTextura);
                }
                mayor = std::max(mayor, distancia(malla.indices[t], p, uv));
            }
    return mayor;
}
