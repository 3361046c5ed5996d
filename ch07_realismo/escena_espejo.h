// La escena de espejo y espejo_plantilla: una F, una esfera y un cono sobre un suelo de baldosas, delante de un espejo
// con marco. Sin OpenGL.
#pragma once
#include "ch03_transformaciones/transformaciones.h"
#include "ch05_iluminacion/materiales.h"
#include "reflexion.h"
#include <glm/gtc/constants.hpp>
#include <vector>

const float GIRO_ESPEJO = 0.35f; // radianes alrededor de Y
const glm::vec3 CENTRO_ESPEJO(0, 1.68f, -1.9f);
const glm::vec2 TALLA_ESPEJO(5.2f, 2.9f);
const float GRUESO_MARCO = 0.18f;

/// El espejo es el lado al que mira su perpendicular.
inline Plano planoEspejo() {
    return planoPor(CENTRO_ESPEJO, glm::vec3(giroY(GIRO_ESPEJO) * glm::vec4(0, 0, 1, 0)));
}
/// Lleva el cuadrado de lado uno de malla.h, en el plano XY, al espejo.
inline glm::mat4 colocaEspejo() {
    return traslacion(CENTRO_ESPEJO) * giroY(GIRO_ESPEJO) * escalado({TALLA_ESPEJO, 1});
}

enum Solido { CUBO, ESFERA, CONO, BALDOSAS_CLARAS, BALDOSAS_OSCURAS, SOLIDOS };

struct PiezaEscena {
    Solido solido;
    glm::mat4 M;
    Material material;
};

inline Material barniz(const glm::vec3 &color) {
    return {0.35f * color, 0.75f * color, glm::vec3(0.35f), 40};
}

/// `avance`: lo que se ha acercado la F al espejo, en unidades del mundo; si pasa de él, lo de detrás no se refleja.
inline std::vector<PiezaEscena> piezasEscena(float avance) {
    const glm::mat4 F = traslacion(-avance * planoEspejo().N) * traslacion({0.5f, 0, 0.9f}) * giroY(0.2f);
    const glm::mat4 alEspejo =
        traslacion(CENTRO_ESPEJO) * giroY(GIRO_ESPEJO) * traslacion({0, 0, -GRUESO_MARCO / 2 - 0.02f});
    const Material rojo = barniz({0.90f, 0.22f, 0.18f}), madera = barniz({0.62f, 0.42f, 0.24f});
    const float x = TALLA_ESPEJO.x / 2, y = TALLA_ESPEJO.y / 2, g = GRUESO_MARCO;
    return {
        {BALDOSAS_CLARAS, glm::mat4(1), barniz({0.92f, 0.90f, 0.84f})},
        {BALDOSAS_OSCURAS, glm::mat4(1), barniz({0.36f, 0.52f, 0.62f})},
        {CUBO, F * traslacion({-0.45f, 1, 0}) * escalado({0.4f, 2, 0.4f}), rojo},
        {CUBO, F * traslacion({0.25f, 1.8f, 0}) * escalado({1, 0.4f, 0.4f}), rojo},
        {CUBO, F * traslacion({0.10f, 1.1f, 0}) * escalado({0.7f, 0.35f, 0.4f}), rojo},
        {ESFERA, traslacion({2.1f, 0.6f, 0.6f}) * escalado(0.6f), barniz({0.98f, 0.75f, 0.12f})},
        {CONO, traslacion({-2.4f, 0, 1.6f}) * giroX(-glm::half_pi<float>()) * escalado({0.6f, 0.6f, 1.5f}),
         barniz({0.20f, 0.62f, 0.30f})},
        {CUBO, alEspejo * escalado({2 * x + 2 * g, 2 * y + 2 * g, g}), madera}, // la tabla de detrás
        {CUBO, alEspejo * traslacion({0, y + g / 2, g}) * escalado({2 * x + 2 * g, g, g}), madera},
        {CUBO, alEspejo * traslacion({0, -y - g / 2, g}) * escalado({2 * x + 2 * g, g, g}), madera},
        {CUBO, alEspejo * traslacion({x + g / 2, 0, g}) * escalado({g, 2 * y, g}), madera},
        {CUBO, alEspejo * traslacion({-x - g / 2, 0, g}) * escalado({g, 2 * y, g}), madera},
    };
}
