// Se antepone (LD_PRELOAD) a un programa enlazado con OSMesa: la ventana pasa a ser de float, y cada vez que se lee se mira que todos
// sus colores sean finitos. Si alguno no lo es se dice dónde y el programa acaba con 4. Lo que se dibuja en un framebuffer propio de
// 8 bits llega a la ventana ya recortado: un NaN de ahí no se ve.
#include <cmath>
#include <cstdio>
#include <cstdlib>
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

[[noreturn]] void acaba(const char *que, double valor, GLint x, GLint y) {
    std::fprintf(stderr, "finitos: %s %g en (%d, %d)\n", que, valor, x, y);
    _exit(4);
}

} // namespace

extern "C" {

GLboolean OSMesaMakeCurrent(OSMesaContext contexto, void *, GLenum, GLsizei ancho, GLsizei alto) {
    static std::deque<std::vector<GLfloat>> memorias; // OSMesa usa cada una hasta que tiene la siguiente
    memorias.emplace_back(4 * static_cast<std::size_t>(ancho) * static_cast<std::size_t>(alto));
    static const auto original = laDeVerdad<decltype(&OSMesaMakeCurrent)>("OSMesaMakeCurrent");
    return original(contexto, memorias.back().data(), GL_FLOAT, ancho, alto);
}

void glReadPixels(GLint x, GLint y, GLsizei ancho, GLsizei alto, GLenum formato, GLenum tipo, void *datos) {
    static const auto original = laDeVerdad<decltype(&glReadPixels)>("glReadPixels");
    GLint framebuffer = 0;
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &framebuffer);
    if (framebuffer == 0) {
        std::vector<GLfloat> color(4 * static_cast<std::size_t>(ancho) * static_cast<std::size_t>(alto), NAN);
        // OSMesa no dice que su framebuffer sea de float, y al leerlo se recortaría
        static const auto recorta =
            reinterpret_cast<PFNGLCLAMPCOLORPROC>(OSMesaGetProcAddress("glClampColor"));
        recorta(GL_CLAMP_READ_COLOR, GL_FALSE);
        original(x, y, ancho, alto, GL_RGBA, GL_FLOAT, color.data());
        recorta(GL_CLAMP_READ_COLOR, GL_FIXED_ONLY);
        for (std::size_t i = 0; i < color.size(); ++i)
            if (!std::isfinite(color[i]))
                acaba("un color", static_cast<double>(color[i]), x + static_cast<GLint>(i) / 4 % ancho,
                      y + static_cast<GLint>(i) / 4 / ancho);
    }
    original(x, y, ancho, alto, formato, tipo, datos);
}

} // extern "C"
