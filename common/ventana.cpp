#include "ventana.h"
#include "error.h"
#include "imagen.h"
#include "shader.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>

namespace {

const unsigned char ESC = 27;

void teclado(unsigned char tecla, int, int) {
    teclaComun(tecla);
}

void tecladoEspecial(int tecla, int, int) {
    teclaEspecialComun(tecla);
}

void guardaVentana() {
    std::string fichero;
    for (int n = 1; fichero.empty() || std::filesystem::exists(fichero); ++n)
        fichero = nombrePrograma() + "-" + std::to_string(n) + ".ppm";
    guardaPpm(fichero, leeVentana());
    std::printf("guardado %s\n", fichero.c_str());
}

} // namespace

void abreVentana(int &argc, char **argv, const char *titulo, int ancho, int alto, unsigned modo,
                 const char *argumentos) {
    glutInitWindowSize(ancho, alto); // antes de glutInit, para que valga la opción -geometry
    glutInit(&argc, argv);
    glutInitDisplayMode(modo);
    glutInitContextVersion(3, 1);
    glutSetOption(GLUT_ACTION_ON_WINDOW_CLOSE, GLUT_ACTION_GLUTMAINLOOP_RETURNS);
    for (int i = 1; i < argc; ++i) {
        const std::string uso =
            "uso: " + nombrePrograma() + " [opciones de GLUT] " + (argumentos ? argumentos : "");
        if (std::string(argv[i]) == "-ayuda") {
            std::puts(uso.c_str());
            std::exit(0);
        }
        // una opción (-x) es del programa si su forma de uso la nombra
        if (!argumentos || (argv[i][0] == '-' && !std::strstr(argumentos, argv[i])))
            falla("no entiendo «" + std::string(argv[i]) + "»; " + uso, 2);
    }
    glutCreateWindow(titulo);
    glewExperimental = GL_TRUE;
    glewInit(); // su resultado no sirve: sin GLX da error aunque haya encontrado todas las funciones
    if (!GLEW_VERSION_3_1 || !glGenVertexArrays)
        falla("hace falta OpenGL 3.1 y hay " +
              std::string(reinterpret_cast<const char *>(glGetString(GL_VERSION))));
    glutKeyboardFunc(teclado);
    glutSpecialFunc(tecladoEspecial);
}

bool teclaComun(unsigned char tecla) {
    if (tecla == ESC)
        glutLeaveMainLoop();
    return tecla == ESC;
}

bool teclaEspecialComun(int tecla) {
    switch (tecla) {
    case GLUT_KEY_F5:
        recargaProgramas();
        glutPostRedisplay();
        return true;
    case GLUT_KEY_F11: glutFullScreenToggle(); return true;
    case GLUT_KEY_F12: guardaVentana(); return true;
    default: return false;
    }
}

float relacionAspecto() {
    const int ancho = std::max(glutGet(GLUT_WINDOW_WIDTH), 1),
              alto = std::max(glutGet(GLUT_WINDOW_HEIGHT), 1);
    return static_cast<float>(ancho) / static_cast<float>(alto);
}

glm::mat4 perspectivaVentana(float angulo, float cerca, float lejos, float aspecto) {
    const float vertical = aspecto < 1 ? 2 * std::atan(std::tan(angulo / 2) / aspecto) : angulo;
    return glm::perspective(vertical, aspecto, cerca, lejos);
}

glm::mat4 paralelaVentana(float semilado, float cerca, float lejos, float aspecto) {
    const float x = semilado * std::max(aspecto, 1.0f), y = semilado * std::max(1 / aspecto, 1.0f);
    return glm::ortho(-x, x, -y, y, cerca, lejos);
}

Imagen leeVentana() {
    Imagen imagen{glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT), {}};
    imagen.rgb.resize(3 * static_cast<std::size_t>(imagen.ancho) * static_cast<std::size_t>(imagen.alto));
    GLint anterior = 0;
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &anterior);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, imagen.ancho, imagen.alto, GL_RGB, GL_UNSIGNED_BYTE, imagen.rgb.data());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(anterior));
    return imagen;
}
