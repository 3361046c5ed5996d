// Objetos textura a partir de imágenes RGB (listado 6.2).
#pragma once
#include "imagen.h"
#include <GL/glew.h>
#include <array>
#include <vector>

/// Textura 2D RGB8 con mipmaps, filtro trilineal y repetición en s y t; queda enlazada, para que el
/// programa cambie con glTexParameteri lo que quiera mostrar.
GLuint creaTextura2D(const Imagen &imagen);

/// Textura 3D de lado³ texels de un byte (GL_R8): `valores[(r·lado + t)·lado + s]`. Filtro lineal y
/// repetición en las tres direcciones. El tamaño de `valores` debe ser lado³.
GLuint creaTextura3D(int lado, const std::vector<unsigned char> &valores);

/// Mapa de cubo RGB8 con las seis caras en el orden de OpenGL (+X, −X, +Y, −Y, +Z, −Z), cuadradas y de
/// igual lado. Las caras de un mapa de cubo tienen su primera fila ARRIBA: se da la vuelta a cada Imagen.
GLuint creaMapaCubo(const std::array<Imagen, 6> &caras);
