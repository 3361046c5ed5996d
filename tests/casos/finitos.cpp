// Se antepone (LD_PRELOAD) a un programa enlazado con OSMesa: la ventana pasa a ser de float, y también sus
// framebuffers propios de 8 bits; cada vez que se lee la ventana se mira que todos sus colores sean finitos. Al cambiar
// de talla se llena de NaN, que es lo que queda donde nadie pinta. Si algún color no es finito se dice dónde y el
// programa acaba con 4. Lo que tapa otro color no se ve, ni lo que se lee de un framebuffer propio sin pasar por la
// ventana.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <deque>
#include <dlfcn.h>
#include <unistd.h>
#include <vector>
// clang-format off
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>
// clang-format on

namespace {

/// La función que se ha tapado.
template<class Funcion>
Funcion laDeVerdad(const char *nombre) {
    return reinterpret_cast<Funcion>(dlsym(RTLD_NEXT, nombre));
}

/// La de OpenGL de ese nombre.
template<class Funcion>
Funcion deOpenGL(const char *nombre) {
    static const auto original = laDeVerdad<decltype(&OSMesaGetProcAddress)>("OSMesaGetProcAddress");
    return reinterpret_cast<Funcion>(original(nombre));
}

/// Donde un color cabe en 8 bits por componente, en float.
GLenum enFloat(GLenum formato) {
    return formato == GL_RGB8 || formato == GL_RGBA8 || formato == GL_RGB || formato == GL_RGBA ? GL_RGBA32F
                                                                                                : formato;
}
void renderbufferStorage(GLenum objetivo, GLenum formato, GLsizei ancho, GLsizei alto) {
    static const auto original = deOpenGL<PFNGLRENDERBUFFERSTORAGEPROC>("glRenderbufferStorage");
    original(objetivo, enFloat(formato), ancho, alto);
}
void renderbufferStorageMultisample(GLenum objetivo, GLsizei muestras, GLenum formato, GLsizei ancho,
                                    GLsizei alto) {
    static const auto original =
        deOpenGL<PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC>("glRenderbufferStorageMultisample");
    original(objetivo, muestras, enFloat(formato), ancho, alto);
}

/// La ventana entera, sin que el programa note nada.
void llenaDeNaN() {
    static const auto enlaza = deOpenGL<PFNGLBINDFRAMEBUFFERPROC>("glBindFramebuffer");
    GLint framebuffer = 0;
    GLfloat fondo[4];
    GLboolean escribe[4];
    const GLboolean recorta = glIsEnabled(GL_SCISSOR_TEST);
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
    glGetFloatv(GL_COLOR_CLEAR_VALUE, fondo);
    glGetBooleanv(GL_COLOR_WRITEMASK, escribe);
    enlaza(GL_DRAW_FRAMEBUFFER, 0);
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearColor(NAN, NAN, NAN, NAN);
    glClear(GL_COLOR_BUFFER_BIT);
    glClearColor(fondo[0], fondo[1], fondo[2], fondo[3]);
    glColorMask(escribe[0], escribe[1], escribe[2], escribe[3]);
    if (recorta)
        glEnable(GL_SCISSOR_TEST);
    enlaza(GL_DRAW_FRAMEBUFFER, GLuint(framebuffer));
}

[[noreturn]] void acaba(const char *que, double valor, GLint x, GLint y) {
    std::fprintf(stderr, "finitos: %s %g en (%d, %d)\n", que, valor, x, y);
    _exit(4);
}

} // namespace

extern "C" {

GLboolean OSMesaMakeCurrent(OSMesaContext contexto, void *, GLenum, GLsizei ancho, GLsizei alto) {
    static std::deque<std::vector<GLfloat>> memorias; // OSMesa usa cada una hasta que tiene la siguiente
    memorias.emplace_back(4 * std::size_t(ancho) * alto);
    static const auto original = laDeVerdad<decltype(&OSMesaMakeCurrent)>("OSMesaMakeCurrent");
    const GLboolean puede = original(contexto, memorias.back().data(), GL_FLOAT, ancho, alto);
    if (puede)
        llenaDeNaN();
    return puede;
}

OSMESAproc OSMesaGetProcAddress(const char *nombre) {
    if (std::strcmp(nombre, "glRenderbufferStorage") == 0)
        return reinterpret_cast<OSMESAproc>(renderbufferStorage);
    if (std::strcmp(nombre, "glRenderbufferStorageMultisample") == 0)
        return reinterpret_cast<OSMESAproc>(renderbufferStorageMultisample);
    return deOpenGL<OSMESAproc>(nombre);
}

void glTexImage2D(GLenum objetivo, GLint nivel, GLint interno, GLsizei ancho, GLsizei alto, GLint borde,
                  GLenum formato, GLenum tipo, const void *datos) {
    static const auto original = laDeVerdad<decltype(&glTexImage2D)>("glTexImage2D");
    if (!datos) // sin datos: se va a dibujar en ella
        interno = GLint(enFloat(GLenum(interno)));
    original(objetivo, nivel, interno, ancho, alto, borde, formato, tipo, datos);
}

void glReadPixels(GLint x, GLint y, GLsizei ancho, GLsizei alto, GLenum formato, GLenum tipo, void *datos) {
    static const auto original = laDeVerdad<decltype(&glReadPixels)>("glReadPixels");
    GLint framebuffer = 0;
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &framebuffer);
    if (framebuffer == 0) {
        std::vector<GLfloat> color(4 * std::size_t(ancho) * alto, NAN);
        // OSMesa no dice que su framebuffer sea de float, y al leerlo se recortaría
        static const auto recorta = deOpenGL<PFNGLCLAMPCOLORPROC>("glClampColor");
        recorta(GL_CLAMP_READ_COLOR, GL_FALSE);
        original(x, y, ancho, alto, GL_RGBA, GL_FLOAT, color.data());
        recorta(GL_CLAMP_READ_COLOR, GL_FIXED_ONLY);
        for (std::size_t i = 0; i < color.size(); ++i)
            if (!std::isfinite(color[i]))
                acaba("un color", color[i], x + int(i) / 4 % ancho, y + int(i) / 4 / ancho);
    }
    original(x, y, ancho, alto, formato, tipo, datos);
}

} // extern "C"
