#include "estado.h"
#include <algorithm>
#include <cmath>
#include <iterator>

namespace explica {

Guardado::Guardado() {
    for (int i = 0; i < 6; ++i)
        activo[i] = glIsEnabled(INTERRUPTORES[i]);
    for (int i = 0; i < 4; ++i)
        paquete[i] = entero(PAQUETE[i]);
    glGetBooleanv(GL_COLOR_WRITEMASK, mascaraColor);
    mascaraProfundidad = entero(GL_DEPTH_WRITEMASK);
    mascaraPlantilla[0] = entero(GL_STENCIL_WRITEMASK);
    mascaraPlantilla[1] = entero(GL_STENCIL_BACK_WRITEMASK);
    funcionProfundidad = entero(GL_DEPTH_FUNC);
    glGetIntegerv(GL_SCISSOR_BOX, recorte);
    glGetFloatv(GL_COLOR_CLEAR_VALUE, colorDeBorrar);
    programa = entero(GL_CURRENT_PROGRAM);
    vao = entero(GL_VERTEX_ARRAY_BINDING);
    indices = vao ? entero(GL_ELEMENT_ARRAY_BUFFER_BINDING) : 0;
    lectura = entero(GL_COPY_READ_BUFFER_BINDING);
    dibuja = entero(GL_DRAW_FRAMEBUFFER_BINDING);
    lee = entero(GL_READ_FRAMEBUFFER_BINDING);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(dibuja)); // el que se va a leer
    buferDeLeer = entero(GL_READ_BUFFER);
    buferPaquete = entero(GL_PIXEL_PACK_BUFFER_BINDING);
    renderbuffer = entero(GL_RENDERBUFFER_BINDING);
    unidad = entero(GL_ACTIVE_TEXTURE);
    textura = entero(GL_TEXTURE_BINDING_2D);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    for (int i = 0; i < 4; ++i)
        glPixelStorei(PAQUETE[i], i == 0);
}

Guardado::~Guardado() {
    for (int i = 0; i < 6; ++i)
        pon(INTERRUPTORES[i], activo[i]);
    for (int i = 0; i < 4; ++i)
        glPixelStorei(PAQUETE[i], paquete[i]);
    glColorMask(mascaraColor[0], mascaraColor[1], mascaraColor[2], mascaraColor[3]);
    glDepthMask(GLboolean(mascaraProfundidad));
    glStencilMaskSeparate(GL_FRONT, GLuint(mascaraPlantilla[0]));
    glStencilMaskSeparate(GL_BACK, GLuint(mascaraPlantilla[1]));
    glDepthFunc(GLenum(funcionProfundidad));
    glScissor(recorte[0], recorte[1], recorte[2], recorte[3]);
    glClearColor(colorDeBorrar[0], colorDeBorrar[1], colorDeBorrar[2], colorDeBorrar[3]);
    glUseProgram(GLuint(programa));
    glBindVertexArray(GLuint(vao));
    if (vao)
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, GLuint(indices));
    glBindBuffer(GL_COPY_READ_BUFFER, GLuint(lectura));
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(dibuja));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(dibuja));
    glReadBuffer(GLenum(buferDeLeer));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(lee));
    glBindBuffer(GL_PIXEL_PACK_BUFFER, GLuint(buferPaquete));
    glBindRenderbuffer(GL_RENDERBUFFER, GLuint(renderbuffer));
    glActiveTexture(GLenum(unidad));
    glBindTexture(GL_TEXTURE_2D, GLuint(textura));
}

bool Guardado::lleva(GLenum interruptor) const {
    const auto donde = std::find(std::begin(INTERRUPTORES), std::end(INTERRUPTORES), interruptor);
    return activo[donde - std::begin(INTERRUPTORES)];
}

bool Guardado::escribeColor() const {
    return mascaraColor[0] || mascaraColor[1] || mascaraColor[2] || mascaraColor[3];
}

void pon(GLenum interruptor, bool activo) {
    (activo ? glEnable : glDisable)(interruptor);
}

namespace {

GLint deAdjunto(GLenum objetivo, GLenum adjunto, GLenum cual) {
    GLint valor = 0;
    glGetFramebufferAttachmentParameteriv(objetivo, adjunto, cual, &valor);
    return valor;
}

bool hayAdjunto(GLenum objetivo, GLenum adjunto) {
    return deAdjunto(objetivo, adjunto, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE;
}

// La talla y el formato de lo que hay adjunto, sea textura o renderbuffer.
void mide(GLenum objetivo, GLenum adjunto, Lienzo &lienzo) {
    const GLint tipo = deAdjunto(objetivo, adjunto, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE);
    if (tipo == GL_NONE)
        return;
    const GLuint nombre = GLuint(deAdjunto(objetivo, adjunto, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
    GLint formato = 0;
    if (tipo == GL_RENDERBUFFER) {
        const GLint antes = entero(GL_RENDERBUFFER_BINDING);
        glBindRenderbuffer(GL_RENDERBUFFER, nombre);
        glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, &lienzo.ancho);
        glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_HEIGHT, &lienzo.alto);
        glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &lienzo.muestras);
        glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_INTERNAL_FORMAT, &formato);
        glBindRenderbuffer(GL_RENDERBUFFER, GLuint(antes));
    } else {
        const GLint nivel = deAdjunto(objetivo, adjunto, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL);
        const GLint cara = deAdjunto(objetivo, adjunto, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE);
        const GLenum cual = cara ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
        const GLint antes = entero(cara ? GL_TEXTURE_BINDING_CUBE_MAP : GL_TEXTURE_BINDING_2D);
        glBindTexture(cual, nombre);
        const GLenum lado = cara ? GLenum(cara) : GL_TEXTURE_2D;
        glGetTexLevelParameteriv(lado, nivel, GL_TEXTURE_WIDTH, &lienzo.ancho);
        glGetTexLevelParameteriv(lado, nivel, GL_TEXTURE_HEIGHT, &lienzo.alto);
        glGetTexLevelParameteriv(lado, nivel, GL_TEXTURE_INTERNAL_FORMAT, &formato);
        glBindTexture(cual, GLuint(antes));
    }
    if (EN_WEB && !lienzo.ancho) { // de una textura no lo dice
        GLint vista[4];
        glGetIntegerv(GL_VIEWPORT, vista);
        lienzo.ancho = vista[0] + vista[2];
        lienzo.alto = vista[1] + vista[3];
    }
    lienzo.formato = GLenum(formato);
}

} // namespace

int bitsDe(GLenum objetivo, GLenum adjunto, GLenum cual) {
    return hayAdjunto(objetivo, adjunto) ? deAdjunto(objetivo, adjunto, cual) : 0;
}

Lienzo lienzoActual(int ancho, int alto, GLenum objetivo) {
    const bool dibujo = objetivo == GL_DRAW_FRAMEBUFFER;
    Lienzo l;
    l.nombre = GLuint(entero(dibujo ? GL_DRAW_FRAMEBUFFER_BINDING : GL_READ_FRAMEBUFFER_BINDING));
    l.buferColor = GLenum(entero(dibujo ? GL_DRAW_BUFFER0 : GL_READ_BUFFER));
    const bool ventana = l.nombre == 0;
    if (ventana) {
        l.ancho = ancho;
        l.alto = alto;
        bitsDeLaVentana(objetivo, l);
        return l;
    }
    const GLenum profundidad = GL_DEPTH_ATTACHMENT, plantilla = GL_STENCIL_ATTACHMENT;
    l.bitsProfundidad = bitsDe(objetivo, profundidad, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
    l.bitsPlantilla = bitsDe(objetivo, plantilla, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE);
    mide(objetivo, profundidad, l);
    if (l.buferColor != GL_NONE && hayAdjunto(objetivo, l.buferColor)) {
        mide(objetivo, l.buferColor, l);
        l.componentes = GLenum(deAdjunto(objetivo, l.buferColor, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE));
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

Color leeColor(const Lienzo &l, int x, int y) {
    const std::vector<float> rgba = leeColores(l, x, y, 1, 1);
    Color color;
    for (std::size_t i = 0; i < 4; ++i) // de 8 bits salen enteros
        color[i] = l.componentes == GL_UNSIGNED_NORMALIZED ? std::round(rgba[i] * 255.0) : rgba[i] * 255.0;
    return color;
}

} // namespace explica
