// Lo que el enlace con ventana añade a FreeGLUT: si no puede abrirla, una línea en español en vez de los detalles de X.
// Vale para todos los programas sin que hagan nada: los manejadores se ponen antes de main.
#include "error.h"
#include <GL/freeglut.h>
#include <GL/glx.h>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

const std::string SIN_OPENGL = "hace falta OpenGL 3.1 y esta pantalla no lo da: ";

void fallaFreeglut(const char *formato, va_list valores) {
    char texto[500];
    std::vsnprintf(texto, sizeof texto, formato, valores);
    if (std::strstr(formato, "open display"))
        falla(std::string("no hay pantalla en que abrir la ventana: ") + texto);
    falla((std::strstr(formato, "OpenGL") ? SIN_OPENGL : "FreeGLUT: ") + texto);
}

int fallaX(Display *pantalla, XErrorEvent *error) {
    char texto[500];
    XGetErrorText(pantalla, error->error_code, texto, sizeof texto);
    falla((glXGetCurrentContext() ? "error de X: " : SIN_OPENGL) + texto);
}

[[maybe_unused]] const bool puestos = [] {
    glutInitErrorFunc(fallaFreeglut);
    XSetErrorHandler(fallaX);
    return std::atexit(compruebaSalida) == 0;
}();

} // namespace
