// Abrir la ventana y lo que todas hacen igual: Esc, F1, F2, F3, F5, F11 y F12.
#pragma once
#include <GL/glew.h>
#include <GL/freeglut.h>
#include <glm/glm.hpp>
#include <string>

/// Crea una ventana de 960×720 píxeles (4:3) con un contexto OpenGL 3.1 y las teclas comunes puestas.
/// `modo`: el de glutInitDisplayMode. `argumentos`: lo que el programa acepta en la línea de órdenes («[FICHERO]») y
/// lee después de argv; si es nulo, lo que no sea de GLUT termina con estado 2. También termina si no hay OpenGL 3.1.
/// Con LAB_VIGILA en el entorno, como si se pulsara F3.
void abreVentana(int &argc, char **argv, const char *titulo, unsigned modo, const char *argumentos = nullptr);

/// Pone el título de la ventana, en UTF-8.
void ponTitulo(const std::string &titulo);

/// Atiende Esc (termina). Devuelve si la tecla era suya: un programa con glutKeyboardFunc propia la llama
/// primero.
bool teclaComun(unsigned char tecla);

/// Atiende F1 (pone o quita la ayuda), F2 (el píxel bajo el puntero), F3 (vigila los shaders), F5 (los relee), F11
/// (pantalla completa) y F12 (guarda la ventana en <programa>-N.png). Un programa con glutSpecialFunc propia la llama
/// primero.
bool teclaEspecialComun(int tecla);
