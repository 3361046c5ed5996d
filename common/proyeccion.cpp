#include "proyeccion.h"
#include <GL/freeglut.h>
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

float relacionAspecto() {
    const int ancho = std::max(glutGet(GLUT_WINDOW_WIDTH), 1),
              alto = std::max(glutGet(GLUT_WINDOW_HEIGHT), 1);
    return float(ancho) / float(alto);
}

float altoUtil() {
    return float(
        altoUtilDe(std::max(glutGet(GLUT_WINDOW_WIDTH), 1), std::max(glutGet(GLUT_WINDOW_HEIGHT), 1)));
}

glm::mat4 perspectivaVentana(float angulo, float cerca, float lejos, float aspecto, double compuesto) {
    const double vertical = anguloVertical(angulo, aspecto / compuesto * ASPECTO_COMPUESTO);
    return glm::perspective(float(vertical), aspecto, cerca, lejos);
}

glm::mat4 paralelaVentana(float semialto, float cerca, float lejos, float aspecto) {
    const float y = semialto * float(ampliacionVertical(aspecto));
    const float x = aspecto * y;
    return glm::ortho(-x, x, -y, y, cerca, lejos);
}
