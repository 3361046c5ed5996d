// Si los arrays y los índices de una orden caben en sus buffers y son lo que se dice de ellos.
#pragma once
#include "cableado.h"
#include "deduce.h"
#include "ordenes.h"

namespace explica {

/// Lo que no cuadra, que es cada cosa segura.
std::vector<Dicho> deArrays(const Cableado &cableado, const Orden &orden, const std::vector<GLuint> &indices);

} // namespace explica
