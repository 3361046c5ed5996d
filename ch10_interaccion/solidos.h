// Los objetos de seleccion, puestos en un tablero; su identificador es su lugar en SOLIDOS. Sin OpenGL.
#pragma once
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include <glm/gtc/constants.hpp>

enum Forma { TABLERO, CUBO, ESFERA, CONO, TORO, N_FORMAS };
const float RECTO = glm::half_pi<float>();
const glm::mat4 POSADA[N_FORMAS] = {
    traslacion({0, -0.15f, 0}) * escalado({6, 0.3f, 6}), // en el origen
    traslacion({0, 0.6f, 0}) * giroY(0.4f) * escalado(1.2f), traslacion({0, 0.75f, 0}) * escalado(0.75f),
    giroX(-RECTO) * escalado({0.75f, 0.75f, 1.7f}), traslacion({0, 0.84f, 0}) * giroY(0.45f)};
const struct {
    const char *nombre;
    Forma forma;
    glm::vec3 lugar, color;
} SOLIDOS[] = {{"nada", TABLERO, {0, 0, 0}, {0.80f, 0.74f, 0.66f}}, // el 0: el tablero solo tapa
               {"cono verde", CONO, {-2, 0, -2}, VERDE},
               {"cubo azul", CUBO, {0, 0, -2}, AZUL},
               {"toro rojo", TORO, {2, 0, -2}, ROJO},
               {"esfera roja", ESFERA, {-2, 0, 0}, ROJO},
               {"toro verde", TORO, {0, 0, 0}, VERDE},
               {"cono amarillo", CONO, {2, 0, 0}, AMARILLO},
               {"cubo naranja", CUBO, {-2, 0, 2}, NARANJA},
               {"toro azul", TORO, {0, 0, 2}, AZUL},
               {"esfera morada", ESFERA, {2, 0, 2}, MORADO}};
