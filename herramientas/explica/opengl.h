// OpenGL, para quien se pone delante de él: las funciones que se tapan, como son de verdad.
#pragma once
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

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

inline GLint entero(GLenum cual) {
    GLint valor = 0;
    glGetIntegerv(cual, &valor);
    return valor;
}

} // namespace explica
