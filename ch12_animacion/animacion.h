// El reloj de un programa en pantalla: el temporizador que pide otra imagen, las teclas que lo paran y lo adelantan, y
// su rótulo.
#pragma once
#include "reloj.h"
#include "rotulo.h"
#include "texto.h"
#include "ventana.h"

const unsigned PERIODO_CUADRO = 20;        // ms: 50 imágenes por segundo
const double PASO = 0.5, PASO_CORTO = 0.1; // segundos
const double SALTO = 36000; // segundos: diez horas, múltiplo de todos los periodos del capítulo

inline double tiempo(const Reloj &reloj) {
    return segundos(reloj, glutGet(GLUT_ELAPSED_TIME));
}

/// Atiende las teclas comunes, espacio (pausa), s (adelanta medio segundo), d (una décima) y h (diez horas). Devuelve
/// si la tecla era suya.
inline bool teclaAnimacion(Reloj &reloj, unsigned char tecla) {
    if (tecla == ' ')
        conmutaPausa(reloj, glutGet(GLUT_ELAPSED_TIME));
    else if (tecla == 's')
        adelanta(reloj, PASO);
    else if (tecla == 'd')
        adelanta(reloj, PASO_CORTO);
    else if (tecla == 'h')
        adelanta(reloj, SALTO);
    else
        return teclaComun(tecla);
    glutPostRedisplay();
    return true;
}

inline Reloj *relojQueAnda = nullptr; // el del programa

/// Pide otra imagen, si el reloj anda, y que se la vuelva a llamar (§12.2).
inline void pideCuadro(int) {
    if (relojQueAnda->parado < 0)
        glutPostRedisplay();
    glutTimerFunc(PERIODO_CUADRO, pideCuadro, 0);
}

/// Desde ahora `reloj`, que debe vivir tanto como la ventana, anima el programa y obedece a sus teclas. Un programa con
/// glutKeyboardFunc propia la instala después y llama en ella a teclaAnimacion.
inline void animaConReloj(Reloj &reloj) {
    relojQueAnda = &reloj;
    glutKeyboardFunc([](unsigned char tecla, int, int) { teclaAnimacion(*relojQueAnda, tecla); });
    pideCuadro(0);
}

/// El título con el estado, y si el tiempo está parado.
inline void tituloAnimado(const Reloj &reloj, const std::string &titulo) {
    ponTitulo(titulo + (reloj.parado < 0 ? "" : " (en pausa)"));
}

/// El instante, abajo a la izquierda, con lo que el programa añada.
inline void rotulaTiempo(const Reloj &reloj, const glm::vec3 &color, const std::string &ademas = "") {
    rotula(formatea("t = %.2f s", tiempo(reloj)) + ademas, {0.03f, 0.06f}, color, Lado::DERECHA);
}
