// El buffer object de piezas.h y cómo se dibuja.
#pragma once
#include "piezas.h"
#include <GL/glew.h>
#include <cstddef>

struct BuferPiezas {
    GLuint vao, vertices;
    GLsizei nVertices;
};

inline BuferPiezas creaBuferPiezas(GLuint programa, int columnas, int filas) {
    const std::vector<VerticePieza> piezas = creaPiezas(columnas, filas);
    BuferPiezas b{0, 0, GLsizei(piezas.size())};
    glGenVertexArrays(1, &b.vao);
    glBindVertexArray(b.vao);
    glGenBuffers(1, &b.vertices);
    glBindBuffer(GL_ARRAY_BUFFER, b.vertices);
    glBufferData(GL_ARRAY_BUFFER, piezas.size() * sizeof piezas[0], piezas.data(), GL_STATIC_DRAW);
    const auto atributo = [&](const char *nombre, std::size_t lugar) {
        const GLuint indice = glGetAttribLocation(programa, nombre);
        glVertexAttribPointer(indice, 2, GL_FLOAT, GL_FALSE, sizeof(VerticePieza),
                              reinterpret_cast<const void *>(lugar));
        glEnableVertexAttribArray(indice);
    };
    atributo("celda", offsetof(VerticePieza, celda));
    atributo("posicion", offsetof(VerticePieza, esquina));
    atributo("vida", offsetof(VerticePieza, vida));
    return b;
}

/// Con el programa en uso, una sola orden de dibujo.
inline void dibujaPiezas(const BuferPiezas &b) {
    glBindVertexArray(b.vao);
    glDrawArrays(GL_TRIANGLES, 0, b.nVertices);
}
