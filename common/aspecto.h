// Cómo cabe una escena en ventanas de cualquier forma. Las escenas se componen para 4:3; en una ventana más ancha se
// ve más por los lados y en una más estrecha, más por arriba y por abajo: nunca se corta nada. Sin OpenGL.
#pragma once
#include <algorithm>
#include <cmath>

const double ASPECTO_COMPUESTO = 4.0 / 3.0;

/// Lo que hay que agrandar la vista en vertical en una ventana de esa relación de aspecto (ancho/alto).
inline double ampliacionVertical(double aspecto) {
    return aspecto < ASPECTO_COMPUESTO ? ASPECTO_COMPUESTO / aspecto : 1.0;
}

/// Alto de la escena en una ventana de ancho × alto: el suyo o, si es más estrecha que 4:3, el que tendría a 4:3.
inline double altoUtilDe(int ancho, int alto) {
    return std::min(double(alto), ancho / ASPECTO_COMPUESTO);
}

/// Ángulo vertical (radianes) de una cámara que a 4:3 tiene el `angulo` dado.
inline double anguloVertical(double angulo, double aspecto) {
    return 2 * std::atan(ampliacionVertical(aspecto) * std::tan(angulo / 2));
}
