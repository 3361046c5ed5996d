// Objetos textura a partir de imágenes RGB (listado 6.2).
#pragma once
#include "imagen.h"
#include <GL/glew.h>

/// Textura 2D RGB8 con mipmaps, filtro trilineal y repetición en s y t; queda enlazada, para que el
/// programa cambie con glTexParameteri lo que quiera mostrar.
GLuint creaTextura2D(const Imagen &imagen);

/// Termina si la imagen es mayor que la mayor textura de este OpenGL (GL_MAX_TEXTURE_SIZE). creaTextura2D ya lo mira.
void compruebaQueCabe(const Imagen &imagen);
