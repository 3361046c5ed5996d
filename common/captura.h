// Lo que hay en la ventana, como imagen.
#pragma once
#include "imagen.h"

/// Color de la ventana tal como está en el framebuffer, primera fila abajo. Deja OpenGL como lo encuentra.
Imagen leeVentana();

/// La guarda en <programa>-N.ppm, sin pisar ninguna, y lo dice.
void guardaVentana();
