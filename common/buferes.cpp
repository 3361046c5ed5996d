#include "buferes.h"
#include "shader.h"
#include <cstddef>

void ponAtributo(GLuint indice, GLint componentes, std::size_t vertice, std::size_t desplazamiento) {
    glVertexAttribPointer(indice, componentes, GL_FLOAT, GL_FALSE, GLsizei(vertice),
                          reinterpret_cast<const void *>(desplazamiento));
    glEnableVertexAttribArray(indice);
}

Buferes creaBuferes(const Malla &malla) {
    Buferes b{};
    b.nIndices = GLsizei(malla.indices.size());
    glGenVertexArrays(1, &b.vao);
    glBindVertexArray(b.vao);

    glGenBuffers(1, &b.vertices);
    glBindBuffer(GL_ARRAY_BUFFER, b.vertices);
    glBufferData(GL_ARRAY_BUFFER, malla.vertices.size() * sizeof(Vertice), malla.vertices.data(),
                 GL_STATIC_DRAW);
    ponAtributo(ATRIBUTO_POSICION, 3, sizeof(Vertice), offsetof(Vertice, posicion));
    ponAtributo(ATRIBUTO_NORMAL, 3, sizeof(Vertice), offsetof(Vertice, normal));
    ponAtributo(ATRIBUTO_COORD_TEXTURA, 2, sizeof(Vertice), offsetof(Vertice, coordTextura));

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

void creaVerticesColor(const std::vector<VerticeColor> &vertices) {
    GLuint vao, buffer;
    glGenVertexArrays(1, &vao);
    glBindVertexArray(vao);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, vertices.size() * sizeof(VerticeColor), vertices.data(), GL_STATIC_DRAW);
    ponAtributo(ATRIBUTO_POSICION, 3, sizeof(VerticeColor), offsetof(VerticeColor, posicion));
    ponAtributo(ATRIBUTO_COLOR, 3, sizeof(VerticeColor), offsetof(VerticeColor, color));
}

void dibujaMalla(const Buferes &buferes) {
    glBindVertexArray(buferes.vao);
    glDrawElements(GL_TRIANGLES, buferes.nIndices, GL_UNSIGNED_INT, nullptr);
}
