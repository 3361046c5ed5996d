// El avión de giro_eje y objeto_animado: cubos de lado 1 transformados. Sin OpenGL.
#pragma once
#include "colores.h"
#include "transformaciones.h"
#include <array>
#include <glm/glm.hpp>

const float MORRO = 0.55f; // del centro a la punta

struct PiezaAvion {
    glm::mat4 M;
    glm::vec3 color;
};

/// Con el centro en el origen y el morro hacia +X.
inline std::array<PiezaAvion, 4> piezasAvion() {
    return {{{escalado({2 * MORRO, 0.22f, 0.22f}), NARANJA},
             {traslacion({0.1f, 0, 0}) * escalado({0.32f, 0.08f, 1.3f}), AMARILLO},
             {traslacion({-0.45f, 0, 0}) * escalado({0.18f, 0.06f, 0.5f}), AMARILLO},
             {traslacion({-0.42f, 0.22f, 0}) * escalado({0.2f, 0.34f, 0.07f}), ROJO}}};
}
