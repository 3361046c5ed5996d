// Las miniaturas de lo que va quedando en cada framebuffer.
#pragma once
#include "estado.h"
#include "json.h"

namespace explica {

/// Compara lo que hay en ese framebuffer con lo que había la última vez y apunta en `orden` cuántos píxeles cambian, en
/// qué rectángulo y, si cambia, las miniaturas (ancho, alto y los bytes en base 64) de color, profundidad y plantilla.
/// `dibuja`: si lo ha cambiado dibujando, y no borrando. Hay que tener un Guardado.
void apuntaImagenes(const Lienzo &lienzo, Json &orden, bool dibuja);
void olvidaImagenes();

/// Cuántas órdenes que dibujan han cambiado cada píxel de la ventana: la imagen, y el `maximo`.
Json vecesEnJson();

} // namespace explica
