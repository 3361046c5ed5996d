// Las proporciones de la ventana y las proyecciones que se atienen a ellas (aspecto.h).
#pragma once
#include "aspecto.h"
#include <glm/glm.hpp>

/// ancho/alto de la ventana, nunca 0 ni infinito.
float relacionAspecto();

/// Alto de la ventana en píxeles, o el que tendría a 4:3 si es más estrecha: la medida de grosores y rótulos.
float altoUtil();

/// Perspectiva cuyo ángulo vertical (radianes) es el dado a 4:3 y en ventanas más anchas; en las más estrechas se
/// abre, para que se vea lo mismo a lo ancho. `aspecto`: ancho/alto de la vista, si no ocupa toda la ventana;
/// `compuesto`: el de la vista para la que se ha compuesto, si no es 4:3.
glm::mat4 perspectivaVentana(float angulo, float cerca, float lejos, float aspecto = relacionAspecto(),
                             double compuesto = ASPECTO_COMPUESTO);

/// Proyección paralela que abarca [−semialto, semialto] en Y y, como poco, 4/3 de eso en X, sin deformar.
glm::mat4 paralelaVentana(float semialto, float cerca = -1, float lejos = 1,
                          float aspecto = relacionAspecto());
