// Tres juguetes sobre una mesa hechos de cubos, esferas y toros transformados (figura 3.2): qué primitiva, con
// qué transformación y de qué color. Sin OpenGL; la usan objetos.cpp y las pruebas.
#pragma once
#include "colores.h"
#include "transformaciones.h"
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <vector>

/// Las mallas de common/malla.h: cubo de lado 1, esfera de radio 1 y toro de radio 1 en el plano XY.
enum class Primitiva { CUBO, ESFERA, TORO };
const float RADIO_TUBO = 0.35f; // del toro, sin escalar

struct PiezaObjeto {
    Primitiva primitiva;
    glm::mat4 M;
    glm::vec3 color;
};
using PiezasObjeto = std::vector<PiezaObjeto>;

/// De pie en el origen, mirando a +Z; mide 4.2 de alto.
inline PiezasObjeto munecoDeNieve() {
    const glm::vec3 nieve(0.97f, 0.98f, 1), madera(0.45f, 0.30f, 0.18f);
    PiezasObjeto piezas = {
        {Primitiva::ESFERA, traslacion({0, 0.92f, 0}) * escalado({1.05f, 0.95f, 1.05f}), nieve},
        {Primitiva::ESFERA, traslacion({0, 2.18f, 0}) * escalado(0.74f), nieve},
        {Primitiva::ESFERA, traslacion({0, 3.14f, 0}) * escalado(0.52f), nieve},
        {Primitiva::TORO,
         traslacion({0, 2.74f, 0}) * giroX(glm::half_pi<float>()) * escalado({0.4f, 0.4f, 0.5f}), ROJO},
        {Primitiva::CUBO, traslacion({0.32f, 2.4f, 0.62f}) * giroX(-0.35f) * escalado({0.24f, 0.75f, 0.1f}),
         ROJO},
        {Primitiva::CUBO, traslacion({0, 3.55f, 0}) * escalado({1.15f, 0.1f, 1.15f}), OSCURO},
        {Primitiva::CUBO, traslacion({0, 3.88f, 0}) * escalado({0.7f, 0.65f, 0.7f}), OSCURO},
        {Primitiva::CUBO, traslacion({0, 3.68f, 0}) * escalado({0.74f, 0.16f, 0.74f}), ROJO},
        {Primitiva::ESFERA, traslacion({0, 3.12f, 0.68f}) * escalado({0.1f, 0.1f, 0.34f}), NARANJA},
    };
    for (float lado : {-1.0f, 1.0f}) {
        piezas.push_back(
            {Primitiva::ESFERA, traslacion({0.19f * lado, 3.27f, 0.45f}) * escalado(0.075f), OSCURO});
        piezas.push_back(
            {Primitiva::CUBO,
             traslacion({1.05f * lado, 2.5f, 0}) * giroZ(0.5f * lado) * escalado({1, 0.1f, 0.1f}), madera});
    }
    for (float altura : {1.25f, 2.05f})
        piezas.push_back({Primitiva::ESFERA,
                          traslacion({0, altura, altura < 2 ? 0.99f : 0.73f}) * escalado(0.09f), OSCURO});
    return piezas;
}

/// Con las ruedas en y = 0 y hacia +X; mide 2.6 de largo.
inline PiezasObjeto coche() {
    const glm::vec3 cristal(0.78f, 0.90f, 0.97f), metal(0.72f, 0.74f, 0.78f);
    PiezasObjeto piezas = {
        {Primitiva::CUBO, traslacion({0, 0.72f, 0}) * escalado({2.5f, 0.5f, 1.2f}), AZUL},
        {Primitiva::CUBO, traslacion({-0.25f, 1.2f, 0}) * escalado({1.35f, 0.5f, 1.1f}), cristal},
        {Primitiva::CUBO, traslacion({-0.25f, 1.5f, 0}) * escalado({1.45f, 0.12f, 1.2f}), AZUL},
        {Primitiva::CUBO, traslacion({-0.25f, 1.2f, 0}) * escalado({0.1f, 0.52f, 1.14f}), AZUL},
        {Primitiva::CUBO, traslacion({1.25f, 0.55f, 0}) * escalado({0.14f, 0.16f, 1.3f}), metal},
        {Primitiva::CUBO, traslacion({-1.25f, 0.55f, 0}) * escalado({0.14f, 0.16f, 1.3f}), metal},
    };
    for (float lado : {-1.0f, 1.0f}) {
        piezas.push_back({Primitiva::ESFERA,
                          traslacion({1.25f, 0.82f, 0.42f * lado}) * escalado({0.08f, 0.14f, 0.14f}),
                          AMARILLO});
        piezas.push_back({Primitiva::ESFERA,
                          traslacion({-1.25f, 0.82f, 0.42f * lado}) * escalado({0.06f, 0.11f, 0.11f}), ROJO});
        for (float x : {-0.75f, 0.8f}) {
            const glm::mat4 eje = traslacion({x, 0.46f, 0.66f * lado});
            piezas.push_back({Primitiva::TORO, eje * escalado({0.34f, 0.34f, 0.45f}), OSCURO});
            piezas.push_back({Primitiva::ESFERA, eje * escalado({0.24f, 0.24f, 0.12f}), metal});
        }
    }
    return piezas;
}

/// Aros apilados sobre una base, de pie en el origen.
inline PiezasObjeto aros() {
    const glm::vec3 colores[] = {AZUL, VERDE, AMARILLO, NARANJA, ROJO};
    PiezasObjeto piezas = {
        {Primitiva::CUBO, traslacion({0, 0.12f, 0}) * escalado({2.3f, 0.24f, 2.3f}), {0.80f, 0.62f, 0.42f}}};
    float altura = 0.24f, talla = 0.82f;
    for (const glm::vec3 &color : colores) {
        const float medioAlto = 0.9f * RADIO_TUBO * talla; // hundidos uno en otro: que no quede una rendija
        altura += medioAlto;
        piezas.push_back({Primitiva::TORO,
                          traslacion({0, altura, 0}) * giroX(glm::half_pi<float>()) * escalado(talla),
                          color});
        altura += medioAlto;
        talla -= 0.1f;
    }
    piezas.push_back({Primitiva::ESFERA, traslacion({0, altura + 0.2f, 0}) * escalado(0.36f), colores[0]});
    return piezas;
}

/// La escena completa. La mesa tiene su tablero en y = 0.
inline PiezasObjeto piezasObjetos() {
    PiezasObjeto escena = {
        {Primitiva::CUBO, traslacion({0, -0.15f, 0}) * escalado({7.6f, 0.3f, 4.8f}), {0.86f, 0.72f, 0.55f}}};
    const struct {
        glm::mat4 sitio;
        PiezasObjeto piezas;
    } juguetes[] = {{traslacion({-2.1f, 0, -0.7f}) * giroY(0.25f), munecoDeNieve()},
                    {traslacion({0.2f, 0, 1.2f}) * giroY(-0.35f), coche()},
                    {traslacion({2.4f, 0, -0.7f}) * giroY(0.3f), aros()}};
    // Cada juguete se construye en su sistema de coordenadas y una sola matriz lo lleva entero a su sitio.
    for (const auto &juguete : juguetes)
        for (const PiezaObjeto &p : juguete.piezas)
            escena.push_back({p.primitiva, juguete.sitio * p.M, p.color});
    return escena;
}
