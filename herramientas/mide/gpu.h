// Dibujar en la GPU para medir: el contexto, un framebuffer con profundidad y lo que se ha dibujado en él.
#pragma once
#include "contexto_suelto.h"
#include "imagen.h"
#include "shader.h"
#include <functional>

namespace mide {

/// Un framebuffer propio. Con profundidad siempre: sin ella llvmpipe se salta lo que un rectángulo opaco va a tapar.
class Framebuffer {
public:
    const int ancho, alto;

    Framebuffer(int elAncho, int elAlto, int muestras = 0, GLenum profundidad = GL_DEPTH_COMPONENT24)
        : ancho(elAncho), alto(elAlto) {
        glGenFramebuffers(1, &nombre);
        glGenRenderbuffers(2, renderbuffers);
        glBindFramebuffer(GL_FRAMEBUFFER, nombre);
        const GLenum formatos[2] = {GL_RGBA8, profundidad},
                     sitios[2] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
        for (int i = 0; i < 2; ++i) {
            glBindRenderbuffer(GL_RENDERBUFFER, renderbuffers[i]);
            glRenderbufferStorageMultisample(GL_RENDERBUFFER, muestras, formatos[i], ancho, alto);
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, sitios[i], GL_RENDERBUFFER, renderbuffers[i]);
        }
        abre();
    }
    Framebuffer(const Framebuffer &) = delete;
    ~Framebuffer() {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glDeleteFramebuffers(1, &nombre);
        glDeleteRenderbuffers(2, renderbuffers);
    }
    /// Dibujar en él desde ahora.
    void abre() const {
        glBindFramebuffer(GL_FRAMEBUFFER, nombre);
        glViewport(0, 0, ancho, alto);
    }
    void borra(float r, float g, float b) const {
        abre();
        glClearColor(r, g, b, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    }
    Imagen lee() const {
        Imagen imagen{ancho, alto, std::vector<unsigned char>(3 * ancho * alto)};
        glBindFramebuffer(GL_FRAMEBUFFER, nombre);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, ancho, alto, GL_RGB, GL_UNSIGNED_BYTE, imagen.rgb.data());
        return imagen;
    }
    GLuint nombre = 0;

private:
    GLuint renderbuffers[2] = {};
};

/// Lo que se cronometra: dibujar y esperar a que la GPU acabe.
inline std::function<void()> yEspera(const std::function<void()> &dibuja) {
    return [dibuja] {
        dibuja();
        glFinish();
    };
}

/// El rectángulo de imagen.vert, que llena el área de dibujo, con el programa en uso.
inline void dibujaRectangulo() {
    static GLuint vao = 0;
    if (!vao)
        glGenVertexArrays(1, &vao);
    glBindVertexArray(vao);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

} // namespace mide
