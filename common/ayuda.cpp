#include "ayuda.h"
#include "colores.h"
#include "encima.h"
#include "error.h"
#include "rotulo.h"
#include <GL/glew.h>
#include <GL/freeglut.h>
#include <map>

namespace {

bool puesta = false;

const std::map<std::string, const char *> CONTROLES = {
#include "controles.inc" // lo escribe herramientas/base/controles.py
};

const char *const DE_TODOS =
    "F1 esta ayuda · F5 relee los shaders · F11 pantalla completa · F12 guarda la imagen";

// Encima de todo, en el framebuffer de la ventana. Deja OpenGL como está.
void pintaAyuda() {
    if (!puesta)
        return;
    GLint panel[4];
    glGetIntegerv(GL_VIEWPORT, panel);
    glViewport(0, 0, glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT));
    const VerticePintado a{{-1, -1, 0}, {0, 0}}, b{{1, -1, 0}, {0, 0}}, c{{1, 1, 0}, {0, 0}},
        d{{-1, 1, 0}, {0, 0}};
    const float cuanto =
        0.85f; // de 1, lo que el velo tapa: el atlas vale 0 en su esquina y encima.frag le suma ½
    pintaEncima({"velo", OSCURO, 0, {}, ""}, {a, b, c, a, c, d}, {{OSCURO, 0.5f - cuanto, 1}}, false);
    rotula(controlesDelPrograma(), {0.5f, 0.5f}, BLANCO);
    glViewport(panel[0], panel[1], panel[2], panel[3]);
}

} // namespace

std::string controlesDelPrograma() {
    const auto suyos = CONTROLES.find(nombrePrograma());
    std::string lineas = (suyos == CONTROLES.end() ? "" : suyos->second + std::string(" · ")) + DE_TODOS;
    const std::string separador = " · ";
    for (std::size_t i; (i = lineas.find(separador)) != std::string::npos;)
        lineas.replace(i, separador.size(), "\n");
    return lineas;
}

void cambiaAyuda() {
    puesta = !puesta;
}

// common/comun.cmake enlaza con --wrap=glutSwapBuffers: un programa llama a esta, y aquí la de GLUT es __real_….
extern "C" void __real_glutSwapBuffers();

extern "C" void __wrap_glutSwapBuffers() {
    pintaAyuda();
    __real_glutSwapBuffers();
}
