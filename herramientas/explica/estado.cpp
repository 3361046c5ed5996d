#include "estado.h"
#include <algorithm>
#include <cmath>
#include <iterator>

namespace explica {

Guardado::Guardado() {
    const auto guarda = [&](GLenum cual, void (*pone)(GLint)) {
        repone.push_back([=, valor = entero(cual)] { pone(valor); });
    };
    for (int i = 0; i < 6; ++i)
        activo[i] = glIsEnabled(INTERRUPTORES[i]);
    for (const GLenum cual :
         {GL_PACK_ALIGNMENT, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS}) {
        repone.push_back([=, valor = entero(cual)] { glPixelStorei(cual, valor); });
        glPixelStorei(cual, cual == GL_PACK_ALIGNMENT);
    }
    repone.push_back([m = mascaraDeColor()] { glColorMask(m[0], m[1], m[2], m[3]); });
    guarda(GL_DEPTH_WRITEMASK, [](GLint v) { glDepthMask(GLboolean(v)); });
    guarda(GL_STENCIL_WRITEMASK, [](GLint v) { glStencilMaskSeparate(GL_FRONT, GLuint(v)); });
    guarda(GL_STENCIL_BACK_WRITEMASK, [](GLint v) { glStencilMaskSeparate(GL_BACK, GLuint(v)); });
    guarda(GL_DEPTH_FUNC, [](GLint v) { glDepthFunc(GLenum(v)); });
    repone.push_back([r = cuatro(GL_SCISSOR_BOX)] { glScissor(r[0], r[1], r[2], r[3]); });
    std::array<GLfloat, 4> borra{};
    glGetFloatv(GL_COLOR_CLEAR_VALUE, borra.data());
    repone.push_back([=] { glClearColor(borra[0], borra[1], borra[2], borra[3]); });
    guarda(GL_CURRENT_PROGRAM, [](GLint v) { glUseProgram(GLuint(v)); });
    guarda(GL_VERTEX_ARRAY_BINDING, [](GLint v) { glBindVertexArray(GLuint(v)); });
    if (entero(GL_VERTEX_ARRAY_BINDING))
        guarda(GL_ELEMENT_ARRAY_BUFFER_BINDING,
               [](GLint v) { glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, GLuint(v)); });
    guarda(GL_COPY_READ_BUFFER_BINDING, [](GLint v) { glBindBuffer(GL_COPY_READ_BUFFER, GLuint(v)); });
    guarda(GL_DRAW_FRAMEBUFFER_BINDING, [](GLint v) { glBindFramebuffer(GL_FRAMEBUFFER, GLuint(v)); });
    const GLint lee = entero(GL_READ_FRAMEBUFFER_BINDING);
    glBindFramebuffer(GL_READ_FRAMEBUFFER,
                      GLuint(entero(GL_DRAW_FRAMEBUFFER_BINDING))); // el que se va a leer
    guarda(GL_READ_BUFFER, [](GLint v) { glReadBuffer(GLenum(v)); });
    repone.push_back([=] { glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(lee)); });
    guarda(GL_PIXEL_PACK_BUFFER_BINDING, [](GLint v) { glBindBuffer(GL_PIXEL_PACK_BUFFER, GLuint(v)); });
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    guarda(GL_RENDERBUFFER_BINDING, [](GLint v) { glBindRenderbuffer(GL_RENDERBUFFER, GLuint(v)); });
    guarda(GL_ACTIVE_TEXTURE, [](GLint v) { glActiveTexture(GLenum(v)); });
    guarda(GL_TEXTURE_BINDING_2D, [](GLint v) { glBindTexture(GL_TEXTURE_2D, GLuint(v)); });
}

Guardado::~Guardado() {
    for (int i = 0; i < 6; ++i)
        pon(INTERRUPTORES[i], activo[i]);
    for (const auto &una : repone)
        una();
}

bool Guardado::lleva(GLenum interruptor) const {
    const auto donde = std::find(std::begin(INTERRUPTORES), std::end(INTERRUPTORES), interruptor);
    return activo[donde - std::begin(INTERRUPTORES)];
}

void pon(GLenum interruptor, bool activo) {
    (activo ? glEnable : glDisable)(interruptor);
}

namespace {

GLint delAdjunto(GLenum objetivo, GLenum adjunto, GLenum que) {
    return contesta(glGetFramebufferAttachmentParameteriv, objetivo, adjunto, que);
}

bool hayAdjunto(GLenum objetivo, GLenum adjunto) {
    return delAdjunto(objetivo, adjunto, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE;
}

// La talla y el formato de lo que hay adjunto, sea textura o renderbuffer.
void mide(GLenum objetivo, GLenum adjunto, Lienzo &lienzo) {
    const GLint tipo = delAdjunto(objetivo, adjunto, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE);
    if (tipo == GL_NONE)
        return;
    const GLuint nombre = GLuint(delAdjunto(objetivo, adjunto, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
    if (tipo == GL_RENDERBUFFER) {
        const GLint antes = entero(GL_RENDERBUFFER_BINDING);
        glBindRenderbuffer(GL_RENDERBUFFER, nombre);
        glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, &lienzo.ancho);
        glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_HEIGHT, &lienzo.alto);
        glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &lienzo.muestras);
        lienzo.formato =
            GLenum(contesta(glGetRenderbufferParameteriv, GL_RENDERBUFFER, GL_RENDERBUFFER_INTERNAL_FORMAT));
        glBindRenderbuffer(GL_RENDERBUFFER, GLuint(antes));
    } else {
        const GLint nivel = delAdjunto(objetivo, adjunto, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL);
        const GLint cara = delAdjunto(objetivo, adjunto, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE);
        lienzo.textura = nivel || cara ? 0 : nombre;
        const GLenum cual = cara ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
        const GLint antes = entero(cara ? GL_TEXTURE_BINDING_CUBE_MAP : GL_TEXTURE_BINDING_2D);
        glBindTexture(cual, nombre);
        const GLenum lado = cara ? GLenum(cara) : GL_TEXTURE_2D;
        glGetTexLevelParameteriv(lado, nivel, GL_TEXTURE_WIDTH, &lienzo.ancho);
        glGetTexLevelParameteriv(lado, nivel, GL_TEXTURE_HEIGHT, &lienzo.alto);
        lienzo.formato = GLenum(contesta(glGetTexLevelParameteriv, lado, nivel, GL_TEXTURE_INTERNAL_FORMAT));
        glBindTexture(cual, GLuint(antes));
    }
    if (EN_WEB && !lienzo.ancho) { // de una textura no lo dice
        const auto vista = cuatro(GL_VIEWPORT);
        lienzo.ancho = vista[0] + vista[2];
        lienzo.alto = vista[1] + vista[3];
    }
}

} // namespace

int bitsDe(GLenum objetivo, GLenum adjunto, GLenum cual) {
    return hayAdjunto(objetivo, adjunto) ? delAdjunto(objetivo, adjunto, cual) : 0;
}

Lienzo lienzoActual(int ancho, int alto, GLenum objetivo) {
    const bool dibujo = objetivo == GL_DRAW_FRAMEBUFFER;
    Lienzo l;
    l.nombre = GLuint(entero(dibujo ? GL_DRAW_FRAMEBUFFER_BINDING : GL_READ_FRAMEBUFFER_BINDING));
    l.buferColor = GLenum(entero(dibujo ? GL_DRAW_BUFFER0 : GL_READ_BUFFER));
    if (l.nombre == 0) { // la ventana
        l.ancho = ancho;
        l.alto = alto;
        bitsDeLaVentana(objetivo, l);
        return l;
    }
    const GLenum profundidad = GL_DEPTH_ATTACHMENT, plantilla = GL_STENCIL_ATTACHMENT;
    l.bitsProfundidad = bitsDe(objetivo, profundidad, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
    l.bitsPlantilla = bitsDe(objetivo, plantilla, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE);
    mide(objetivo, profundidad, l);
    l.textura = 0;
    if (l.buferColor != GL_NONE && hayAdjunto(objetivo, l.buferColor)) {
        mide(objetivo, l.buferColor, l);
        l.componentes = GLenum(delAdjunto(objetivo, l.buferColor, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE));
    } else {
        l.buferColor = GL_NONE;
    }
    return l;
}

std::vector<float> leeColores(const Lienzo &l, int x, int y, int ancho, int alto) {
    std::vector<float> rgba(std::size_t{4} * ancho * alto);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, l.nombre);
    if (l.muestras == 0 || l.nombre == 0) {
        if (l.buferColor != GL_NONE) // si no, del que se lea
            glReadBuffer(l.buferColor);
        leePixeles(l, x, y, ancho, alto, rgba.data());
        return rgba;
    }
    // de uno con muestras no se lee: antes se promedian en otro sin ellas
    const GLint dibujo = entero(GL_DRAW_FRAMEBUFFER_BINDING);
    glReadBuffer(l.buferColor);
    GLuint marco, pixeles;
    glGenFramebuffers(1, &marco);
    glGenRenderbuffers(1, &pixeles);
    glBindRenderbuffer(GL_RENDERBUFFER, pixeles);
    glRenderbufferStorage(GL_RENDERBUFFER, l.formato, ancho, alto);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, marco);
    glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, pixeles);
    const bool recorta = glIsEnabled(GL_SCISSOR_TEST);
    glDisable(GL_SCISSOR_TEST);
    glBlitFramebuffer(x, y, x + ancho, y + alto, 0, 0, ancho, alto, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    pon(GL_SCISSOR_TEST, recorta);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, marco);
    leePixeles(l, 0, 0, ancho, alto, rgba.data());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(dibujo));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, l.nombre);
    glDeleteFramebuffers(1, &marco);
    glDeleteRenderbuffers(1, &pixeles);
    return rgba;
}

std::vector<Pixel> coloresAparte(int x, int y, int ancho, int alto, const std::function<void()> &dibuja) {
    std::vector<Pixel> colores(std::size_t(ancho) * std::size_t(alto));
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_BLEND);
    glClearBufferfv(GL_COLOR, 0, NINGUNO.data());
    dibuja();
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glReadPixels(x, y, ancho, alto, GL_RGBA, GL_FLOAT, colores.data());
    return colores;
}

Color leeColor(const Lienzo &l, int x, int y) {
    const std::vector<float> rgba = leeColores(l, x, y, 1, 1);
    Color color;
    for (std::size_t i = 0; i < 4; ++i) // de 8 bits salen enteros
        color[i] = l.componentes == GL_UNSIGNED_NORMALIZED ? std::round(rgba[i] * 255.0) : rgba[i] * 255.0;
    return color;
}

} // namespace explica
