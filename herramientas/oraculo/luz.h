// Modelo de Phong (ecuaciones 5.1 a 5.7) y sombras.
#pragma once
#include "solidos.h"
#include <algorithm>

namespace oraculo {

struct Material {
    Vec3 ka, kd, ks;
    double alfa = 1;
};
struct Luz {
    Vec3 posicion; // con w = 0 es la dirección HACIA la luz
    double w = 1;
    Vec3 Ld{1, 1, 1}, Ls{1, 1, 1};
    double a = 1, b = 0, c = 0; // atenuación 1/(a + b·d + c·d²); si w = 0 no se aplica
    bool foco = false;
    Vec3 S{0, 0, -1};  // hacia dónde apunta el foco
    double delta = PI; // semiángulo del cono
    double exponente = 0;
};

/// L: vector unitario de p a la luz; nulo si p está en la propia luz.
inline Vec3 haciaLuz(const Luz &luz, const Vec3 &p) {
    return unitario(luz.w == 0 ? luz.posicion : luz.posicion - p);
}

/// Parte de la luz que llega a p, por la distancia y por el cono del foco. Si a + b·d + c·d² vale 0 el factor
/// es enorme pero finito: el color se satura y nunca es NaN.
inline double atenuacion(const Luz &luz, const Vec3 &p) {
    const double d = longitud(luz.posicion - p);
    double factor = luz.w == 0 ? 1 : 1 / std::max(luz.a + luz.b * d + luz.c * d * d, 1e-300);
    if (luz.foco) { // el ángulo por la tangente: el arcocoseno pierde las cifras cerca del eje
        const Vec3 L = haciaLuz(luz, p), S = unitario(luz.S);
        const double coseno = -escalar(L, S);
        const bool fuera = std::atan2(longitud(vectorial(L, S)), coseno) > luz.delta;
        factor *= fuera ? 0 : std::pow(std::max(coseno, 0.0), luz.exponente);
    }
    return factor;
}

/// Términos difuso y especular de una luz, ya atenuados. Valen 0 si L·N ≤ 0. R·V negativo cuenta como 0, y 0
/// elevado a 0 es 1: con alfa = 0 el especular es constante en toda la parte iluminada, como dice su límite.
/// N y V son unitarios.
inline Vec3 difusaYEspecular(const Material &m, const Luz &luz, const Vec3 &p, const Vec3 &N, const Vec3 &V) {
    const Vec3 L = haciaLuz(luz, p);
    const double NL = escalar(N, L);
    if (!(NL > 0))
        return {};
    const double RV = escalar(2 * NL * N - L, V);
    return atenuacion(luz, p) *
           (NL * (m.kd * luz.Ld) + std::pow(std::max(RV, 0.0), m.alfa) * (m.ks * luz.Ls));
}

/// Ecuación 5.7: el ambiente, una sola vez, y la suma de las luces.
inline Vec3 phong(const Material &m, const Vec3 &La, const std::vector<Luz> &luces, const Vec3 &p,
                  const Vec3 &N, const Vec3 &V) {
    Vec3 color = m.ka * La;
    for (const Luz &luz : luces)
        color = color + difusaYEspecular(m, luz, p, N, V);
    return color;
}

/// Si algo de `tapan` se interpone entre p y la luz.
inline bool enSombra(const Escena &tapan, const Vec3 &p, const Luz &luz) {
    const Rayo r = rayoDesde(p, haciaLuz(luz, p), luz.w == 0 ? INFINITO : longitud(luz.posicion - p));
    return std::any_of(tapan.begin(), tapan.end(), [&](const Objeto &o) {
        Corte c;
        c.t = r.maximo;
        return corta(o, r, c);
    });
}

} // namespace oraculo
