// Los modos de un programa: lo mismo hecho de varias maneras, de las que se ve la elegida o todas a la vez.
#pragma once
#include "colores.h"
#include "recuadro.h"
#include <GL/glew.h>
#include <GL/freeglut.h>

struct Modos {
    int n, elegido = 0; // desde 0
    bool todos = false;
};

/// Atiende las teclas de 1 a `n`, que eligen un modo. Devuelve si la tecla era suya.
inline bool eligeModo(int &elegido, int n, unsigned char tecla) {
    if (tecla < '1' || tecla >= '1' + n)
        return false;
    elegido = tecla - '1';
    glutPostRedisplay();
    return true;
}

const int TODOS = -1;

/// Como eligeModo, y la tecla 0 los elige todos.
inline bool eligeModoOTodos(int &elegido, int n, unsigned char tecla) {
    if (tecla != '0')
        return eligeModo(elegido, n, tecla);
    elegido = TODOS;
    glutPostRedisplay();
    return true;
}

/// Atiende las teclas de 1 a n, que eligen uno, y v, que los enseña todos. Devuelve si la tecla era suya.
inline bool teclaModos(Modos &modos, unsigned char tecla) {
    if (tecla != 'v' && !eligeModo(modos.elegido, modos.n, tecla))
        return false;
    modos.todos = tecla == 'v' && !modos.todos;
    glutPostRedisplay();
    return true;
}

/// Dibuja el elegido en la ventana entera o todos, cada uno en su panel de los de reparte, con rayas entre ellos.
inline void dibujaModos(const Modos &modos, void (*dibuja)(int modo, const Recuadro &panel),
                        float aspectoEscena = 1) {
    if (!modos.todos)
        return dibuja(modos.elegido, ventanaEntera());
    abreRecuadro(ventanaEntera());
    ponFondo(GRIS);
    glClear(GL_COLOR_BUFFER_BIT);
    int modo = 0;
    for (const Recuadro &panel : reparte(modos.n, aspectoEscena))
        dibuja(modo++, panel);
}
