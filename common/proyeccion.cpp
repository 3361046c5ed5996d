#include "proyeccion.h"
#include "recuadro.h"
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

float relacionAspecto() {
    return aspecto(ventanaEntera());
}

float altoUtil() {
    const Recuadro ventana = ventanaEntera();
    return float(altoUtilDe(std::max(ventana.ancho, 1), std::max(ventana.alto, 1)));
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
