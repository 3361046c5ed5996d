// F1: los controles del programa encima de su imagen, tal como los dice la línea «// Controles:» de su fuente.
#pragma once
#include <string>

/// Los del programa que se ejecuta, uno por línea, y después los de todos.
std::string controlesDelPrograma();

/// La pone o la quita. Se ve al acabar cada cuadro: glutSwapBuffers la pinta antes de enseñarlo.
void cambiaAyuda();
