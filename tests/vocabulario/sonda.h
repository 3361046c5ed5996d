// Una sonda: un shader suelto que la GPU ejecuta en un único píxel y devuelve en float, sin recortar ni redondear.
#pragma once
#include "mide/contexto_suelto.h"
#include "prueba.h"
#include "shader.h"

/// Deja enlazado un framebuffer de un píxel de ese formato.
inline void enlazaUnPixel(GLenum formato) {
    GLuint color = 0, framebuffer = 0;
    glGenRenderbuffers(1, &color);
    glBindRenderbuffer(GL_RENDERBUFFER, color);
    glRenderbufferStorage(GL_RENDERBUFFER, formato, 1, 1);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
}

/// La primera vez abre una ventana sin pantalla con un framebuffer de un píxel.
inline void abreSonda() {
    static bool abierta = false;
    if (!abierta) {
        abreContexto();
        enlazaUnPixel(GL_RGBA32F);
        glClampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
        abierta = true;
    }
}

/// Programa de un fragment shader para la sonda, que queda abierta.
inline GLuint creaSonda(const std::string &frag) {
    abreSonda();
    return creaPrograma("tests/vocabulario/sonda.vert", frag);
}

/// El color que da el programa en uso; NaN en los cuatro si no dibuja nada.
inline glm::vec4 leeSonda() {
    glClearColor(NAN, NAN, NAN, NAN);
    glClear(GL_COLOR_BUFFER_BIT);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glm::vec4 color(NAN);
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, glm::value_ptr(color));
    return color;
}
