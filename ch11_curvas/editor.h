// Editar con el ratón los puntos de un programa del capítulo: se coge el más cercano en la pantalla y se mueve paralelo
// a ella. Con el teclado, n elige el siguiente y las flechas lo mueven. El programa guarda su Editor, lo da a
// editaConRaton y, desde su función de teclado, llama a teclaEditor.
#pragma once
#include "colores.h"
#include "orbita.h"
#include "proyeccion.h"
#include "ventana.h"
#include <vector>

const float ALCANCE_RATON = 0.05f,
            PASO_FLECHA = 0.05f; // en partes del alto de la ventana, o del de una de 4:3 si es estrecha

/// El punto cuya imagen está más cerca del ratón (coordenadas normalizadas), a menos de `alcance` unidades de
/// `porUnidad`; −1 si ninguno lo está. `porUnidad` iguala las medidas de X e Y, que en coordenadas normalizadas son
/// distintas.
inline int masCercano(const std::vector<glm::vec3> &puntos, const glm::mat4 &transformacion,
                      const glm::vec2 &raton, const glm::vec2 &porUnidad, float alcance) {
    int mejor = -1;
    for (std::size_t i = 0; i < puntos.size(); ++i) {
        const glm::vec4 p = transformacion * glm::vec4(puntos[i], 1);
        const float d = glm::length((glm::vec2(p) / p.w - raton) * porUnidad);
        if (p.w > 0 && d < alcance) {
            alcance = d;
            mejor = int(i);
        }
    }
    return mejor;
}

/// El punto llevado al sitio de la pantalla, sin cambiar su profundidad.
inline glm::vec3 llevado(const glm::vec3 &punto, const glm::mat4 &transformacion, const glm::vec2 &raton) {
    glm::vec4 p = transformacion * glm::vec4(punto, 1);
    p = glm::inverse(transformacion) * glm::vec4(raton * p.w, p.z, p.w);
    return glm::vec3(p) / p.w;
}

struct Editor {
    std::vector<glm::vec3> *puntos;
    glm::mat4 (*transformacion)();
    bool conOrbita = false;                                    // lejos de los puntos, el ratón orbita
    void (*alMover)(std::size_t, const glm::vec3 &) = nullptr; // qué punto y cuánto se ha movido
    int elegido = -1;
    bool arrastrando = false;
};

/// El del nombre de un punto: el elegido, en rojo.
inline glm::vec3 colorNombre(const Editor &editor, std::size_t i) {
    return int(i) == editor.elegido ? ROJO : OSCURO;
}

inline glm::vec2 ratonNormalizado(int x, int y) {
    const float ancho = float(glutGet(GLUT_WINDOW_WIDTH)), alto = float(glutGet(GLUT_WINDOW_HEIGHT));
    return {(2 * float(x) + 1) / ancho - 1, 1 - (2 * float(y) + 1) / alto};
}

inline void mueveElegido(const Editor &editor, const glm::vec2 &sitio) {
    glm::vec3 &punto = (*editor.puntos)[editor.elegido];
    const glm::vec3 antes = punto; // cerca del borde, que se pueda volver a coger
    punto = llevado(punto, editor.transformacion(), glm::clamp(sitio, -0.95f, 0.95f));
    if (editor.alMover)
        editor.alMover(editor.elegido, punto - antes);
    glutPostRedisplay();
}

inline void botonEditor(Editor &editor, int boton, int pulsado, int x, int y) {
    if (boton != GLUT_LEFT_BUTTON)
        return;
    editor.arrastrando = false;
    if (pulsado == GLUT_DOWN) {
        const glm::vec2 porUnidad(glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT));
        const int cual = masCercano(*editor.puntos, editor.transformacion(), ratonNormalizado(x, y),
                                    porUnidad / altoUtil(), 2 * ALCANCE_RATON);
        editor.arrastrando = cual >= 0;
        if (editor.arrastrando)
            editor.elegido = cual;
    }
    if (editor.conOrbita && !editor.arrastrando)
        orbitaBoton(boton, pulsado, x, y);
    glutPostRedisplay();
}

inline void arrastraEditor(const Editor &editor, int x, int y) {
    if (editor.arrastrando)
        mueveElegido(editor, ratonNormalizado(x, y));
    else if (editor.conOrbita)
        orbitaArrastra(x, y);
}

inline void especialEditor(const Editor &editor, int tecla) {
    if (teclaEspecialComun(tecla) || editor.elegido < 0)
        return;
    const float dx = PASO_FLECHA * 4 / 3 * altoUtil() * 2 / float(glutGet(GLUT_WINDOW_WIDTH)),
                dy = PASO_FLECHA * altoUtil() * 2 / float(glutGet(GLUT_WINDOW_HEIGHT));
    glm::vec2 paso;
    switch (tecla) {
    case GLUT_KEY_LEFT: paso = {-dx, 0}; break;
    case GLUT_KEY_RIGHT: paso = {dx, 0}; break;
    case GLUT_KEY_UP: paso = {0, dy}; break;
    case GLUT_KEY_DOWN: paso = {0, -dy}; break;
    default: return;
    }
    const glm::vec4 p = editor.transformacion() * glm::vec4((*editor.puntos)[editor.elegido], 1);
    mueveElegido(editor, glm::vec2(p) / p.w + paso);
}

/// Pone las funciones del ratón y de las teclas especiales.
inline void editaConRaton(Editor &editor) {
    static Editor *activo;
    activo = &editor;
    glutMouseFunc([](int boton, int pulsado, int x, int y) { botonEditor(*activo, boton, pulsado, x, y); });
    glutMotionFunc([](int x, int y) { arrastraEditor(*activo, x, y); });
    glutSpecialFunc([](int tecla, int, int) { especialEditor(*activo, tecla); });
}

/// Atiende n (elige el siguiente punto). Devuelve si la tecla era suya.
inline bool teclaEditor(Editor &editor, unsigned char tecla) {
    if (tecla != 'n')
        return false;
    editor.elegido = (editor.elegido + 1) % int(editor.puntos->size());
    glutPostRedisplay();
    return true;
}
