// El material del modelo de Phong y los doce de la tabla 5.1. Sin OpenGL.
#pragma once
#include <glm/glm.hpp>

/// Coeficientes de reflexión, de 0 a 1, y brillo.
struct Material {
    glm::vec3 Ka, Kd, Ks;
    float alfa;
};

struct MaterialConNombre {
    const char *nombre;
    Material material;
};

/// El brillo de la tabla 5.1 va de 0.08 a 0.6: es una fracción de 128, el mayor exponente que admitía el
/// OpenGL antiguo. Tomado por alfa, ni los metales tendrían brillo.
const float ALFA_MAXIMA = 128;

const MaterialConNombre TABLA_MATERIALES[] = {
    {"Esmeralda",
     {{0.022f, 0.17f, 0.02f}, {0.08f, 0.61f, 0.08f}, {0.63f, 0.73f, 0.63f}, 0.60f * ALFA_MAXIMA}},
    {"Jade", {{0.14f, 0.22f, 0.16f}, {0.54f, 0.89f, 0.63f}, {0.32f, 0.32f, 0.32f}, 0.10f * ALFA_MAXIMA}},
    {"Obsidiana", {{0.05f, 0.05f, 0.07f}, {0.18f, 0.17f, 0.23f}, {0.33f, 0.33f, 0.35f}, 0.30f * ALFA_MAXIMA}},
    {"Perla", {{0.25f, 0.21f, 0.21f}, {1.00f, 0.83f, 0.83f}, {0.30f, 0.30f, 0.30f}, 0.09f * ALFA_MAXIMA}},
    {"Rubí", {{0.18f, 0.01f, 0.01f}, {0.61f, 0.04f, 0.04f}, {0.73f, 0.63f, 0.63f}, 0.60f * ALFA_MAXIMA}},
    {"Turquesa", {{0.10f, 0.19f, 0.17f}, {0.39f, 0.74f, 0.69f}, {0.29f, 0.31f, 0.31f}, 0.10f * ALFA_MAXIMA}},
    {"Bronce", {{0.21f, 0.13f, 0.05f}, {0.71f, 0.43f, 0.18f}, {0.39f, 0.27f, 0.17f}, 0.20f * ALFA_MAXIMA}},
    {"Cobre", {{0.19f, 0.07f, 0.02f}, {0.71f, 0.27f, 0.08f}, {0.26f, 0.14f, 0.09f}, 0.10f * ALFA_MAXIMA}},
    {"Oro", {{0.25f, 0.20f, 0.07f}, {0.75f, 0.61f, 0.23f}, {0.63f, 0.56f, 0.37f}, 0.40f * ALFA_MAXIMA}},
    {"Plata", {{0.20f, 0.20f, 0.20f}, {0.51f, 0.51f, 0.51f}, {0.51f, 0.51f, 0.51f}, 0.40f * ALFA_MAXIMA}},
    {"Plástico", {{0.00f, 0.00f, 0.00f}, {0.55f, 0.55f, 0.55f}, {0.70f, 0.70f, 0.70f}, 0.25f * ALFA_MAXIMA}},
    {"Goma", {{0.05f, 0.05f, 0.05f}, {0.50f, 0.50f, 0.50f}, {0.70f, 0.70f, 0.70f}, 0.08f * ALFA_MAXIMA}},
};
