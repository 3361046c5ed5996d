// Los buffer objects de una malla (listado 2.2) y cómo se dibuja (listado 2.4).
#pragma once
#include "malla.h"
#include <GL/glew.h>

/// Lo que hace falta para dibujar una malla.
struct Buferes {
    GLuint vao, vertices, indices;
    GLsizei nIndices;
};

/// Lleva la malla a la GPU; los atributos van en los índices de shader.h (posicion, vNormal, coordTextura).
Buferes creaBuferes(const Malla &malla);

/// Dibuja la malla con el programa en uso: glBindVertexArray y glDrawElements.
void dibuja(const Buferes &buferes);
