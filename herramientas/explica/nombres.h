// Cómo se llaman en el programa las constantes de OpenGL.
#pragma once
#include "opengl.h"
#include <string>

namespace explica {

/// «GL_LESS», «GL_COLOR_ATTACHMENT0», «0x1234» si no se conoce. De un tipo de GLSL, su nombre: «vec3».
std::string nombreDe(GLenum constante);
std::string nombreModo(GLenum modo);     // GL_TRIANGLES…
std::string nombreFactor(GLenum factor); // GL_ZERO, GL_SRC_ALPHA…
std::string tipoDe(GLenum tipo);         // vec3, sampler2D…
bool esSampler(GLenum tipo);

/// «GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT».
std::string nombreBuferes(GLbitfield buferes);

} // namespace explica
