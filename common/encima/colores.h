// La paleta de los programas: naranja es UP y el plano cerca, azul es F y el plano lejos, gris es el original.
#pragma once
#include <glm/glm.hpp>

const glm::vec3 ROJO(0.85f, 0.20f, 0.18f), VERDE(0.20f, 0.62f, 0.28f), AZUL(0.16f, 0.38f, 0.80f),
    NARANJA(0.95f, 0.55f, 0.10f), AMARILLO(0.98f, 0.78f, 0.15f), MORADO(0.56f, 0.24f, 0.66f),
    GRIS(0.55f, 0.58f, 0.62f), OSCURO(0.16f, 0.17f, 0.20f), BLANCO(1, 1, 1);
const glm::vec3 COLOR_EJE[3] = {ROJO, VERDE, AZUL}; // X, Y, Z

/// Los fondos y el suelo.
const glm::vec3 FONDO_CLARO(0.95f, 0.96f, 0.98f), FONDO_OSCURO(0.16f, 0.17f, 0.20f),
    CIELO(0.87f, 0.93f, 0.98f), SUELO(0.62f, 0.72f, 0.58f);
