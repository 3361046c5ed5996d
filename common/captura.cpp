#include "captura.h"
#include "error.h"
#include "glut/sistema/guarda.h"
#include <GL/glew.h>
#include <GL/freeglut.h>
#include <cstdio>
#include <filesystem>

// Con varias muestras por píxel, Mesa lee la primera y no su media: se lleva a un framebuffer de una, y se lee de ahí.
static void leeLaMedia(Imagen &imagen) {
    GLuint framebuffer, color;
    GLint deDibujo, renderbuffer;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &deDibujo);
    glGetIntegerv(GL_RENDERBUFFER_BINDING, &renderbuffer);
    glGenFramebuffers(1, &framebuffer);
    glGenRenderbuffers(1, &color);
    glBindRenderbuffer(GL_RENDERBUFFER, color);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, imagen.ancho, imagen.alto);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
    glBlitFramebuffer(0, 0, imagen.ancho, imagen.alto, 0, 0, imagen.ancho, imagen.alto, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glReadPixels(0, 0, imagen.ancho, imagen.alto, GL_RGB, GL_UNSIGNED_BYTE, imagen.rgb.data());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(deDibujo));
    glBindRenderbuffer(GL_RENDERBUFFER, GLuint(renderbuffer));
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteRenderbuffers(1, &color);
}

Imagen leeVentana() {
    Imagen imagen{glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT), {}};
    imagen.rgb.resize(std::size_t{3} * imagen.ancho * imagen.alto);
    const GLenum parametros[] = {GL_PACK_ALIGNMENT, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS,
                                 GL_PACK_SKIP_PIXELS};
    const GLint normales[] = {1, 0, 0, 0};
    GLint previos[4], framebuffer = 0, bufer = 0;
    for (int i = 0; i < 4; ++i) {
        glGetIntegerv(parametros[i], &previos[i]);
        glPixelStorei(parametros[i], normales[i]);
    }
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &framebuffer);
    glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &bufer);
    const auto enlaza = [](GLint cualFramebuffer, GLint cualBufer) {
        if (!glBindFramebuffer) // sin glewInit el programa no puede haber enlazado ninguno
            return;
        glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(cualFramebuffer));
        glBindBuffer(GL_PIXEL_PACK_BUFFER, GLuint(cualBufer));
    };
    enlaza(0, 0);
    if (glutGet(GLUT_WINDOW_NUM_SAMPLES) > 1)
        leeLaMedia(imagen);
    else
        glReadPixels(0, 0, imagen.ancho, imagen.alto, GL_RGB, GL_UNSIGNED_BYTE, imagen.rgb.data());
    enlaza(framebuffer, bufer);
    for (int i = 0; i < 4; ++i)
        glPixelStorei(parametros[i], previos[i]);
    return imagen;
}

void guardaVentana() {
    std::string fichero;
    std::error_code nadie; // en una carpeta que no se deja mirar, quien se queja es intentaGuardar
    for (int n = 1; fichero.empty() || std::filesystem::exists(fichero, nadie); ++n)
        fichero = nombrePrograma() + "-" + std::to_string(n) + ".png";
    std::string error;
    if (!intentaGuardar(fichero, enPng(leeVentana()), error))
        return avisa(error);
    std::printf("guardado %s\n", fichero.c_str());
    std::fflush(stdout);
}
