// Los shaders del fragmento que ha ganado, línea a línea: se reescriben (glsl.h) y se ejecutan otra vez con él y con
// los vértices de su triángulo.
#pragma once
#include "json.h"
#include "ordenes.h"
#include "sueltas.h"

namespace explica {

/// De esa primitiva de esa orden, en ese píxel: `fragmento` (lineas, pasos, sinSeguir), `vertices` (de cada uno, su
/// índice y sus líneas) y, si es un triángulo, los `pesos` de los tres, con perspectiva y sin ella.
Json sombrea(const Orden &orden, const Lienzo &lienzo, Punto pixel, int primitiva);

} // namespace explica
