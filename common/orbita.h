// Cámara que gira con el ratón alrededor de un punto de interés.
#pragma once
#include <glm/glm.hpp>

/// Ángulos en radianes; el eje Y es la vertical. Con azimut y elevación 0 se mira desde +Z.
struct Orbita {
    float azimut, elevacion, distancia;
    glm::vec3 centro = glm::vec3(0);
    float elevacionMinima = -1.55f; // con suelo, la que no deja ver por debajo de él
};

/// Instala glutMouseFunc, glutMotionFunc y glutMouseWheelFunc: arrastrar con el botón izquierdo gira y
/// la rueda acerca o aleja, sin que la escena se pierda de vista: de 0.4 a 2.5 veces la distancia que tenga ahora.
/// `orbita` debe vivir tanto como la ventana.
void orbitaConRaton(Orbita &orbita);

/// Las tres funciones que instala: un programa con las suyas propias las llama desde ellas.
void orbitaBoton(int boton, int estado, int x, int y);
void orbitaArrastra(int x, int y);
void orbitaRueda(int rueda, int direccion, int x, int y);

/// Posición de la cámara en coordenadas del mundo.
glm::vec3 posicionCamara(const Orbita &orbita);

/// Matriz de transformación de la cámara (ecuación 4.1).
glm::mat4 camaraOrbita(const Orbita &orbita);
