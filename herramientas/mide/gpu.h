// Dibujar en la GPU para medir, en el contexto que abre mide.cpp: un framebuffer con profundidad y lo que se ha
// dibujado en él.
#pragma once
#include "ch09_imagen/imagen_en_ventana.h"
#include "mide.h"

namespace mide {

/// Lo que hay en el framebuffer enlazado.
inline Imagen leeDibujado(const glm::ivec2 &talla) {
    Imagen imagen{talla.x, talla.y, std::vector<unsigned char>(3 * talla.x * talla.y)};
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, talla.x, talla.y, GL_RGB, GL_UNSIGNED_BYTE, imagen.rgb.data());
    return imagen;
}

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
    operator glm::ivec2() const {
        return {ancho, alto};
    }
    /// Dibujar en él desde ahora.
    void abre() const {
        glBindFramebuffer(GL_FRAMEBUFFER, nombre);
        glViewport(0, 0, ancho, alto);
    }
    void borra(const glm::vec3 &color) const {
        abre();
        glClearColor(color.r, color.g, color.b, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    }
    Imagen lee() const {
        glBindFramebuffer(GL_FRAMEBUFFER, nombre);
        return leeDibujado({ancho, alto});
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

/// Las variantes que dejan una imagen de esa talla: con ella se mide su error, y se cronometra lo que la dibuja.
struct Dibujadas {
    Medidor &m;
    glm::ivec2 talla;
    std::function<double(const Imagen &)> error;

    void operator()(const std::string &nombre, const std::string &nota,
                    const std::function<void()> &dibuja) const {
        dibuja();
        const Imagen imagen = leeDibujado(talla);
        m.variante(nombre, nota, error(imagen), 1, yEspera(dibuja), imagen);
    }
};

} // namespace mide
