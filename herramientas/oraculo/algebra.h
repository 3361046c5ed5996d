// Vectores y matrices del oráculo, en doble precisión.
#pragma once
#include <cmath>
#include <limits>
#include <stdexcept>

namespace oraculo {

const double PI = 3.14159265358979323846;
const double INFINITO = std::numeric_limits<double>::infinity();

struct Vec3 {
    double x = 0, y = 0, z = 0;
    double operator[](int i) const {
        return i == 0 ? x : i == 1 ? y : z;
    }
};
inline Vec3 operator+(const Vec3 &a, const Vec3 &b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(const Vec3 &a, const Vec3 &b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator-(const Vec3 &a) {
    return {-a.x, -a.y, -a.z};
}
inline Vec3 operator*(const Vec3 &a, const Vec3 &b) { // componente a componente: coeficiente por luz
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
inline Vec3 operator*(double k, const Vec3 &a) {
    return {k * a.x, k * a.y, k * a.z};
}
inline double escalar(const Vec3 &a, const Vec3 &b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3 vectorial(const Vec3 &a, const Vec3 &b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double longitud(const Vec3 &a) {
    return std::sqrt(escalar(a, a));
}
/// Vector unitario; el nulo se queda nulo.
inline Vec3 unitario(const Vec3 &a) {
    const double l = longitud(a);
    return l > 0 ? (1 / l) * a : Vec3{};
}
/// Dirección d tras rebotar en una superficie de normal unitaria n.
inline Vec3 refleja(const Vec3 &d, const Vec3 &n) {
    return d - 2 * escalar(d, n) * n;
}

/// Matriz por FILAS, como se escribe en el papel: f[fila][columna]. Por defecto, la identidad.
struct Mat4 {
    double f[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
};
inline Mat4 operator*(const Mat4 &a, const Mat4 &b) {
    Mat4 r;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            r.f[i][j] = 0;
            for (int k = 0; k < 4; ++k)
                r.f[i][j] += a.f[i][k] * b.f[k][j];
        }
    return r;
}
inline Mat4 traslada(const Vec3 &t) {
    return {{{1, 0, 0, t.x}, {0, 1, 0, t.y}, {0, 0, 1, t.z}, {0, 0, 0, 1}}};
}
inline Mat4 escala(const Vec3 &s) {
    return {{{s.x, 0, 0, 0}, {0, s.y, 0, 0}, {0, 0, s.z, 0}, {0, 0, 0, 1}}};
}
inline Mat4 escala(double s) {
    return escala({s, s, s});
}
/// Giro alrededor de un eje que pasa por el origen (Rodrigues), en el sentido de la mano derecha.
inline Mat4 gira(const Vec3 &eje, double angulo) {
    const Vec3 e = unitario(eje);
    const double c = std::cos(angulo), s = std::sin(angulo), v = 2 * std::pow(std::sin(angulo / 2), 2);
    return {{{c + v * e.x * e.x, v * e.x * e.y - s * e.z, v * e.x * e.z + s * e.y, 0},
             {v * e.x * e.y + s * e.z, c + v * e.y * e.y, v * e.y * e.z - s * e.x, 0},
             {v * e.x * e.z - s * e.y, v * e.y * e.z + s * e.x, c + v * e.z * e.z, 0},
             {0, 0, 0, 1}}};
}
/// M·(v, w), sin dividir por la cuarta componente.
inline Vec3 porVector(const Mat4 &M, const Vec3 &v, double w) {
    const auto fila = [&](int i) {
        return M.f[i][0] * v.x + M.f[i][1] * v.y + M.f[i][2] * v.z + M.f[i][3] * w;
    };
    return {fila(0), fila(1), fila(2)};
}
inline Vec3 punto(const Mat4 &M, const Vec3 &p) {
    return porVector(M, p, 1);
}
inline Vec3 direccion(const Mat4 &M, const Vec3 &v) {
    return porVector(M, v, 0);
}
/// Inversa de una transformación afín. Una que aplasta no la tiene: el objeto aplastado es un plano.
inline Mat4 inversa(const Mat4 &M) {
    const auto columna = [&](int j) { return Vec3{M.f[0][j], M.f[1][j], M.f[2][j]}; };
    const Vec3 a = columna(0), b = columna(1), c = columna(2), t = columna(3);
    const double det = escalar(a, vectorial(b, c));
    if (det == 0 || !std::isfinite(det))
        throw std::invalid_argument("oráculo: la transformación no tiene inversa");
    const Vec3 filas[3] = {(1 / det) * vectorial(b, c), (1 / det) * vectorial(c, a),
                           (1 / det) * vectorial(a, b)};
    Mat4 r;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            r.f[i][j] = filas[i][j];
        r.f[i][3] = -escalar(filas[i], t);
    }
    return r;
}
/// Normal unitaria por la traspuesta de la inversa, que aquí se recibe ya calculada.
inline Vec3 transformaNormal(const Mat4 &inv, const Vec3 &n) {
    return unitario({inv.f[0][0] * n.x + inv.f[1][0] * n.y + inv.f[2][0] * n.z,
                     inv.f[0][1] * n.x + inv.f[1][1] * n.y + inv.f[2][1] * n.z,
                     inv.f[0][2] * n.x + inv.f[1][2] * n.y + inv.f[2][2] * n.z});
}

} // namespace oraculo
