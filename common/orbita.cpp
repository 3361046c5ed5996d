#include "orbita.h"
#include "proyeccion.h"
#include <GL/freeglut.h>
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace {

const float RADIANES_POR_ALTO = 1.8f; // arrastrando de abajo arriba de la ventana, sea del tamaño que sea
const float ELEVACION_MAXIMA = 1.55f; // algo menos de π/2: en el polo la vertical no orienta la cámara
const float FACTOR_RUEDA = 1.1f, ACERCA = 0.4f, ALEJA = 2.5f;

Orbita *activa = nullptr;
float distanciaInicial = 1;
bool arrastrando = false;
int xAnterior = 0, yAnterior = 0;

} // namespace

void orbitaConRaton(Orbita &orbita) {
    activa = &orbita;
    distanciaInicial = orbita.distancia;
    glutMouseFunc(orbitaBoton);
    glutMotionFunc(orbitaArrastra);
    glutMouseWheelFunc(orbitaRueda);
}

void orbitaBoton(int boton, int estado, int x, int y) {
    if (boton != GLUT_LEFT_BUTTON)
        return;
    arrastrando = estado == GLUT_DOWN;
    xAnterior = x;
    yAnterior = y;
}

void orbitaArrastra(int x, int y) {
    if (!arrastrando || !activa)
        return;
    const float porPixel = RADIANES_POR_ALTO / altoUtil();
    activa->azimut -= porPixel * float(x - xAnterior);
    activa->elevacion = std::clamp(activa->elevacion + porPixel * float(y - yAnterior),
                                   activa->elevacionMinima, ELEVACION_MAXIMA);
    xAnterior = x;
    yAnterior = y;
    glutPostRedisplay();
}

void orbitaRueda(int, int direccion, int, int) {
    if (!activa)
        return;
    activa->distancia = std::clamp(activa->distancia * (direccion > 0 ? 1 / FACTOR_RUEDA : FACTOR_RUEDA),
                                   ACERCA * distanciaInicial, ALEJA * distanciaInicial);
    glutPostRedisplay();
}

glm::vec3 posicionCamara(const Orbita &o) {
    return o.centro + o.distancia * glm::vec3(std::cos(o.elevacion) * std::sin(o.azimut),
                                              std::sin(o.elevacion),
                                              std::cos(o.elevacion) * std::cos(o.azimut));
}

glm::mat4 camaraOrbita(const Orbita &o) {
    return glm::lookAt(posicionCamara(o), o.centro, glm::vec3(0, 1, 0));
}
