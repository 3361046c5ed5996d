// El tiempo de una animación, en segundos y en double, con pausa. El estado de cada objeto es una función de ese tiempo
// y nunca se acumula de un cuadro a otro: va igual de rápido con cualquier número de cuadros por segundo. Sin OpenGL.
#pragma once
#include <cmath>

struct Reloj {
    double adelanto = 0; // segundos que lleva de más respecto al reloj de GLUT
    double parado = -1;  // en pausa, el instante en que se paró; si no, negativo
};

/// Segundos de la animación cuando el reloj de GLUT (GLUT_ELAPSED_TIME) marca `ms`.
inline double segundos(const Reloj &reloj, int ms) {
    return reloj.parado >= 0 ? reloj.parado : ms / 1000.0 + reloj.adelanto;
}

inline void conmutaPausa(Reloj &reloj, int ms) {
    if (reloj.parado < 0) {
        reloj.parado = segundos(reloj, ms);
    } else {
        reloj.adelanto = reloj.parado - ms / 1000.0;
        reloj.parado = -1;
    }
}

inline void adelanta(Reloj &reloj, double s) {
    (reloj.parado >= 0 ? reloj.parado : reloj.adelanto) += s;
}

/// Qué parte del periodo ha pasado, en [0, 1). Se calcula en double y solo entonces se convierte: un float no
/// distingue los milisegundos pasadas unas horas (a las 100, salta de 31 en 31).
inline float fase(double t, double periodo) {
    const double vueltas = t / periodo;
    const float f = float(vueltas - std::floor(vueltas));
    return f < 1 ? f : 0;
}
