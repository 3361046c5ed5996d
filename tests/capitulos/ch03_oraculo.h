// Lo común a las pruebas de imagen del capítulo 3: una escena de sólidos de color y el sombreado de objeto.vert y
// objeto.frag en doble precisión.
#pragma once
#include "oraculo/oraculo.h"
#include <vector>

namespace ch03 {

using oraculo::Vec3;

/// Giro que lleva Z a `eje`: sus columnas son e, f y d, con e según la regla del libro (§3.4), que deja libre qué
/// componente se niega.
inline oraculo::Mat4 base(const Vec3 &eje) {
    const Vec3 d = unitario(eje), a{std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)};
    const Vec3 e = unitario(a.x <= a.y && a.x <= a.z ? Vec3{0, -d.z, d.y}
                            : a.y <= a.z             ? Vec3{d.z, 0, -d.x}
                                                     : Vec3{-d.y, d.x, 0});
    const Vec3 f = vectorial(d, e);
    return {{{e.x, f.x, d.x, 0}, {e.y, f.y, d.y, 0}, {e.z, f.z, d.z, 0}, {0, 0, 0, 1}}};
}

struct Cuerpo {
    oraculo::Objeto objeto;
    Vec3 color;
};

/// La normal que llega al fragment shader: en una malla, la interpolada entre las de los vértices, que son
/// unitarias, sin volver a normalizarla.
inline Vec3 normalInterpolada(const oraculo::Objeto &objeto, const oraculo::Impacto &i) {
    if (objeto.forma != oraculo::Objeto::MALLA)
        return i.normal;
    const oraculo::Triangulos &malla = *objeto.triangulos;
    const auto &esquinas = malla.indices[static_cast<std::size_t>(i.corte.triangulo)];
    const auto normal = [&](std::size_t k) {
        return transformaNormal(objeto.inv, malla.vertices[esquinas[k]].normal);
    };
    return (1 - i.corte.b1 - i.corte.b2) * normal(0) + i.corte.b1 * normal(1) + i.corte.b2 * normal(2);
}

/// Lo que puede desviarse (píxeles) el borde de una misma malla: OpenGL lleva los vértices a una rejilla de 1/256,
/// y la punta donde se cortan dos lados que forman un ángulo agudo se mueve unas cuantas veces más.
const double DESVIO = 1.0 / 32;

/// Compara la imagen de la GPU con la escena. El umbral de los bordes es el mismo nivel que se pide al interior:
/// medio de guardar el color en 8 bits y medio para la aritmética de float.
inline oraculo::Comparacion compara(const Imagen &gpu, const std::vector<Cuerpo> &cuerpos,
                                    const oraculo::Camara &camara, const Vec3 &fondo, double umbral = 1) {
    oraculo::Escena escena;
    for (const Cuerpo &c : cuerpos)
        escena.push_back(c.objeto);
    const auto sombrea = [&](const oraculo::Impacto &i) {
        if (!i)
            return fondo;
        const Cuerpo &c = cuerpos[static_cast<std::size_t>(i.objeto)];
        return (0.58 + 0.42 * escalar(normalInterpolada(c.objeto, i), {0.20, 0.78, 0.593})) * c.color;
    };
    return oraculo::compara(gpu, escena, camara, sombrea, umbral);
}

} // namespace ch03
