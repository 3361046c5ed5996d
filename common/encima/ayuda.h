// Lo que todo programa puede poner sobre su imagen, cuando está acabada: F1, sus controles, tal como los dice la línea
// «// Controles:» de su fuente; F2, el píxel que hay bajo el puntero; F3, vigilar los shaders, que se releen en cuanto
// se guardan, y el error del que no compila.
#pragma once
#include <string>

/// Los de un programa: lo que se toca, un tabulador y lo que hace, y entre cada dos, « · ». Lo llama antes de main un
/// objeto que se enlaza con él (herramientas/base/controles.py).
bool apuntaControles(const char *programa, const char *suyos);

/// Los controles del programa que se ejecuta, uno por línea, y después los de todos.
std::string controlesDelPrograma();

/// Ponen o quitan cada cosa. Se ven al acabar cada cuadro: glutSwapBuffers las pinta antes de enseñarlo.
void cambiaAyuda();
void cambiaPuntero();
void cambiaVigilancia();

/// F12: al acabar el cuadro, antes de enseñarlo, se guarda (guardaVentana).
void pideCaptura();
