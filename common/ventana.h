// Abrir la ventana y lo que todas las ventanas hacen igual: Esc, F5, F11, F12 y la relación de aspecto.
#pragma once
#include <GL/glew.h>
#include <GL/freeglut.h>
#include <glm/glm.hpp>

/// Crea una ventana de ancho × alto píxeles con un contexto OpenGL 3.1 y las teclas comunes puestas.
/// `modo`: el de glutInitDisplayMode. `argumentos`: lo que el programa acepta en la línea de órdenes
/// («[FICHERO]»); si es nulo, cualquier argumento que GLUT no conozca es un error (estado 2), y si no,
/// quedan en argv para el programa. Termina con un mensaje si no hay OpenGL 3.1.
void abreVentana(int &argc, char **argv, const char *titulo, int ancho, int alto,
                 unsigned modo = GLUT_DOUBLE | GLUT_RGBA | GLUT_DEPTH, const char *argumentos = nullptr);

/// Atiende Esc (termina). Devuelve si la tecla era suya: un programa con glutKeyboardFunc propia la llama
/// primero.
bool teclaComun(unsigned char tecla);

/// Atiende F5 (relee los shaders), F11 (pantalla completa) y F12 (guarda la ventana en <programa>-N.ppm).
/// Un programa con glutSpecialFunc propia la llama primero.
bool teclaEspecialComun(int tecla);

/// ancho/alto de la ventana, nunca 0 ni infinito.
float relacionAspecto();

/// Perspectiva en que el ángulo (radianes) abarca el lado MENOR: estrechar la ventana no corta la escena.
/// `aspecto`: ancho/alto de la vista, si no ocupa toda la ventana.
glm::mat4 perspectivaVentana(float angulo, float cerca, float lejos, float aspecto = relacionAspecto());

/// Proyección paralela que siempre abarca [−semilado, semilado] en X y en Y, sin deformar.
glm::mat4 paralelaVentana(float semilado, float cerca = -1, float lejos = 1,
                          float aspecto = relacionAspecto());

/// Color de la ventana tal como está en el framebuffer, primera fila abajo.
struct Imagen leeVentana();
