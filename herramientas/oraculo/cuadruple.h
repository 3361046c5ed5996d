// Cuádruple precisión, para lo que se escribe con el tipo como parámetro y para sus referencias.
#pragma once
#include <cmath>
#include <limits>

/// Un número de cuádruple precisión que cabe en un vector de GLM, que lo quiere trivial.
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
    Cuadruple r(std::sqrt(static_cast<long double>(a.x))); // que tiene el mismo margen de exponentes
    for (int i = 0; i < 2 && a.x > 0; ++i)                 // dos pasos de Newton doblan dos veces las cifras
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
