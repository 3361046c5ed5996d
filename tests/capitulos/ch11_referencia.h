// La referencia del capítulo 11: U·M·G con las matrices del libro (ecuaciones 11.10, 11.17 y 11.26) en la precisión que se pida.
#pragma once
#include "azar.h"
#include "ch11_curvas/superficies.h"

/// Un número de cuádruple precisión que cabe en un vector de GLM, que lo quiere trivial (el de Boost no lo es).
struct Cuadruple {
    __extension__ typedef __float128 Numero;
    Numero x;
    Cuadruple() = default;
    Cuadruple(Numero n) : x(n) {
    }
    operator Numero() const {
        return x;
    }
    Cuadruple &operator+=(const Cuadruple &b) {
        x += b.x;
        return *this;
    }
    Cuadruple operator-() const {
        return -x;
    }
};
inline Cuadruple operator+(const Cuadruple &a, const Cuadruple &b) {
    return a.x + b.x;
}
inline Cuadruple operator-(const Cuadruple &a, const Cuadruple &b) {
    return a.x - b.x;
}
inline Cuadruple operator*(const Cuadruple &a, const Cuadruple &b) {
    return a.x * b.x;
}
inline Cuadruple operator/(const Cuadruple &a, const Cuadruple &b) {
    return a.x / b.x;
}
inline Cuadruple sqrt(const Cuadruple &a) {
    Cuadruple r(std::sqrt(double(a)));
    for (int i = 0; i < 2 && a.x > 0; ++i) // dos pasos de Newton doblan dos veces las cifras
        r = Cuadruple(0.5) * (r + a / r);
    return r;
}
template<>
struct std::numeric_limits<Cuadruple> {
    static constexpr bool is_iec559 = false; // para que GLM compare con ==
    static Cuadruple epsilon() {
        return std::ldexp(1.0, -112);
    }
};
template<typename T>
double ulp() {
    return double(std::numeric_limits<T>::epsilon());
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

/// Con cada coordenada entre −1 y 1: un float, el mismo en todas las precisiones.
template<typename T>
std::vector<Punto<T>> puntosAlAzar(std::size_t n, unsigned semilla = 11) {
    Azar azar(semilla);
    std::vector<Punto<T>> P(n);
    for (Punto<T> &p : P)
        for (int k = 0; k < 3; ++k)
            p[k] = T(azar.entre(-1.0f, 1.0f));
    return P;
}
template<typename T>
Geometria<T> geometriaAlAzar(unsigned semilla = 11) {
    const auto P = puntosAlAzar<T>(4, semilla);
    return {P[0], P[1], P[2], P[3]};
}
