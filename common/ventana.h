// Abrir la ventana y lo que todas las ventanas hacen igual: Esc, F1, F5, F11, F12 y la relación de aspecto.
#pragma once
#include <GL/glew.h>
#include <GL/freeglut.h>
#include <glm/glm.hpp>
#include <string>

/// Crea una ventana de 960×720 píxeles (4:3) con un contexto OpenGL 3.1 y las teclas comunes puestas.
/// `modo`: el de glutInitDisplayMode. `argumentos`: lo que el programa acepta en la línea de órdenes («[FICHERO]») y
/// lee después de argv; si es nulo, lo que no sea de GLUT termina con estado 2. También termina si no hay OpenGL 3.1.
void abreVentana(int &argc, char **argv, const char *titulo, unsigned modo, const char *argumentos = nullptr);

/// Pone el título de la ventana, en UTF-8.
void ponTitulo(const std::string &titulo);

/// Atiende Esc (termina). Devuelve si la tecla era suya: un programa con glutKeyboardFunc propia la llama
/// primero.
bool teclaComun(unsigned char tecla);

/// Atiende F1 (pone o quita la ayuda), F5 (relee los shaders), F11 (pantalla completa) y F12 (guarda la ventana en <programa>-N.ppm).
/// Un programa con glutSpecialFunc propia la llama primero.
bool teclaEspecialComun(int tecla);

/// Acaba un cuadro: encima va la ayuda de F1, si está puesta, y luego glutSwapBuffers. Un programa escribe esta última, como el libro.
void acabaCuadro();
#define glutSwapBuffers acabaCuadro

/// ancho/alto de la ventana, nunca 0 ni infinito.
float relacionAspecto();

/// Alto de la ventana en píxeles, o el que tendría a 4:3 si es más estrecha: la medida de grosores y rótulos.
float altoUtil();

/// Perspectiva cuyo ángulo vertical (radianes) es el dado a 4:3 y en ventanas más anchas; en las más estrechas se
/// abre, para que se vea lo mismo a lo ancho. `aspecto`: ancho/alto de la vista, si no ocupa toda la ventana.
glm::mat4 perspectivaVentana(float angulo, float cerca, float lejos, float aspecto = relacionAspecto());

/// Proyección paralela que abarca [−semialto, semialto] en Y y, como poco, 4/3 de eso en X, sin deformar.
glm::mat4 paralelaVentana(float semialto, float cerca = -1, float lejos = 1,
                          float aspecto = relacionAspecto());

/// Color de la ventana tal como está en el framebuffer, primera fila abajo. Deja OpenGL como lo encuentra.
struct Imagen leeVentana();
