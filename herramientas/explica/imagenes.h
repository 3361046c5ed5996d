// Las miniaturas de lo que va quedando en cada framebuffer.
#pragma once
#include "estado.h"
#include "json.h"

namespace explica {

/// Compara lo que hay en ese framebuffer con lo que había la última vez y apunta en `orden` cuántos píxeles cambian, en
/// qué rectángulo y, si cambia, las miniaturas (ancho, alto y los bytes en base 64) de color, profundidad y plantilla.
/// Hay que tener un Guardado.
void apuntaImagenes(const Lienzo &lienzo, Json &orden);
void olvidaImagenes();

} // namespace explica
