// OpenGL, para quien se pone delante de él: las tres funciones que se tapan, como son de verdad.
#pragma once
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

namespace explica {

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
