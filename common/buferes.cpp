#include "buferes.h"
#include "shader.h"
#include <cstddef>

Buferes creaBuferes(const Malla &malla) {
    Buferes b{};
    b.nIndices = GLsizei(malla.indices.size());
    glGenVertexArrays(1, &b.vao);
    glBindVertexArray(b.vao);

    glGenBuffers(1, &b.vertices);
    glBindBuffer(GL_ARRAY_BUFFER, b.vertices);
    glBufferData(GL_ARRAY_BUFFER, malla.vertices.size() * sizeof(Vertice), malla.vertices.data(),
                 GL_STATIC_DRAW);
    auto atributo = [](GLuint indice, GLint componentes, std::size_t desplazamiento) {
        glVertexAttribPointer(indice, componentes, GL_FLOAT, GL_FALSE, sizeof(Vertice),
                              reinterpret_cast<const void *>(desplazamiento));
        glEnableVertexAttribArray(indice);
    };
    atributo(ATRIBUTO_POSICION, 3, offsetof(Vertice, posicion));
    atributo(ATRIBUTO_NORMAL, 3, offsetof(Vertice, normal));
    atributo(ATRIBUTO_COORD_TEXTURA, 2, offsetof(Vertice, coordTextura));

    glGenBuffers(1, &b.indices);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, b.indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, malla.indices.size() * sizeof(GLuint), malla.indices.data(),
                 GL_STATIC_DRAW);
    return b;
}

void borraBuferes(const Buferes &buferes) {
    glDeleteVertexArrays(1, &buferes.vao);
    glDeleteBuffers(1, &buferes.vertices);
    glDeleteBuffers(1, &buferes.indices);
}

void dibuja(const Buferes &buferes) {
    glBindVertexArray(buferes.vao);
    glDrawElements(GL_TRIANGLES, buferes.nIndices, GL_UNSIGNED_INT, nullptr);
}
