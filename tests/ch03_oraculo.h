// Lo común a las pruebas de imagen del capítulo 3: una escena de sólidos de color, con el sombreado de
// objeto.frag en doble precisión, y cuánto puede apartarse de ella una malla de pocos segmentos.
#pragma once
#include "oraculo/oraculo.h"
#include <vector>

namespace ch03 {

using oraculo::Vec3;

struct Cuerpo {
    oraculo::Objeto objeto;
    Vec3 color;
};

inline oraculo::ImagenRef render(const std::vector<Cuerpo> &cuerpos, const oraculo::Camara &camara,
                                 const Vec3 &fondo, int ancho = 240, int alto = 180) {
    oraculo::Escena escena;
    for (const Cuerpo &c : cuerpos)
        escena.push_back(c.objeto);
    return oraculo::render(escena, camara, ancho, alto, [&](const oraculo::Impacto &i) {
        const double luz = 0.58 + 0.42 * escalar(i.normal, {0.20, 0.78, 0.593});
        return i ? luz * cuerpos[static_cast<std::size_t>(i.objeto)].color : fondo;
    });
}

/// Niveles de 255 en que una superficie de revolución de n segmentos y color c (su mayor componente) se
/// aparta de la exacta: la normal interpolada entre dos vértices se acorta como mucho a cos(π/n), y guardar
/// el color en 8 bits redondea medio nivel.
inline double nivelesPorTeselar(int n, double c) {
    return 0.5 + 255 * c * 0.42 * (1 - std::cos(oraculo::PI / n));
}

} // namespace ch03
