#include "estado.h"

namespace explica {

std::vector<float> leeProfundidades(const Lienzo &l, int x, int y, int ancho, int alto) {
    std::vector<float> leidas(std::size_t(ancho) * std::size_t(alto));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, l.nombre);
    glReadPixels(x, y, ancho, alto, GL_DEPTH_COMPONENT, GL_FLOAT, leidas.data());
    return leidas;
}

std::vector<unsigned char> leePlantilla(const Lienzo &l, int x, int y, int ancho, int alto) {
    std::vector<unsigned char> leida(std::size_t(ancho) * std::size_t(alto));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, l.nombre);
    glReadPixels(x, y, ancho, alto, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, leida.data());
    return leida;
}

void leePixeles(const Lienzo &, int x, int y, int ancho, int alto, float *rgba) {
    glReadPixels(x, y, ancho, alto, GL_RGBA, GL_FLOAT, rgba);
}

long muestrasDe(const std::function<void()> &dibuja) {
    GLint otra = 0;
    glGetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &otra);
    if (otra) {
        dibuja();
        return -1;
    }
    static GLuint consulta = 0;
    if (!consulta)
        glGenQueries(1, &consulta);
    GLuint pasan = 0;
    glBeginQuery(GL_SAMPLES_PASSED, consulta);
    dibuja();
    glEndQuery(GL_SAMPLES_PASSED);
    glGetQueryObjectuiv(consulta, GL_QUERY_RESULT, &pasan);
    return long(pasan);
}

void preguntaSiDibuja(const std::function<void()> &dibuja, int) {
    dibuja();
}

long dibujaYCuenta(const std::function<void()> &dibuja, int) {
    return muestrasDe(dibuja);
}

// OSMesa guarda la ventana al revés que los demás framebuffers, y las derivadas se toman de una fila de cada cuatro
// píxeles: donde de ellas depende algo (qué nivel de una textura), el color puede ser otro.
void abreAparte(const Lienzo &l) {
    static GLuint marco = 0, color = 0, profundidad = 0;
    static int ancho = 0, alto = 0, bits = 0;
    if (!marco) {
        glGenFramebuffers(1, &marco);
        glGenRenderbuffers(1, &color);
        glGenRenderbuffers(1, &profundidad);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, marco);
    if (l.ancho <= ancho && l.alto <= alto && l.bitsProfundidad == bits)
        return;
    ancho = l.ancho, alto = l.alto, bits = l.bitsProfundidad;
    glBindRenderbuffer(GL_RENDERBUFFER, color);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, ancho, alto);
    glBindRenderbuffer(GL_RENDERBUFFER, profundidad);
    glRenderbufferStorage(GL_RENDERBUFFER,
                          bits == 16   ? GL_DEPTH_COMPONENT16
                          : bits == 32 ? GL_DEPTH_COMPONENT32F
                                       : GL_DEPTH_COMPONENT24,
                          ancho, alto);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, profundidad);
}

float profundidadAparte(int x, int y) {
    float profundidad = 0;
    glReadPixels(x, y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &profundidad);
    return profundidad;
}

void bitsDeLaVentana(GLenum objetivo, Lienzo &l) {
    l.bitsProfundidad = bitsDe(objetivo, GL_DEPTH, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
    l.bitsPlantilla = bitsDe(objetivo, GL_STENCIL, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE);
}

GLint pideLaPlantilla() {
    return entero(GL_STENCIL_REF);
}

} // namespace explica
