// Lo que mira la opción -diario del estado de OpenGL.
#pragma once
#include <GL/glew.h>

namespace sin_ventana {

struct Parametro {
    const char *nombre;
    GLenum cual;
    int valores;
};

#define GL(nombre, valores)                                                                                  \
    { #nombre, GL_##nombre, valores }
// Lo que un cuadro no puede dejar de otra manera sin que lo sufra el siguiente, o un rótulo. No el viewport, que pone
// abreRecuadro, ni las funciones de mezcla, que no hacen nada sin ella. Casi todo vale 0 o 1.
const Parametro PARAMETROS[] = {
    GL(BLEND, 1),
    GL(BLEND_EQUATION_RGB, 1),
    GL(COLOR_LOGIC_OP, 1),
    GL(COLOR_WRITEMASK, 4),
    GL(DEPTH_TEST, 1),
    GL(DEPTH_FUNC, 1),
    GL(DEPTH_WRITEMASK, 1),
    GL(DEPTH_RANGE, 2),
    GL(STENCIL_TEST, 1),
    GL(STENCIL_WRITEMASK, 1),
    GL(STENCIL_BACK_WRITEMASK, 1),
    GL(CULL_FACE, 1),
    GL(CULL_FACE_MODE, 1),
    GL(FRONT_FACE, 1),
    GL(POLYGON_MODE, 2),
    GL(POLYGON_OFFSET_FILL, 1),
    GL(POLYGON_OFFSET_LINE, 1),
    GL(SCISSOR_TEST, 1),
    GL(CLIP_DISTANCE0, 1),
    GL(PROGRAM_POINT_SIZE, 1),
    GL(PRIMITIVE_RESTART, 1),
    GL(MULTISAMPLE, 1),
    GL(SAMPLE_ALPHA_TO_COVERAGE, 1),
    GL(RASTERIZER_DISCARD, 1),
    GL(DRAW_FRAMEBUFFER_BINDING, 1),
    GL(READ_FRAMEBUFFER_BINDING, 1),
    GL(DRAW_BUFFER, 1),
    GL(READ_BUFFER, 1),
    GL(ACTIVE_TEXTURE, 1),
    GL(PIXEL_PACK_BUFFER_BINDING, 1),
    GL(PIXEL_UNPACK_BUFFER_BINDING, 1),
    GL(PACK_ALIGNMENT, 1),
    GL(PACK_ROW_LENGTH, 1),
    GL(UNPACK_ALIGNMENT, 1),
    GL(UNPACK_ROW_LENGTH, 1),
};
#undef GL

} // namespace sin_ventana
