// El volumen de la vista (figuras 4.3 y 4.4): su proyección y sus esquinas, estas de sus parámetros y no de la matriz.
// Sin OpenGL; lo usa volumen_vista.
#pragma once
#include "vista.h"
#include <array>
#include <cmath>
#include <glm/glm.hpp>

/// Ocho puntos en coordenadas de la cámara: cuatro en el plano cerca y los cuatro que les corresponden en el
/// plano lejos, desde abajo a la izquierda y en sentido antihorario.
using Esquinas = std::array<glm::dvec3, 8>;

/// La caja de la proyección paralela (figura 4.3).
inline Esquinas esquinasParalela(double izquierda, double derecha, double abajo, double arriba, double cerca,
                                 double lejos) {
    return {{{izquierda, abajo, -cerca},
             {derecha, abajo, -cerca},
             {derecha, arriba, -cerca},
             {izquierda, arriba, -cerca},
             {izquierda, abajo, -lejos},
             {derecha, abajo, -lejos},
             {derecha, arriba, -lejos},
             {izquierda, arriba, -lejos}}};
}

/// La pirámide truncada de la proyección perspectiva (figura 4.4): `theta`, el ángulo entero en Y, en radianes.
inline Esquinas esquinasPerspectiva(double theta, double aspecto, double cerca, double lejos) {
    const double y = std::tan(theta / 2);
    const double x = aspecto * y;
    Esquinas e = esquinasParalela(-x, x, -y, y, 1, 1); // a distancia 1 del vértice
    for (std::size_t k = 0; k < 8; ++k)
        e[k] *= k < 4 ? cerca : lejos;
    return e;
}

/// Los parámetros de las dos proyecciones. El volumen paralelo es centrado, y su alto cambia a la vez que θ.
struct Volumen {
    bool enPerspectiva = true;
    double theta = 0.52, aspecto = 4.0 / 3, cerca = 2.5, lejos = 9; // θ, el ángulo entero en Y, en radianes

    double semialto() const { // el de la caja
        return 1.7 / 0.52 * theta;
    }
};

inline glm::dmat4 proyeccionDe(const Volumen &v) {
    const double y = v.semialto();
    const double x = v.aspecto * y;
    return v.enPerspectiva ? proyeccionPerspectiva(v.theta, v.aspecto, v.cerca, v.lejos)
                           : proyeccionParalela(-x, x, -y, y, v.cerca, v.lejos);
}

inline Esquinas esquinasDe(const Volumen &v) {
    const double y = v.semialto();
    const double x = v.aspecto * y;
    return v.enPerspectiva ? esquinasPerspectiva(v.theta, v.aspecto, v.cerca, v.lejos)
                           : esquinasParalela(-x, x, -y, y, v.cerca, v.lejos);
}
