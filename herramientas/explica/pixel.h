// La historia de un píxel: quién lo cubre en cada orden, qué prueba pasa y qué queda en él.
#pragma once
#include "ordenes.h"
#include "sueltas.h"

namespace explica {

struct Suceso {
    int orden;
    GLuint framebuffer;
    std::string veredicto;
    int primitiva; // -1: no es de una
    std::optional<Color> queda;
    Json json;
    bool cambia = true; // si no es que, mezclado con lo que hay, deja lo mismo
};

/// Si lo que queda tras el último de ese framebuffer no es ese color, añade que algo que no se sigue lo ha cambiado.
void siLoCambiaOtro(const Lienzo &lienzo, const std::optional<Color> &color, std::vector<Suceso> &sucesos);

/// Hace la orden, y añade a `sucesos` lo que le pasa con ella a ese píxel de ese framebuffer: nada, si no lo toca.
void hazYCuenta(const Orden &orden, int numero, const Lienzo &lienzo, Punto pixel,
                std::vector<Suceso> &sucesos);

} // namespace explica
