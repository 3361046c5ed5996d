// La malla de una orden: sus vértices antes y después del vertex shader.
#pragma once
#include "cableado.h"
#include "deduce.h"
#include "ordenes.h"

namespace explica {

/// Los vértices de una orden y, si están todos, sus triángulos.
struct Malla {
    Puntos puntos;
    std::vector<GLuint> vertices, triangulos; // qué vértice es cada punto; de cada triángulo, tres puntos
};

/// Dónde caen, recogidos sin rasterizar.
Malla posicionesDe(const Orden &orden);

/// `antes`, como están en su array, `despues`, como gl_Position, y los `triangulos`; nada, si son muchos o no se sabe.
Json mallaEnJson(const Orden &orden);

} // namespace explica
