// La cámara de fotos que dibujan camara y volumen_vista: qué sólido elemental y con qué transformación. Sin OpenGL.
#pragma once
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include <glm/glm.hpp>
#include <vector>

struct PiezaCamara {
    bool esRedonda; // el cilindro unidad, o el cubo de lado uno
    glm::mat4 M;    // en coordenadas de la cámara
    glm::vec3 color;
};

/// Una cámara de lado 1, en coordenadas de la cámara: mira hacia −Z y el centro de proyección, el origen, está
/// en el objetivo. Al mundo la lleva la inversa de la ecuación 4.1.
inline std::vector<PiezaCamara> piezasCamara() {
    return {{false, traslacion({0, 0, 0.50f}) * escalado({1.0f, 0.65f, 0.55f}), GRIS},
            {false, traslacion({0, 0.42f, 0.50f}) * escalado({0.40f, 0.22f, 0.40f}), OSCURO},
            {false, traslacion({0.34f, 0.36f, 0.50f}) * escalado({0.18f, 0.10f, 0.18f}), ROJO},
            {true, traslacion({0, 0, 0.10f}) * escalado({0.27f, 0.27f, 0.30f}), OSCURO}};
}
