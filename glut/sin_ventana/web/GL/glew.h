// El GLEW del enlace web: no hay nada que buscar, las funciones son las de WebGL 2 y las de gl_web.cpp.
#pragma once
#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#endif
#include <GL/gl.h>
#include <GL/glext.h>

extern "C" {
extern GLboolean glewExperimental;
GLenum glewInit(void);
const GLubyte *glewGetString(GLenum nombre);
extern GLboolean labHayGL31, labHayAnisotropia; // las pone glewInit
}

#define GLEW_OK 0
#define GLEW_VERSION 1
#define GLEW_VERSION_3_1 labHayGL31
#define GLEW_EXT_texture_filter_anisotropic labHayAnisotropia
#define GLEW_ARB_seamless_cube_map GL_TRUE // siempre filtra entre caras vecinas
