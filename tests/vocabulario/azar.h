// Números al azar, siempre los mismos con la misma semilla.
#pragma once
#include "prueba.h"

class Azar {
    std::mt19937 generador;

public:
    explicit Azar(unsigned semilla) : generador(semilla) {
    }
    double entre(double a, double b) {
        return std::uniform_real_distribution<double>(a, b)(generador);
    }
    float entre(float a, float b) {
        return float(entre(double(a), double(b)));
    }
    int entero(int a, int b) { // los dos valen
        return std::uniform_int_distribution<int>(a, b)(generador);
    }
    /// Cada componente, entre −r y r.
    glm::vec3 vector(float r) {
        const float x = entre(-r, r), y = entre(-r, r);
        return {x, y, entre(-r, r)};
    }
    glm::dvec3 punto(double r) { // lo mismo, en doble
        const double x = entre(-r, r), y = entre(-r, r);
        return {x, y, entre(-r, r)};
    }
    /// Unitario, sin preferir ninguna dirección.
    glm::vec3 direccion() {
        glm::vec3 v(0);
        while (glm::length(v) < 0.1f || glm::length(v) > 1)
            v = vector(1);
        return glm::normalize(v);
    }
};
