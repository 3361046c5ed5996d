// La topología de una malla v/f (ejercicio 2.1): qué aristas son de borde, qué caras giran al revés que las
// demás y en qué sentido giran vistas desde fuera. Sin OpenGL; la usan malla_vf y tiras.
//
// El objeto del ejercicio es una caja sin tapa. Todas sus caras giran en sentido antihorario vistas desde
// fuera salvo la 5 y la 6, que lo hacen en sentido horario.
#pragma once
#include "malla.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <map>
#include <utility>
#include <vector>

/// INDEFINIDO: la componente es plana o no es orientable (una banda de Möbius), y no tiene fuera.
enum class Sentido { ANTIHORARIO, HORARIO, INDEFINIDO };

struct Arista {
    GLuint a, b; // a < b
    int caras;   // 1: de borde; 2: interior; 3 o más: la superficie se cruza o se ramifica ahí
};

struct Topologia {
    std::vector<Arista> aristas;
    std::size_t deBorde = 0, ramificadas = 0; // cuántas aristas son de una sola cara y de tres o más
    std::vector<std::size_t> contrarias;      // caras (desde la 0) que giran al revés que su componente
    std::vector<Sentido> sentidos;            // el de la mayoría de cada componente, vista desde fuera
    std::vector<bool> orientables;            // si todas las caras de la componente pueden concordar
};

/// Analiza la malla. Dos caras que comparten una arista (y solo ellas dos) concuerdan si la recorren en
/// sentidos opuestos; una componente son las caras a las que se llega cruzando esas aristas. «El resto» es
/// la mayoría de la componente y, en un empate, lo que diga su primera cara.
///
/// El sentido visto desde fuera es el signo del volumen que encierra la componente, ya con sus caras
/// concordes. Si es abierta, el volumen que encerraría con una tapa en abanico desde el centroide de su
/// borde.
inline Topologia analizaTopologia(const MallaVf &malla) {
    struct Uso {
        std::size_t cara;
        bool directo; // la cara recorre la arista de a hacia b
    };
    std::map<std::pair<GLuint, GLuint>, std::vector<Uso>> usos;
    for (std::size_t c = 0; c < malla.caras.size(); ++c) {
        const std::vector<GLuint> &cara = malla.caras[c];
        for (std::size_t i = 0; i < cara.size(); ++i) {
            const GLuint p = cara[i], q = cara[(i + 1) % cara.size()];
            usos[std::minmax(p, q)].push_back({c, p < q});
        }
    }

    struct Vecina {
        std::size_t cara;
        bool concorde;
    };
    Topologia t;
    std::vector<std::vector<Vecina>> vecinas(malla.caras.size());
    std::vector<std::vector<GLuint>> bordeDe(malla.caras.size()); // extremos de las aristas que no se cruzan
    for (const auto &[extremos, u] : usos) {
        t.aristas.push_back({extremos.first, extremos.second, static_cast<int>(u.size())});
        t.deBorde += u.size() == 1;
        t.ramificadas += u.size() > 2;
        if (u.size() == 2) {
            const bool concorde = u[0].directo != u[1].directo;
            vecinas[u[0].cara].push_back({u[1].cara, concorde});
            vecinas[u[1].cara].push_back({u[0].cara, concorde});
        } else {
            for (const Uso &uso : u)
                bordeDe[uso.cara].insert(bordeDe[uso.cara].end(), {extremos.first, extremos.second});
        }
    }

    std::vector<int> giro(malla.caras.size(),
                          0); // ±1 respecto a la primera cara de la componente; 0: sin ver
    for (std::size_t primera = 0; primera < malla.caras.size(); ++primera) {
        if (giro[primera])
            continue;
        std::vector<std::size_t> componente = {primera};
        giro[primera] = 1;
        int suma = 0;
        bool orientable = true;
        for (std::size_t i = 0; i < componente.size(); ++i) {
            const std::size_t c = componente[i];
            suma += giro[c];
            for (const Vecina &v : vecinas[c]) {
                const int pedido = v.concorde ? giro[c] : -giro[c];
                if (!giro[v.cara]) {
                    giro[v.cara] = pedido;
                    componente.push_back(v.cara);
                } else if (giro[v.cara] != pedido) {
                    orientable = false;
                }
            }
        }
        const int mayoria = suma >= 0 ? 1 : -1;
        for (std::size_t c : componente)
            if (giro[c] != mayoria)
                t.contrarias.push_back(c);

        // En doble precisión y respecto a un punto cercano, para que un origen lejano no se coma las cifras.
        glm::dvec3 centro(0), centroBorde(0);
        double vertices = 0, verticesBorde = 0;
        for (std::size_t c : componente) {
            for (GLuint i : malla.caras[c]) {
                centro += glm::dvec3(malla.vertices[i]);
                ++vertices;
            }
            for (GLuint i : bordeDe[c]) {
                centroBorde += glm::dvec3(malla.vertices[i]);
                ++verticesBorde;
            }
        }
        const bool abierta = verticesBorde > 0;
        centro = abierta ? centroBorde / verticesBorde : centro / vertices;
        double volumen = 0, escala = 0;
        for (std::size_t c : componente) {
            const std::vector<GLuint> &cara = malla.caras[c];
            auto p = [&](std::size_t i) { return glm::dvec3(malla.vertices[cara[i]]) - centro; };
            for (std::size_t i = 2; i < cara.size(); ++i) {
                const glm::dvec3 a = p(0), b = p(i - 1), d = p(i);
                volumen += giro[c] * mayoria * glm::dot(a, glm::cross(b, d));
                escala += glm::length(a) * glm::length(b) * glm::length(d);
            }
        }
        // Los vértices de una malla plana, redondeados a float, no están del todo en su plano.
        const double despreciable = (abierta ? 1e-6 : 1e-12) * escala;
        t.orientables.push_back(orientable);
        t.sentidos.push_back(!orientable || std::fabs(volumen) <= despreciable ? Sentido::INDEFINIDO
                             : volumen > 0                                     ? Sentido::ANTIHORARIO
                                                                               : Sentido::HORARIO);
    }
    std::sort(t.contrarias.begin(), t.contrarias.end());
    return t;
}

/// La malla con las caras contrarias recorridas al revés: todas las de una componente orientable concuerdan.
inline MallaVf concuerda(MallaVf malla, const Topologia &t) {
    for (std::size_t c : t.contrarias)
        std::reverse(malla.caras[c].begin() + 1, malla.caras[c].end());
    return malla;
}

/// Los triángulos de las caras, en su orden y con su giro; una cara de más de tres vértices (convexa) es un
/// abanico desde el primero.
inline std::vector<std::array<GLuint, 3>> triangula(const MallaVf &malla) {
    std::vector<std::array<GLuint, 3>> triangulos;
    for (const std::vector<GLuint> &cara : malla.caras)
        for (std::size_t i = 2; i < cara.size(); ++i)
            triangulos.push_back({cara[0], cara[i - 1], cara[i]});
    return triangulos;
}
