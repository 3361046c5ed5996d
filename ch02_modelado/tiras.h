// Agrupar los triángulos de una malla en tiras (ejercicio 2.2). Sin OpenGL; la usa el programa tiras.
//
// ¿Puede la caja del ejercicio dibujarse con solo una tira? Con esos diez triángulos no: la tira más larga
// cubre ocho (las cuatro paredes, en redondo) y hacen falta dos, de 10 y 4 índices: 14 en lugar de los 30 de
// los triángulos sueltos. Pero basta partir una pared por la otra diagonal (3–8 en vez de 4–7) para que la
// misma caja salga en una de 12: 2 1 3 4 8 1 5 2 6 3 7 8. Y, repitiendo índices, las dos se encadenan en una
// de 16, con triángulos sin área en la unión. La prueba ch02_tiras recorre todas las posibilidades.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

using Triangulo = std::array<std::uint32_t, 3>;
using Tira = std::vector<std::uint32_t>; // n índices: n − 2 triángulos

/// Los triángulos de GL_TRIANGLE_STRIP: en los de lugar impar se intercambian los dos primeros vértices, para
/// que todos giren igual que el primero.
inline std::vector<Triangulo> expandeTira(const Tira &tira) {
    std::vector<Triangulo> triangulos;
    for (std::size_t i = 0; i + 2 < tira.size(); ++i) {
        const std::size_t impar = i % 2;
        triangulos.push_back({tira[i + impar], tira[i + 1 - impar], tira[i + 2]});
    }
    return triangulos;
}

/// Reparte los triángulos en tiras de manera voraz: empieza por el triángulo con menos vecinos libres, que
/// más adelante costaría más aprovechar, y prueba sus tres giros; se queda con el que da la tira más larga.
/// Cada triángulo está en una sola tira y conserva su sentido de giro.
inline std::vector<Tira> hazTiras(const std::vector<Triangulo> &triangulos) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> conArista; // dirigida
    for (std::size_t t = 0; t < triangulos.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i)
            conArista[{triangulos[t][i], triangulos[t][(i + 1) % 3]}].push_back(t);

    std::vector<bool> libre(triangulos.size(), true);
    // Un triángulo libre que recorre la arista de a hacia b, o triangulos.size()
    auto busca = [&](std::uint32_t a, std::uint32_t b) {
        const auto lista = conArista.find({a, b});
        if (lista != conArista.end())
            for (std::size_t t : lista->second)
                if (libre[t])
                    return t;
        return triangulos.size();
    };
    auto vecinosLibres = [&](std::size_t t) {
        int n = 0;
        for (std::size_t i = 0; i < 3; ++i)
            n += busca(triangulos[t][(i + 1) % 3], triangulos[t][i]) != triangulos.size();
        return n;
    };
    // La tira que empieza por el triángulo t girado i lugares; los que usa dejan de estar libres
    auto sigue = [&](std::size_t t, std::size_t i) {
        std::vector<std::size_t> usados = {t};
        Tira tira = {triangulos[t][i], triangulos[t][(i + 1) % 3], triangulos[t][(i + 2) % 3]};
        libre[t] = false;
        for (;;) {
            std::uint32_t a = tira[tira.size() - 2], b = tira.back();
            if (usados.size() % 2 == 1)
                std::swap(a, b);
            const std::size_t siguiente = busca(a, b);
            if (siguiente == triangulos.size())
                return std::make_pair(tira, usados);
            for (std::uint32_t v : triangulos[siguiente])
                if (v != a && v != b)
                    tira.push_back(v);
            libre[siguiente] = false;
            usados.push_back(siguiente);
        }
    };

    std::vector<Tira> tiras;
    for (std::size_t hechos = 0; hechos < triangulos.size();) {
        std::size_t primero = triangulos.size();
        int menos = 4;
        for (std::size_t t = 0; t < triangulos.size() && menos > 0; ++t) {
            const int n = libre[t] ? vecinosLibres(t) : 4;
            if (n < menos) {
                menos = n;
                primero = t;
            }
        }
        Tira mejor;
        std::vector<std::size_t> usadosMejor;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [tira, usados] = sigue(primero, i);
            for (std::size_t t : usados)
                libre[t] = true;
            if (tira.size() > mejor.size()) {
                mejor = tira;
                usadosMejor = usados;
            }
        }
        for (std::size_t t : usadosMejor)
            libre[t] = false;
        hechos += usadosMejor.size();
        tiras.push_back(mejor);
    }
    return tiras;
}
