// Cobertura exacta de un polígono en la ventana. Coordenadas en píxeles; el centro del píxel (x, y) es
// (x + 0.5, y + 0.5).
#pragma once
#include "algebra.h"
#include <algorithm>
#include <vector>

namespace oraculo {

struct Vec2 {
    double x, y;
};
using Poligono = std::vector<Vec2>;

/// Área con signo: positiva si gira en sentido antihorario.
inline double area(const Poligono &p) {
    double a = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec2 &u = p[i], &v = p[(i + 1) % p.size()];
        a += 0.5 * ((u.x - p[0].x) * (v.y - p[0].y) - (u.y - p[0].y) * (v.x - p[0].x));
    }
    return a;
}
/// Distancia con signo a la recta del lado más próximo de un polígono convexo: positiva dentro. Para la
/// cobertura sin antialiasing, en el centro (x + 0.5, y + 0.5) del píxel.
inline double distanciaDentro(const Poligono &convexo, double x, double y) {
    double d = INFINITO;
    const double sentido = area(convexo) < 0 ? -1 : 1;
    for (std::size_t i = 0; i < convexo.size(); ++i) {
        const Vec2 &u = convexo[i], &v = convexo[(i + 1) % convexo.size()];
        const double dx = v.x - u.x, dy = v.y - u.y;
        d = std::min(d, sentido * (dx * (y - u.y) - dy * (x - u.x)) / std::hypot(dx, dy));
    }
    return d;
}
/// Parte del píxel (x, y), de 0 a 1, que cubre el polígono: lo que queda al recortarlo con sus cuatro lados.
inline double coberturaPixel(Poligono p, int x, int y) {
    for (int lado = 0; lado < 4 && !p.empty(); ++lado) {
        const auto dentro = [&](const Vec2 &v) {
            return lado == 0 ? v.x - x : lado == 1 ? x + 1 - v.x : lado == 2 ? v.y - y : y + 1 - v.y;
        };
        Poligono q;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Vec2 &u = p[i], &v = p[(i + 1) % p.size()];
            const double du = dentro(u), dv = dentro(v);
            if (du >= 0)
                q.push_back(u);
            if ((du >= 0) != (dv >= 0))
                q.push_back({u.x + du / (du - dv) * (v.x - u.x), u.y + du / (du - dv) * (v.y - u.y)});
        }
        p = q;
    }
    return p.empty() ? 0 : std::fabs(area(p));
}

} // namespace oraculo
