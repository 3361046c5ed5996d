// OpenGL, para quien se pone delante de él: las funciones que se tapan, como son de verdad.
#pragma once
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <array>

// En la página (web.cpp) las que se tapan son las que llaman los programas, y las de verdad se llaman de otra manera.
#ifdef __EMSCRIPTEN__
#define DE_VERDAD(funcion) emscripten_##funcion
#define DECLARA(funcion) extern "C" decltype(funcion) DE_VERDAD(funcion);
#else
#define DE_VERDAD(funcion) funcion
#define DECLARA(funcion)
#endif

namespace explica {

#ifdef __EMSCRIPTEN__
constexpr bool EN_WEB = true;
#else
constexpr bool EN_WEB = false;
#endif

using Direccion = void (*)();

struct DeVerdad {
    decltype(&glClear) borra;
    decltype(&glDrawArrays) dibujaVertices;
    decltype(&glDrawElements) dibujaIndices;
};
const DeVerdad &deVerdad();

/// El número que una función de OpenGL deja donde dice su último parámetro: contesta(glGetIntegerv, GL_BLEND).
template<class Funcion, class... Parametros>
GLint contesta(Funcion funcion, Parametros... parametros) {
    GLint valor = 0;
    funcion(parametros..., &valor);
    return valor;
}
inline GLint entero(GLenum cual) {
    return contesta(glGetIntegerv, cual);
}
inline std::array<GLint, 4> cuatro(GLenum cual) { // GL_VIEWPORT, GL_SCISSOR_BOX
    std::array<GLint, 4> valores{};
    glGetIntegerv(cual, valores.data());
    return valores;
}
inline std::array<GLboolean, 4> mascaraDeColor() {
    std::array<GLboolean, 4> mascara{};
    glGetBooleanv(GL_COLOR_WRITEMASK, mascara.data());
    return mascara;
}
inline bool escribeColor() {
    return mascaraDeColor() != std::array<GLboolean, 4>{};
}

} // namespace explica
