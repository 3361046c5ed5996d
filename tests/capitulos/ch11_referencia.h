// La referencia del capítulo 11: U·M·G con las matrices del libro (ecuaciones 11.10, 11.17 y 11.26) en la precisión que
// se pida.
#pragma once
#include "azar.h"
#include "ch11_curvas/superficies.h"
#include "contra_oraculo.h"
#include "oraculo/cuadruple.h"

/// Tantos redondeos de T; de la cuádruple, el doble, que la referencia también redondea.
template<typename T>
double redondeos(double n) {
    return n * double(std::numeric_limits<T>::epsilon()) * (std::is_same_v<T, Cuadruple> ? 2 : 1);
}
/// El mayor; con un NaN, infinito.
inline double mayor(double a, double b) {
    return b <= a ? a : std::isnan(b) ? INFINITY : b;
}

const Base BASES[] = {Base::HERMITE, Base::BEZIER, Base::BSPLINE};

/// U·M, con U = (u³, u², u, 1), o una derivada suya.
template<typename R>
Pesos<R> pesosRef(Base base, const R &u, int derivada = 0) {
    static const int M[3][4][4] = {{{2, -2, 1, 1}, {-3, 3, -2, -1}, {0, 0, 1, 0}, {1, 0, 0, 0}},
                                   {{-1, 3, -3, 1}, {3, -6, 3, 0}, {-3, 3, 0, 0}, {1, 0, 0, 0}},
                                   {{-1, 3, -3, 1}, {3, -6, 3, 0}, {-3, 0, 3, 0}, {1, 4, 1, 0}}};
    Pesos<R> w{};
    for (int fila = 0, n = 3; fila < 4; ++fila, --n) {
        R potencia(n < derivada ? 0 : 1);
        for (int k = 0; k < n; ++k)
            potencia = potencia * (k < derivada ? R(n - k) : u);
        for (std::size_t j = 0; j < 4; ++j)
            w[j] += potencia * R(M[int(base)][fila][j]);
    }
    for (R &x : w)
        x = x / R(base == Base::BSPLINE ? 6 : 1);
    return w;
}
template<typename R, typename T>
Punto<R> curvaRef(Base base, const Geometria<T> &G, const R &u, int derivada = 0) {
    const Pesos<R> w = pesosRef(base, u, derivada);
    return w[0] * Punto<R>(G[0]) + w[1] * Punto<R>(G[1]) + w[2] * Punto<R>(G[2]) + w[3] * Punto<R>(G[3]);
}
/// U·M·G·Mᵀ·Vᵀ (ecuación 11.31) o una derivada suya.
template<typename R, typename T>
Punto<R> superficieRef(Base base, const Geometria2<T> &G, const R &u, const R &v, int du = 0, int dv = 0) {
    const auto fila = [&](std::size_t i) { return curvaRef(base, G[i], v, dv); };
    return curvaRef(base, Geometria<R>{fila(0), fila(1), fila(2), fila(3)}, u, du);
}

/// Lo que se separan dos puntos.
template<typename T, typename R>
double lejos(const Punto<T> &a, const Punto<R> &b) {
    return glm::length(glm::dvec3(Punto<Cuadruple>(a) - Punto<Cuadruple>(b)));
}

/// La red que en la fila i y la columna j tiene punto(i, j).
template<typename T = double, typename Da>
Geometria2<T> redDe(const Da &punto) {
    Geometria2<T> G;
    for (std::size_t k = 0; k < 16; ++k)
        G[k / 4][k % 4] = Punto<T>(punto(k / 4, k % 4));
    return G;
}

/// Con cada coordenada entre −1 y 1, de diez cifras binarias: las mismas en todas las precisiones.
template<typename T>
std::vector<Punto<T>> puntosAlAzar(std::size_t n, unsigned semilla = 11) {
    Azar azar(semilla);
    std::vector<Punto<T>> P(n);
    for (Punto<T> &p : P)
        for (int k = 0; k < 3; ++k)
            p[k] = T(azar.entero(-1023, 1023) / 1024.0);
    return P;
}
template<typename T>
Geometria2<T> redAlAzar(unsigned semilla = 11) {
    const auto P = puntosAlAzar<T>(16, semilla);
    return redDe<T>([&](std::size_t i, std::size_t j) { return P[4 * i + j]; });
}

/// Los polinomios de Bernstein (ecuación 11.20), con C(n, k) exacto mientras quepa en R; o su derivada `d`, con los de
/// grado menor.
template<typename R>
std::vector<R> bernsteinRef(std::size_t n, const R &u, std::size_t d = 0) {
    std::vector<R> b(n + 1, R(0));
    if (d > 0 && n > 0) {
        const std::vector<R> menor = bernsteinRef(n - 1, u, d - 1);
        for (std::size_t k = 0; k <= n; ++k)
            b[k] = R(double(n)) * ((k > 0 ? menor[k - 1] : R(0)) - (k < n ? menor[k] : R(0)));
    }
    R C(1);
    for (std::size_t k = 0; d == 0 && k <= n; ++k) {
        b[k] = C;
        for (std::size_t i = 0; i < n; ++i)
            b[k] = b[k] * (i < k ? u : R(1) - u);
        C = C * R(double(n - k)) / R(double(k + 1));
    }
    return b;
}
/// La ecuación 11.41, o una derivada suya.
template<typename R, typename T>
Punto<R> superficieRef(const RedBezier<T> &red, const R &u, const R &v, int du = 0, int dv = 0) {
    const std::vector<R> bu = bernsteinRef(red.n, u, std::size_t(du)),
                         bv = bernsteinRef(red.m, v, std::size_t(dv));
    Punto<R> suma(R(0));
    for (std::size_t k = 0; k < red.P.size(); ++k)
        suma += bu[k / bv.size()] * bv[k % bv.size()] * Punto<R>(red.P[k]);
    return suma;
}

template<typename R>
Punto<R> cruz(const Punto<R> &a, const Punto<R> &b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// La normal, o su límite camino del centro donde no la hay. `Q(u, v, du, dv)` es la superficie o una derivada suya.
template<typename R, typename Derivada>
Punto<R> normalDe(const Derivada &Q, const R &u, const R &v) {
    Punto<R> n(R(0));
    for (const double h : {0.0, 1e-17}) {
        const R s = u + R(h) * (R(0.5) - u), t = v + R(h) * (R(0.5) - v);
        n = cruz<R>(Q(s, t, 1, 0), Q(s, t, 0, 1));
        if (double(largo(n)) > 1e-24)
            break;
    }
    return (R(1) / largo(n)) * n;
}

/// Añade a una malla la superficie Q(u, v, du, dv), en tantos trozos y con su normal exacta.
template<typename Superficie>
void ponSuperficie(std::vector<oraculo::VerticeRef> &vertices,
                   std::vector<oraculo::Triangulos::Indices> &indices, const Superficie &Q,
                   const Segmentos &n) {
    for (int i = 0; i <= n.u; ++i)
        for (int j = 0; j <= n.v; ++j) {
            const double u = double(i) / n.u, v = double(j) / n.v;
            const std::size_t a = vertices.size(), b = a + std::size_t(n.v) + 1;
            vertices.push_back({exacto(Q(u, v, 0, 0)), exacto(normalDe(Q, u, v))});
            if (i < n.u && j < n.v)
                indices.insert(indices.end(), {{a, b, b + 1}, {a, b + 1, a + 1}});
        }
}
