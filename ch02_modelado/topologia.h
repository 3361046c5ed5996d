// La topología de una malla v/f (ejercicio 2.1): qué aristas son de borde, qué caras giran al revés que las
// demás y en qué sentido giran vistas desde fuera. Sin OpenGL; la usan malla_vf y tiras.
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
    unsigned a, b; // a < b
    int caras;     // 1: de borde; 2: interior; 3 o más: la superficie se cruza o se ramifica ahí
};

struct Topologia {
    std::vector<Arista> aristas;
    std::size_t deBorde = 0, ramificadas = 0; // cuántas aristas son de una sola cara y de tres o más
    std::vector<std::size_t> contrarias;      // caras (desde la 0) que giran al revés que su componente
    std::vector<Sentido> sentidos;            // el de la mayoría de cada componente, vista desde fuera
    std::vector<bool> orientables;            // si todas las caras de la componente pueden concordar
};

namespace topologia {

struct Vecina {
    std::size_t cara;
    bool concorde; // recorre la arista común en el sentido opuesto
};

/// Con quién comparte cada cara una arista de dos caras, y los extremos de las demás aristas suyas, que no se cruzan.
struct Vecindad {
    std::vector<std::vector<Vecina>> vecinas;
    std::vector<std::vector<unsigned>> borde;
};

/// Pone en `t` las aristas de la malla.
inline Vecindad buscaAristas(const MallaVf &malla, Topologia &t) {
    struct Uso {
        std::size_t cara;
        bool directo; // la cara recorre la arista de a hacia b
    };
    std::map<std::pair<unsigned, unsigned>, std::vector<Uso>> usos;
    for (std::size_t c = 0; c < malla.caras.size(); ++c) {
        // E2.1: apunta en usos cada arista de la cara c, y si la recorre desde el vértice de menor número
        const std::vector<unsigned> &cara = malla.caras[c];
        for (std::size_t i = 0; i < cara.size(); ++i) {
            const unsigned p = cara[i], q = cara[(i + 1) % cara.size()];
            usos[std::minmax(p, q)].push_back({c, p < q});
        }
        // fin de E2.1
    }
    Vecindad v = {std::vector<std::vector<Vecina>>(malla.caras.size()),
                  std::vector<std::vector<unsigned>>(malla.caras.size())};
    for (const auto &[extremos, u] : usos) {
        t.aristas.push_back({extremos.first, extremos.second, int(u.size())});
        t.deBorde += u.size() == 1;
        t.ramificadas += u.size() > 2;
        if (u.size() == 2) {
            // E2.1: si las dos caras de la arista giran en el mismo sentido
            const bool concorde = u[0].directo != u[1].directo;
            // de partida: const bool concorde = true;
            // fin de E2.1
            v.vecinas[u[0].cara].push_back({u[1].cara, concorde});
            v.vecinas[u[1].cara].push_back({u[0].cara, concorde});
        } else {
            for (const Uso &uso : u)
                v.borde[uso.cara].insert(v.borde[uso.cara].end(), {extremos.first, extremos.second});
        }
    }
    return v;
}

/// Unas caras unidas y cómo gira cada una: 1 si como la mayoría (en un empate, como la primera) y −1 si al revés.
struct Componente {
    std::vector<std::size_t> caras;
    std::vector<int> giros;
    bool orientable = true;
};

/// La componente de la cara `primera`. `giro` es, de todas las caras de la malla, ±1 respecto a la primera de su
/// componente, o 0 si aún no se ha visto.
inline Componente recorreComponente(std::size_t primera, const Vecindad &v, std::vector<int> &giro) {
    Componente componente = {{primera}, {}, true};
    giro[primera] = 1;
    int suma = 0;
    for (std::size_t i = 0; i < componente.caras.size(); ++i) {
        const std::size_t c = componente.caras[i];
        suma += giro[c];
        for (const Vecina &vecina : v.vecinas[c]) {
            const int pedido = vecina.concorde ? giro[c] : -giro[c];
            if (!giro[vecina.cara]) {
                giro[vecina.cara] = pedido;
                componente.caras.push_back(vecina.cara);
            } else if (giro[vecina.cara] != pedido) {
                componente.orientable = false;
            }
        }
    }
    for (std::size_t c : componente.caras)
        componente.giros.push_back(suma >= 0 ? giro[c] : -giro[c]);
    return componente;
}

/// El centroide de los vértices de las listas de esas caras, cada uno tantas veces como salga.
inline glm::dvec3 centroide(const MallaVf &malla, const std::vector<std::size_t> &caras,
                            const std::vector<std::vector<unsigned>> &listas) {
    glm::dvec3 suma(0);
    double n = 0;
    for (std::size_t c : caras)
        for (unsigned i : listas[c]) {
            suma += glm::dvec3(malla.vertices[i]);
            ++n;
        }
    return suma / n;
}

/// El signo del volumen que encierra la componente, con sus caras concordes. Si es abierta, el volumen que encerraría
/// con una tapa en abanico desde el centroide de su borde.
inline Sentido sentidoDesdeFuera(const MallaVf &malla, const Componente &componente, const Vecindad &v) {
    const bool abierta = std::any_of(componente.caras.begin(), componente.caras.end(),
                                     [&v](std::size_t c) { return !v.borde[c].empty(); });
    // En doble precisión y respecto a un punto cercano, para que un origen lejano no se coma las cifras.
    const glm::dvec3 centro = centroide(malla, componente.caras, abierta ? v.borde : malla.caras);
    double volumen = 0, escala = 0;
    for (std::size_t k = 0; k < componente.caras.size(); ++k) {
        const std::vector<unsigned> &cara = malla.caras[componente.caras[k]];
        const auto p = [&](std::size_t i) { return glm::dvec3(malla.vertices[cara[i]]) - centro; };
        for (std::size_t i = 2; i < cara.size(); ++i) {
            const glm::dvec3 a = p(0), b = p(i - 1), d = p(i);
            // E2.1: suma el volumen, con signo, de a, b y d con el centro; una cara al revés lo cuenta del otro signo
            volumen += componente.giros[k] * glm::dot(a, glm::cross(b, d));
            // fin de E2.1
            escala += glm::length(a) * glm::length(b) * glm::length(d);
        }
    }
    // Los vértices de una malla plana, redondeados a float, no están del todo en su plano.
    const double despreciable = (abierta ? 1e-6 : 1e-12) * escala;
    if (!componente.orientable || std::fabs(volumen) <= despreciable)
        return Sentido::INDEFINIDO;
    return volumen > 0 ? Sentido::ANTIHORARIO : Sentido::HORARIO;
}

} // namespace topologia

/// Analiza la malla. Dos caras que comparten una arista (y solo ellas dos) concuerdan si la recorren en
/// sentidos opuestos; una componente son las caras a las que se llega cruzando esas aristas. «El resto» es
/// la mayoría de la componente y, en un empate, lo que diga su primera cara.
inline Topologia analizaTopologia(const MallaVf &malla) {
    using namespace topologia;
    Topologia t;
    const Vecindad vecindad = buscaAristas(malla, t);
    std::vector<int> giro(malla.caras.size(), 0);
    for (std::size_t primera = 0; primera < malla.caras.size(); ++primera) {
        if (giro[primera])
            continue;
        const Componente componente = recorreComponente(primera, vecindad, giro);
        for (std::size_t k = 0; k < componente.caras.size(); ++k)
            if (componente.giros[k] < 0)
                t.contrarias.push_back(componente.caras[k]);
        t.orientables.push_back(componente.orientable);
        t.sentidos.push_back(sentidoDesdeFuera(malla, componente, vecindad));
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
inline std::vector<std::array<unsigned, 3>> triangula(const MallaVf &malla) {
    std::vector<std::array<unsigned, 3>> triangulos;
    for (const std::vector<unsigned> &cara : malla.caras)
        for (std::size_t i = 2; i < cara.size(); ++i)
            triangulos.push_back({cara[0], cara[i - 1], cara[i]});
    return triangulos;
}
