// Agrupar los triángulos de una malla en tiras (ejercicio 2.2). Sin OpenGL; la usa el programa tiras.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

using Triangulo = std::array<std::uint32_t, 3>;
using Tira = std::vector<std::uint32_t>; // n índices: n − 2 triángulos

/// La caja del ejercicio en una sola tira, de las dos maneras en que se puede (docs/soluciones.md): con una pared
/// partida por la otra diagonal, 3–8 en vez de 4–7 (2 1 3 4 8 1 5 2 6 3 7 8), y con un índice repetido, que añade un
/// triángulo sin área, 4 7 4 (2 1 3 4 7 4 8 1 5 2 6 3 7).
const Tira TIRAS_UNICAS[] = {{1, 0, 2, 3, 7, 0, 4, 1, 5, 2, 6, 7}, {1, 0, 2, 3, 6, 3, 7, 0, 4, 1, 5, 2, 6}};
const std::size_t DIAGONAL_NUEVA[] = {2, 7}; // la de la primera

/// El reparto de hazTiras a medias: qué triángulos quedan libres y, de cada uno, cuántos vecinos libres tiene.
class RepartoEnTiras {
public:
    explicit RepartoEnTiras(const std::vector<Triangulo> &losTriangulos)
        : triangulos(losTriangulos), libre(triangulos.size(), true), vecinos(triangulos.size(), 0) {
        for (std::size_t t = 0; t < triangulos.size(); ++t)
            for (std::size_t i = 0; i < 3; ++i)
                conArista[{triangulos[t][i], triangulos[t][(i + 1) % 3]}].push_back(t);
        for (std::size_t t = 0; t < triangulos.size(); ++t) {
            cuentaVecinos(t);
            libres.insert({vecinos[t], t});
        }
    }

    bool quedan() const {
        return !libres.empty();
    }

    /// La mejor tira que empieza por el triángulo libre con menos vecinos libres; sus triángulos dejan de estarlo.
    Tira saca() {
        const std::size_t primero = libres.begin()->second;
        Recorrido mejor;
        for (std::size_t i = 0; i < 3; ++i) {
            Recorrido otro = recorre(primero, i);
            if (otro.tira.size() > mejor.tira.size())
                mejor = std::move(otro);
        }
        for (std::size_t t : mejor.usados) {
            libres.erase({vecinos[t], t});
            libre[t] = false;
        }
        for (std::size_t t : mejor.usados)
            actualizaVecinos(t);
        return mejor.tira;
    }

private:
    struct Recorrido {
        Tira tira;
        std::vector<std::size_t> usados;
    };

    const std::vector<Triangulo> &triangulos;
    std::vector<bool> libre;
    std::vector<int> vecinos;                     // libres
    std::set<std::pair<int, std::size_t>> libres; // (vecinos, triángulo)
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> conArista; // dirigida

    /// Un triángulo libre que recorre la arista de a hacia b, o triangulos.size().
    std::size_t busca(std::uint32_t a, std::uint32_t b) const {
        const auto lista = conArista.find({a, b});
        if (lista != conArista.end())
            for (std::size_t t : lista->second)
                if (libre[t])
                    return t;
        return triangulos.size();
    }

    void cuentaVecinos(std::size_t t) {
        vecinos[t] = 0;
        for (std::size_t i = 0; i < 3; ++i)
            vecinos[t] += busca(triangulos[t][(i + 1) % 3], triangulos[t][i]) != triangulos.size();
    }

    /// El triángulo t ya no está libre: sus vecinos tienen uno menos.
    void actualizaVecinos(std::size_t t) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto lista = conArista.find({triangulos[t][(i + 1) % 3], triangulos[t][i]});
            if (lista == conArista.end())
                continue;
            for (std::size_t vecino : lista->second)
                if (libre[vecino]) {
                    libres.erase({vecinos[vecino], vecino});
                    cuentaVecinos(vecino);
                    libres.insert({vecinos[vecino], vecino});
                }
        }
    }

    /// La tira que empieza por el triángulo t girado i lugares.
    Recorrido recorre(std::size_t t, std::size_t i) {
        Recorrido r = {{triangulos[t][i], triangulos[t][(i + 1) % 3], triangulos[t][(i + 2) % 3]}, {}};
        // E2.2: alarga la tira mientras haya un triángulo libre que la siga; los que pone en ella dejan de estarlo
        while (t != triangulos.size()) {
            libre[t] = false;
            r.usados.push_back(t);
            // la arista de los dos últimos vértices, como la recorre el triángulo siguiente: una vez en cada sentido
            std::uint32_t a = r.tira[r.tira.size() - 2], b = r.tira.back();
            if (r.usados.size() % 2 == 1)
                std::swap(a, b);
            t = busca(a, b);
            if (t != triangulos.size())
                r.tira.push_back(*std::find_if(triangulos[t].begin(), triangulos[t].end(),
                                               [a, b](std::uint32_t v) { return v != a && v != b; }));
        }
        // de partida: r.usados.push_back(t);
        // fin de E2.2
        for (std::size_t usado : r.usados)
            libre[usado] = true;
        return r;
    }
};

/// Reparte los triángulos en tiras de manera voraz: empieza por el triángulo con menos vecinos libres, que
/// más adelante costaría más aprovechar, y prueba sus tres giros; se queda con el que da la tira más larga.
/// Cada triángulo está en una sola tira y conserva su sentido de giro.
inline std::vector<Tira> hazTiras(const std::vector<Triangulo> &triangulos) {
    std::vector<Tira> tiras;
    for (RepartoEnTiras reparto(triangulos); reparto.quedan();)
        tiras.push_back(reparto.saca());
    return tiras;
}
