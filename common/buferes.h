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

/// Un atributo que ocupa un sitio en cada vértice, de tantos bytes, del buffer enlazado.
void ponAtributo(GLuint indice, GLint componentes, std::size_t vertice, std::size_t desplazamiento);

/// Borra sus objetos de OpenGL. Los que no se han creado son 0, que se ignora.
void borraBuferes(const Buferes &buferes);

/// Un vértice suelto, para glDrawArrays.
struct VerticeColor {
    glm::vec3 posicion, color;
};

/// Crea un VAO y un buffer con esos vértices, en los índices de posicion y color de shader.h, y los deja enlazados.
void creaVerticesColor(const std::vector<VerticeColor> &vertices);

/// Dibuja la malla con el programa en uso: glBindVertexArray y glDrawElements.
void dibujaMalla(const Buferes &buferes);
