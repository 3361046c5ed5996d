// Superficies bicúbicas de Hermite, Bézier y B-Spline (§11.5 a §11.8): puntos, derivadas, normales y triángulos.
// Sin OpenGL. La tetera (ch02_modelado/bezier.h) evalúa sus parches con pesos que se suman en otro orden: allí un lado
// compartido por dos parches que lo recorren al revés ha de dar los mismos puntos, bit a bit.
#pragma once
#include "ch02_modelado/normal_limite.h"
#include "curvas.h"
#include "malla.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

/// La matriz de geometría (ecuación 11.32): g[i][j], i con u y j con v.
template<typename T>
using Geometria2 = std::array<Geometria<T>, 4>;

/// Q(u, v) = U M G Mᵀ Vᵀ (ecuación 11.31), o su derivada: `du` veces con u y `dv` con v.
template<typename T>
Punto<T> superficie(Base base, const Geometria2<T> &G, const T &u, const T &v, int du = 0, int dv = 0) {
    const Pesos<T> wu = pesos(base, u, du), wv = pesos(base, v, dv);
    const std::size_t puntos = puntosDe(base);
    Punto<T> suma(T(0));
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4;
             ++j) // como en cubica, una derivada se calcula lejos de un origen lejano
            suma += (wu[i] * wv[j]) * (du + dv > 0 && i < puntos && j < puntos ? G[i][j] - G[0][0] : G[i][j]);
    return suma;
}

/// Los 16 puntos de control de Bézier de la misma superficie.
template<typename T>
Geometria2<T> aBezier2(Base base, const Geometria2<T> &G) {
    Geometria2<T> filas, B;
    for (std::size_t i = 0; i < 4; ++i)
        filas[i] = aBezier(base, G[i]);
    for (std::size_t j = 0; j < 4; ++j) {
        const Geometria<T> columna = aBezier<T>(base, {filas[0][j], filas[1][j], filas[2][j], filas[3][j]});
        for (std::size_t i = 0; i < 4; ++i)
            B[i][j] = columna[i];
    }
    return B;
}

// ---- Superficies de Bézier de cualquier grado ----

/// Los (n + 1)×(m + 1) puntos de control, fila a fila: la fila va con u y la columna con v.
template<typename T>
struct RedBezier {
    std::size_t n, m;
    std::vector<Punto<T>> P;

    const Punto<T> &en(std::size_t i, std::size_t j) const {
        return P[i * (m + 1) + j];
    }
    std::vector<Punto<T>> fila(std::size_t i) const {
        return {&en(i, 0), &en(i, 0) + m + 1};
    }
};

/// Q(u, v) (ecuación 11.41) o una derivada suya.
template<typename T>
Punto<T> superficie(const RedBezier<T> &red, const T &u, const T &v, int du = 0, int dv = 0) {
    const std::vector<T> bu = bernstein(red.n, u, du), bv = bernstein(red.m, v, dv);
    Punto<T> suma(T(0));
    for (std::size_t i = 0; i <= red.n; ++i)
        for (std::size_t j = 0; j <= red.m; ++j)
            suma += (bu[i] * bv[j]) * (du + dv > 0 ? red.en(i, j) - red.P[0] : red.en(i, j));
    return suma;
}

/// G(v) (ecuación 11.28): la superficie es la familia de las curvas de Bézier en u cuyos puntos de control recorren, al
/// cambiar v, las curvas de las filas de la red.
template<typename T>
std::vector<Punto<T>> geometriaEn(const RedBezier<T> &red, const T &v) {
    std::vector<Punto<T>> G;
    for (std::size_t i = 0; i <= red.n; ++i)
        G.push_back(bezier(red.fila(i), v));
    return G;
}

/// Los 16 puntos de control de Bézier de una superficie bicúbica, como red.
template<typename T>
RedBezier<T> redDe(Base base, const Geometria2<T> &G) {
    RedBezier<T> red = {3, 3, {}};
    for (const Geometria<T> &fila : aBezier2(base, G))
        red.P.insert(red.P.end(), fila.begin(), fila.end());
    return red;
}

// ---- Normales ----

/// 1/talla de lo que ocupan los puntos de control.
template<typename T>
T escalaDe(const RedBezier<T> &red) {
    T talla(0);
    for (const Punto<T> &p : red.P)
        talla = std::max(talla, largo(p - red.P[0]));
    return talla > T(0) ? T(1) / talla : T(0);
}

/// La normal de la superficie, o su límite.
template<typename T>
Punto<T> normalSuperficie(const RedBezier<T> &red, const T &u, const T &v) {
    const T escala = escalaDe(red);
    return normalOLimite([&](const T &s, const T &t, int du,
                             int dv) -> Punto<T> { return escala * superficie(red, s, t, du, dv); },
                         u, v);
}
template<typename T>
Punto<T> normalSuperficie(Base base, const Geometria2<T> &G, const T &u, const T &v) {
    const T escala = escalaDe(redDe(base, G));
    return normalOLimite([&](const T &s, const T &t, int du,
                             int dv) -> Punto<T> { return escala * superficie(base, G, s, t, du, dv); },
                         u, v);
}

// ---- Triángulos ----

/// Segmentos de u y de v.
struct Segmentos {
    int u, v;
};

/// Los que dejan la superficie a menos de `tolerancia` de sus triángulos: un triángulo rectángulo de catetos h y k se
/// separa como mucho (Muu·h² + 2·Muv·h·k + Mvv·k²)/8 (Filip, Magedson y Markot, 1986), y 2hk ≤ h² + k². Se cumple
/// mientras no hagan falta más de 256.
inline Segmentos segmentosSuperficie(const RedBezier<float> &red, double tolerancia) {
    const double n = double(red.n), m = double(red.m);
    double muu = 0, muv = 0, mvv = 0;
    const auto p = [&](std::size_t i, std::size_t j) { return glm::dvec3(red.en(i, j)); };
    for (std::size_t i = 0; i <= red.n; ++i)
        for (std::size_t j = 0; j <= red.m; ++j) {
            if (i + 2 <= red.n)
                muu = std::max(muu, n * (n - 1) * glm::length(p(i + 2, j) - 2.0 * p(i + 1, j) + p(i, j)));
            if (j + 2 <= red.m)
                mvv = std::max(mvv, m * (m - 1) * glm::length(p(i, j + 2) - 2.0 * p(i, j + 1) + p(i, j)));
            if (i < red.n && j < red.m)
                muv =
                    std::max(muv, n * m * glm::length(p(i + 1, j + 1) - p(i + 1, j) - p(i, j + 1) + p(i, j)));
        }
    const auto segmentos = [&](double M) { return std::min(segmentosDerivada(2 * M, tolerancia), 256); };
    return {segmentos(muu + muv), segmentos(mvv + muv)};
}
inline Segmentos segmentosSuperficie(Base base, const Geometria2<float> &G, double tolerancia) {
    return segmentosSuperficie(redDe(base, G), tolerancia);
}

/// Los triángulos de vertice(u, v), que giran en sentido antihorario vistos desde donde apunta Q_u × Q_v.
template<typename UnVertice>
Malla mallaDe(const UnVertice &vertice, const Segmentos &n) {
    Malla malla;
    for (int j = 0; j <= n.v; ++j)
        for (int i = 0; i <= n.u; ++i) {
            malla.vertices.push_back(vertice(float(i) / float(n.u), float(j) / float(n.v)));
            if (i == n.u || j == n.v)
                continue;
            const unsigned a = j * (n.u + 1) + i;
            const unsigned d = a + n.u + 1;
            malla.indices.insert(malla.indices.end(), {a, a + 1, d + 1, a, d + 1, d});
        }
    return malla;
}

/// La superficie en triángulos; coordTextura es (u, v).
inline Malla mallaSuperficie(const RedBezier<float> &red, const Segmentos &n) {
    return mallaDe(
        [&](float u, float v) -> Vertice {
            return {superficie(red, u, v), normalSuperficie(red, u, v), {u, v}};
        },
        n);
}
inline Malla mallaSuperficie(Base base, const Geometria2<float> &G, const Segmentos &n) {
    return mallaDe(
        [&](float u, float v) -> Vertice {
            return {superficie(base, G, u, v), normalSuperficie(base, G, u, v), {u, v}};
        },
        n);
}
