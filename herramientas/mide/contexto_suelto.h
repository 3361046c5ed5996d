// Un contexto de OpenGL sin nada más: para ejecutar shaders en una prueba o al medir.
#pragma once
#include <GL/glew.h>
// clang-format off
#include <GL/freeglut.h>
// clang-format on

/// Abre una ventana sin pantalla y deja enlazado un VAO, sin el que un OpenGL estricto no dibuja.
inline void abreContexto() {
    static char nombre[] = "contexto";
    char *argv[] = {nombre, nullptr};
    int argc = 1;
    glutInit(&argc, argv);
    glutCreateWindow(nombre);
    glewExperimental = GL_TRUE;
    glewInit(); // su resultado no sirve: common/ventana.cpp
    GLuint vao = 0;
    glGenVertexArrays(1, &vao);
    glBindVertexArray(vao);
}
