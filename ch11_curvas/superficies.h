// Superficies bicúbicas de Hermite, Bézier y B-Spline (§11.5 a §11.8): puntos, derivadas, normales y triángulos.
// Sin OpenGL. La tetera (ch02_modelado/bezier.h) toma de aquí la normal, pero evalúa sus parches con pesos que se suman
// en otro orden: allí un lado compartido por dos parches que lo recorren al revés ha de dar los mismos puntos, bit a
// bit.
#pragma once
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

/// El largo de un vector: glm::length no admite la cuádruple precisión.
template<typename T>
T largo(const Punto<T> &a) {
    using std::sqrt;
    return sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
}

/// Normal unitaria, hacia donde apunta Q_u × Q_v, de una superficie de talla 1; `d(u, v, du, dv)` es su derivada, du
/// veces con u y dv con v. Donde Q_u × Q_v se anula, porque un lado se reduce a un punto o falta una tangente, su
/// límite camino del centro: su derivada en esa dirección. Si también se anula, la del primer punto de ese camino que
/// la tenga; y si no la tiene ninguno, porque no es una superficie, +Z.
template<typename T, typename Derivada>
Punto<T> normalOLimite(const Derivada &d, const T &u, const T &v) {
    using std::sqrt;
    const auto cruz = [](const Punto<T> &a, const Punto<T> &b) {
        return Punto<T>(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
    };
    const T nada = sqrt(std::numeric_limits<T>::epsilon());
    for (const double paso : {0.0, 1.0 / 64, 1.0 / 16, 1.0 / 4, 1.0 / 2}) {
        const T a = T(0.5) - u, b = T(0.5) - v, s = u + T(paso) * a, t = v + T(paso) * b;
        const Punto<T> qu = d(s, t, 1, 0), qv = d(s, t, 0, 1), n = cruz(qu, qv);
        const T lu = largo(qu), lv = largo(qv);
        if (lu > nada && lv > nada && largo(n) > nada * lu * lv)
            return (T(1) / largo(n)) * n;
        const Punto<T> quv = d(s, t, 1, 1),
                       limite = cruz(a * d(s, t, 2, 0) + b * quv, qv) + cruz(qu, a * quv + b * d(s, t, 0, 2));
        if (largo(limite) > nada)
            return (T(1) / largo(limite)) * limite;
    }
    return Punto<T>(T(0), T(0), T(1));
}

/// La normal de la superficie, o su límite.
template<typename T>
Punto<T> normalSuperficie(Base base, const Geometria2<T> &G, const T &u, const T &v) {
    const Geometria2<T> B = aBezier2(base, G);
    T talla(0);
    for (const Geometria<T> &fila : B)
        for (const Punto<T> &p : fila)
            talla = std::max(talla, largo(p - B[0][0]));
    const T escala = talla > T(0) ? T(1) / talla : T(0);
    const auto d = [&](const T &s, const T &t, int du, int dv) -> Punto<T> {
        return escala * superficie(base, G, s, t, du, dv);
    };
    return normalOLimite(d, u, v);
}

/// Segmentos de u y de v.
struct Segmentos {
    int u, v;
};

/// Los que dejan la superficie a menos de `tolerancia` de sus triángulos: un triángulo rectángulo de catetos h y k se
/// separa como mucho (Muu·h² + 2·Muv·h·k + Mvv·k²)/8 (Filip, Magedson y Markot, 1986), y 2hk ≤ h² + k². Se cumple
/// mientras no hagan falta más de 256.
inline Segmentos segmentosSuperficie(Base base, const Geometria2<float> &G, double tolerancia) {
    const Geometria2<float> B = aBezier2(base, G);
    double muu = 0, muv = 0, mvv = 0;
    const auto p = [&](std::size_t i, std::size_t j) { return glm::dvec3(B[i][j]); };
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
            if (i < 2)
                muu = std::max(muu, 6 * glm::length(p(i + 2, j) - 2.0 * p(i + 1, j) + p(i, j)));
            if (j < 2)
                mvv = std::max(mvv, 6 * glm::length(p(i, j + 2) - 2.0 * p(i, j + 1) + p(i, j)));
            if (i < 3 && j < 3)
                muv = std::max(muv, 9 * glm::length(p(i + 1, j + 1) - p(i + 1, j) - p(i, j + 1) + p(i, j)));
        }
    const auto n = [&](double m) { return std::min(segmentosDerivada(2 * m, tolerancia), 256); };
    return {n(muu + muv), n(mvv + muv)};
}

/// La superficie en triángulos, que giran en sentido antihorario vistos desde donde apunta la normal; coordTextura es
/// (u, v).
inline Malla mallaSuperficie(Base base, const Geometria2<float> &G, const Segmentos &n) {
    Malla malla;
    for (int j = 0; j <= n.v; ++j)
        for (int i = 0; i <= n.u; ++i) {
            const float u = float(i) / float(n.u), v = float(j) / float(n.v);
            malla.vertices.push_back({superficie(base, G, u, v), normalSuperficie(base, G, u, v), {u, v}});
            if (i == n.u || j == n.v)
                continue;
            const unsigned a = j * (n.u + 1) + i, d = a + n.u + 1;
            malla.indices.insert(malla.indices.end(), {a, a + 1, d + 1, a, d + 1, d});
        }
    return malla;
}
