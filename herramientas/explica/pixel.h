// La historia de un píxel: quién lo cubre en cada orden, qué prueba pasa y qué queda en él.
#pragma once
#include "ordenes.h"

namespace explica {

struct Punto {
    int x = 0, y = 0; // desde la esquina inferior izquierda
};

/// Hace la orden, y añade a `sucesos` lo que le pasa con ella a ese píxel de ese framebuffer: nada, si no lo toca.
void hazYCuenta(const Orden &orden, int numero, const Lienzo &lienzo, Punto pixel,
                std::vector<Json> &sucesos);

} // namespace explica
