// Lo que hay en la ventana, como imagen.
#pragma once
#include "imagen.h"

/// Color de la ventana tal como está en el framebuffer, primera fila abajo. Deja OpenGL como lo encuentra.
Imagen leeVentana();

/// La guarda en <programa>-N.png, sin pisar ninguna, y lo dice. Lo dibujado está en el buffer de atrás hasta
/// glutSwapBuffers: después no se sabe lo que hay.
void guardaVentana();
