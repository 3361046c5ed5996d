// La normal de una superficie paramétrica, también donde no la dan sus tangentes: la de los parches de la tetera y de
// las superficies del capítulo 11. Para cualquier tipo real: double o de cuádruple precisión. Sin OpenGL.
#pragma once
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

/// El largo de un vector: glm::length no admite la cuádruple precisión.
template<typename T>
T largo(const glm::vec<3, T> &a) {
    using std::sqrt;
    return sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
}

/// Normal unitaria, hacia donde apunta Q_u × Q_v, de una superficie de talla 1; `d(u, v, du, dv)` es su derivada, du
/// veces con u y dv con v. Donde Q_u × Q_v se anula, porque un lado se reduce a un punto o falta una tangente, su
/// límite camino del centro: su derivada en esa dirección. Si también se anula, la del primer punto de ese camino que
/// la tenga; y si no la tiene ninguno, porque no es una superficie, +Z.
template<typename T, typename Derivada>
glm::vec<3, T> normalOLimite(const Derivada &d, const T &u, const T &v) {
    using Punto = glm::vec<3, T>;
    using std::sqrt;
    const auto cruz = [](const Punto &a, const Punto &b) {
        return Punto(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
    };
    const T nada = sqrt(std::numeric_limits<T>::epsilon());
    for (const double paso : {0.0, 1.0 / 64, 1.0 / 16, 1.0 / 4, 1.0 / 2}) {
        const T a = T(0.5) - u, b = T(0.5) - v;
        const T s = u + T(paso) * a, t = v + T(paso) * b;
        const Punto qu = d(s, t, 1, 0), qv = d(s, t, 0, 1);
        const Punto n = cruz(qu, qv);
        const T lu = largo(qu), lv = largo(qv);
        if (lu > nada && lv > nada && largo(n) > nada * lu * lv)
            return (T(1) / largo(n)) * n;
        const Punto quv = d(s, t, 1, 1);
        const Punto limite = cruz(a * d(s, t, 2, 0) + b * quv, qv) + cruz(qu, a * quv + b * d(s, t, 0, 2));
        if (largo(limite) > nada)
            return (T(1) / largo(limite)) * limite;
    }
    return Punto(T(0), T(0), T(1));
}
