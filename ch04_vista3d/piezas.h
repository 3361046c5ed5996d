// Con qué se dibujan cámaras, flechas y volúmenes de la vista: qué sólido elemental y con qué transformación.
// Sin OpenGL; lo usan los programas de este capítulo.
#pragma once
#include "ch03_transformaciones/transformaciones.h"
#include "vista.h"
#include <glm/glm.hpp>
#include <vector>

/// Lleva el eje Z a la dirección de a a b y el origen a `origen`: los sólidos de malla.h crecen a lo largo
/// de Z. X e Y se escalan por `grosor` y Z por `largo`.
inline glm::mat4 haciaPunto(const glm::vec3 &origen, const glm::vec3 &a, const glm::vec3 &b, float grosor,
                            float largo) {
    const auto [S, U, F] = baseCamara(a, b, {0, 1, 0});
    const glm::mat3 base(U, S, F); // en este orden, a derechas
    return traslacion(origen) * glm::mat4(base) * escalado({grosor, grosor, largo});
}

/// Lleva el cilindro unidad (radio 1, z de −0.5 a 0.5) al segmento de a a b, de radio `grosor`.
inline glm::mat4 segmento(const glm::vec3 &a, const glm::vec3 &b, float grosor) {
    return haciaPunto(0.5f * (a + b), a, b, grosor, glm::length(b - a));
}

/// Lleva el cono unidad (base de radio 1 en z = 0, vértice en z = 1) a la punta de una flecha de a a b: el
/// vértice en b, y la base tan atrás como ancha.
inline glm::mat4 punta(const glm::vec3 &a, const glm::vec3 &b, float grosor) {
    const glm::vec3 base = b - 2 * grosor * unitario(b - a);
    return haciaPunto(base, a, b, grosor, 2 * grosor);
}

struct PiezaCamara {
    bool esRedonda; // el cilindro unidad, o el cubo de lado uno
    glm::mat4 M;    // en coordenadas de la cámara
    glm::vec3 color;
};

/// Una cámara de fotos de lado 1, en coordenadas de la cámara: mira hacia −Z y el centro de proyección, el
/// origen, está en el objetivo. Al mundo la lleva la inversa de la ecuación 4.1.
inline std::vector<PiezaCamara> piezasCamara() {
    const glm::vec3 oscuro(0.16f, 0.17f, 0.20f), gris(0.55f, 0.58f, 0.62f), rojo(0.85f, 0.20f, 0.18f);
    return {{false, traslacion({0, 0, 0.50f}) * escalado({1.0f, 0.65f, 0.55f}), gris},
            {false, traslacion({0, 0.42f, 0.50f}) * escalado({0.40f, 0.22f, 0.40f}), oscuro},
            {false, traslacion({0.34f, 0.36f, 0.50f}) * escalado({0.18f, 0.10f, 0.18f}), rojo},
            {true, traslacion({0, 0, 0.10f}) * escalado({0.27f, 0.27f, 0.30f}), oscuro}};
}
