// Parches de Bézier bicúbicos (figuras 2.1 y 2.2; la teoría es el capítulo 11): puntos, derivadas y normales,
// y triangulación con un error de cuerda acotado. Sin OpenGL; la usan tetera y los programas que la dibujan.
#pragma once
#include "error.h"
#include "malla.h"
#include "normal_limite.h"
#include "numero.h"
#include "rutas.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <istream>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

/// Puntos de control p[fila][columna]: u en [0,1] recorre una fila y v en [0,1] va de la fila 0 a la 3.
struct Parche {
    glm::dvec3 p[4][4];
};

/// Segmentos en que se divide un parche a lo largo de u y de v.
struct Division {
    int nu, nv;
};

namespace parche {

using Pesos = std::array<double, 4>;

/// Polinomios de Bernstein de grado 3 y sus dos primeras derivadas; c = 1 − t. Cambiar t por c da los mismos
/// pesos en orden inverso, bit a bit.
inline Pesos pesos0(double t, double c) {
    return {(c * c) * c, 3 * ((c * c) * t), 3 * ((t * t) * c), (t * t) * t};
}
inline Pesos pesos1(double t, double c) {
    return {-3 * (c * c), 3 * (c * c) - 6 * (t * c), 6 * (t * c) - 3 * (t * t), 3 * (t * t)};
}
inline Pesos pesos2(double t, double c) {
    return {6 * c, 6 * t - 12 * c, 6 * c - 12 * t, 6 * t};
}

/// Punto de una curva. El orden de la suma hace que recorrerla al revés dé el mismo punto, bit a bit; una
/// curva que es un punto da ese punto, sin redondeo.
inline glm::dvec3 curva(const glm::dvec3 &a, const glm::dvec3 &b, const glm::dvec3 &c, const glm::dvec3 &d,
                        const Pesos &w) {
    return a == b && b == c && c == d ? a : (w[0] * a + w[3] * d) + (w[1] * b + w[2] * c);
}

inline glm::dvec3 posicion(const Parche &q, const Pesos &u, const Pesos &v) {
    const auto fila = [&](int i) { return curva(q.p[i][0], q.p[i][1], q.p[i][2], q.p[i][3], u); };
    return curva(fila(0), fila(1), fila(2), fila(3), v);
}

/// Una derivada: los pesos suman cero, así que restar antes un punto de control no la cambia y evita que un
/// origen lejano se coma las cifras.
inline glm::dvec3 derivada(const Parche &q, const Pesos &u, const Pesos &v) {
    glm::dvec3 suma(0);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            suma += v[i] * u[j] * (q.p[i][j] - q.p[0][0]);
    return suma;
}

/// Normal unitaria o, donde du × dv se anula porque una frontera del parche se reduce a un punto, su límite.
inline glm::dvec3 normal(const Parche &q, double u, double v) {
    double talla = 0;
    for (const auto &fila : q.p)
        for (const glm::dvec3 &p : fila)
            talla = std::max(talla, glm::length(p - q.p[0][0]));
    const double escala = talla > 0 ? 1 / talla : 0;
    const auto enT = [](double t, int veces) {
        if (veces == 0)
            return pesos0(t, 1 - t);
        return veces == 1 ? pesos1(t, 1 - t) : pesos2(t, 1 - t);
    };
    const auto d = [&](double s, double t, int du, int dv) -> glm::dvec3 {
        return escala * derivada(q, enT(s, du), enT(t, dv));
    };
    return normalOLimite(d, u, v);
}

} // namespace parche

/// División que deja el parche a menos de `tolerancia` de sus triángulos. Un triángulo rectángulo de catetos
/// h y k en (u, v) se separa de la superficie como mucho (Muu·h² + 2·Muv·h·k + Mvv·k²)/8, con M la mayor
/// segunda derivada (Filip, Magedson y Markot, 1986), y esa está acotada por las segundas diferencias de los
/// puntos de control. Como 2hk ≤ h² + k², basta h² ≤ 4·tolerancia/(Muu + Muv), y lo mismo con k y Mvv.
/// Se cumple mientras no hagan falta más de 1024 segmentos.
inline Division divisionPara(const Parche &q, double tolerancia) {
    double muu = 0, muv = 0, mvv = 0;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            if (j < 2)
                muu = std::max(muu, 6 * glm::length(q.p[i][j + 2] - 2.0 * q.p[i][j + 1] + q.p[i][j]));
            if (i < 2)
                mvv = std::max(mvv, 6 * glm::length(q.p[i + 2][j] - 2.0 * q.p[i + 1][j] + q.p[i][j]));
            if (i < 3 && j < 3)
                muv = std::max(
                    muv, 9 * glm::length((q.p[i + 1][j + 1] - q.p[i + 1][j]) - (q.p[i][j + 1] - q.p[i][j])));
        }
    const auto segmentos = [tolerancia](double m) {
        return int(std::clamp(std::ceil(std::sqrt(m / (4 * tolerancia))), 1.0, 1024.0));
    };
    return {segmentos(muu + muv), segmentos(mvv + muv)};
}

/// Divisiones de varios parches que casan: los que comparten una frontera la dividen igual, y la división de
/// un lado es la del opuesto, así que el mayor número pedido corre por toda la tira de parches.
inline std::vector<Division> divisionesPara(const std::vector<Parche> &parches, double tolerancia) {
    // Familias de lados que deben dividirse igual: la 2k son los lados u del parche k, y la 2k+1, los v.
    std::vector<std::size_t> padre(2 * parches.size());
    std::iota(padre.begin(), padre.end(), std::size_t{0});
    const auto raiz = [&padre](std::size_t f) {
        while (padre[f] != f)
            f = padre[f];
        return f;
    };
    const auto menor = [](const glm::dvec3 &a, const glm::dvec3 &b) {
        return std::make_tuple(a.x, a.y, a.z) < std::make_tuple(b.x, b.y, b.z);
    };
    using Lado = std::array<glm::dvec3, 4>;
    const auto ladoMenor = [menor](const Lado &a, const Lado &b) {
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), menor);
    };
    std::map<Lado, std::size_t, decltype(ladoMenor)> familia(ladoMenor);
    for (std::size_t k = 0; k < parches.size(); ++k) {
        const auto &p = parches[k].p;
        for (int i : {0, 3})
            for (std::size_t direccion : {0u, 1u}) {
                Lado lado = direccion == 0 ? Lado{p[i][0], p[i][1], p[i][2], p[i][3]}
                                           : Lado{p[0][i], p[1][i], p[2][i], p[3][i]};
                if (lado[0] == lado[1] && lado[1] == lado[2] && lado[2] == lado[3])
                    continue; // un punto se divide de cualquier manera
                const Lado reves = {lado[3], lado[2], lado[1], lado[0]};
                if (ladoMenor(reves, lado))
                    lado = reves;
                const std::size_t f = familia.emplace(lado, 2 * k + direccion).first->second;
                padre[raiz(2 * k + direccion)] = raiz(f);
            }
    }
    std::vector<int> segmentos(padre.size(), 1);
    for (std::size_t k = 0; k < parches.size(); ++k) {
        const Division d = divisionPara(parches[k], tolerancia);
        segmentos[raiz(2 * k)] = std::max(segmentos[raiz(2 * k)], d.nu);
        segmentos[raiz(2 * k + 1)] = std::max(segmentos[raiz(2 * k + 1)], d.nv);
    }
    std::vector<Division> divisiones;
    for (std::size_t k = 0; k < parches.size(); ++k)
        divisiones.push_back({segmentos[raiz(2 * k)], segmentos[raiz(2 * k + 1)]});
    return divisiones;
}

/// Superficie triangulada; coordTextura es (u, v) en cada parche. `cuadricula` es, de cada vértice, su columna y su
/// fila: los lados de los cuadriláteros están donde una de las dos es entera, y la diagonal que parte en dos cada uno,
/// donde lo es su diferencia.
struct Teselacion {
    Malla malla;
    std::vector<glm::vec2> cuadricula;
};

/// Triangula los parches a menos de `tolerancia` (mayor que 0, en las unidades de los puntos de control; más
/// el redondeo a float de los vértices). Los parches vecinos comparten los puntos de su frontera bit a bit:
/// no hay grietas. Los triángulos giran en sentido antihorario vistos desde donde apunta du × dv.
inline Teselacion teselaParches(const std::vector<Parche> &parches, double tolerancia) {
    Teselacion t;
    std::vector<Vertice> &vertices = t.malla.vertices;
    const auto triangulo = [&](unsigned a, unsigned b, unsigned c) {
        const glm::vec3 &p = vertices[a].posicion, &q = vertices[b].posicion, &r = vertices[c].posicion;
        if (p != q && q != r && r != p)
            t.malla.indices.insert(t.malla.indices.end(), {a, b, c});
    };
    const std::vector<Division> divisiones = divisionesPara(parches, tolerancia);
    for (std::size_t k = 0; k < parches.size(); ++k) {
        const int nu = divisiones[k].nu, nv = divisiones[k].nv;
        const unsigned base = unsigned(vertices.size());
        for (int j = 0; j <= nv; ++j)
            for (int i = 0; i <= nu; ++i) {
                // 1 − i/n redondea distinto que (n − i)/n, y el parche vecino puede recorrer el lado al revés
                const double u = double(i) / nu, uc = double(nu - i) / nu, v = double(j) / nv,
                             vc = double(nv - j) / nv;
                vertices.push_back(
                    {parche::posicion(parches[k], parche::pesos0(u, uc), parche::pesos0(v, vc)),
                     parche::normal(parches[k], u, v),
                     {u, v}});
                t.cuadricula.push_back({i, j});
            }
        for (int j = 0; j < nv; ++j)
            for (int i = 0; i < nu; ++i) {
                const unsigned a = base + j * (nu + 1) + i;
                const unsigned b = a + 1, d = a + nu + 1;
                const unsigned c = d + 1;
                triangulo(a, b, c);
                triangulo(a, c, d);
            }
    }
    return t;
}

/// Lee los parches de un fichero del laboratorio (assets/tetera.txt explica el formato). Un error termina
/// diciendo fichero, línea y qué se esperaba.
inline std::vector<Parche> leeParches(const std::string &relativa) {
    std::vector<glm::dvec3> puntos;
    std::vector<Parche> parches;
    const auto linea = [&](const std::string &tipo, std::istream &palabras, const Queja &mal) {
        if (tipo == "v") {
            const std::optional<glm::dvec3> p = leePunto(palabras);
            if (!p)
                mal("un punto de control son tres números");
            puntos.push_back(*p);
        } else if (tipo == "p") {
            Parche q;
            std::string palabra;
            for (auto &fila : q.p)
                for (glm::dvec3 &p : fila) {
                    const auto i = palabras >> palabra ? numeroDe<std::size_t>(palabra) : std::nullopt;
                    if (!i || *i < 1 || *i > puntos.size())
                        mal("un parche son dieciséis puntos entre el 1 y el " +
                            std::to_string(puntos.size()));
                    p = puntos[*i - 1];
                }
            if (palabras >> palabra)
                mal("un parche son dieciséis puntos y sobra «" + palabra + "»");
            parches.push_back(q);
        } else {
            mal("cada línea empieza por v o por p");
        }
    };
    leeLineas(recurso(relativa), relativa, linea);
    if (parches.empty())
        falla("«" + relativa + "» no tiene ningún parche");
    return parches;
}
