#include "nombres.h"
#include <cstdio>
#include <map>
#include <sstream>

namespace explica {
namespace {

using Tabla = std::map<GLenum, std::string>;

Tabla tabla(const std::string &nombres, std::initializer_list<GLenum> valores) {
    Tabla t;
    std::istringstream lista(nombres);
    for (const GLenum valor : valores)
        std::getline(lista >> std::ws, t[valor], ',');
    return t;
}

#define TABLA(...) tabla(#__VA_ARGS__, {__VA_ARGS__})
const Tabla MODOS =
    TABLA(GL_POINTS, GL_LINES, GL_LINE_LOOP, GL_LINE_STRIP, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN);
const Tabla FACTORES =
    TABLA(GL_ZERO, GL_ONE, GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA,
          GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA, GL_DST_COLOR, GL_ONE_MINUS_DST_COLOR, GL_SRC_ALPHA_SATURATE,
          GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_COLOR, GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
const Tabla CONSTANTES = TABLA(
    GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS, GL_KEEP,
    GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP, GL_FRONT, GL_BACK, GL_FRONT_AND_BACK,
    GL_CW, GL_CCW, GL_POINT, GL_LINE, GL_FILL, GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT,
    GL_MIN, GL_MAX, GL_NEAREST, GL_LINEAR, GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST,
    GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR_MIPMAP_LINEAR, GL_REPEAT, GL_MIRRORED_REPEAT, GL_CLAMP_TO_EDGE,
    GL_CLAMP_TO_BORDER, GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT,
    GL_FLOAT, GL_DOUBLE, GL_COLOR, GL_DEPTH, GL_STENCIL, GL_DEPTH_STENCIL, GL_TEXTURE_1D, GL_TEXTURE_2D,
    GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_RECTANGLE, GL_TEXTURE_BUFFER, GL_R8,
    GL_RG8, GL_RGB8, GL_RGBA8, GL_RGB, GL_RGBA, GL_R32F, GL_RGBA32F, GL_R32UI, GL_DEPTH_COMPONENT24,
    GL_DEPTH_COMPONENT, GL_DEPTH24_STENCIL8);
// clang-format off
const Tabla TIPOS =
    tabla("float, vec2, vec3, vec4, int, ivec2, ivec3, ivec4, uint, uvec2, uvec3, uvec4, bool, bvec2, bvec3, "
          "bvec4, mat2, mat3, mat4, mat2x3, mat2x4, mat3x2, mat3x4, mat4x2, mat4x3, sampler1D, sampler2D, "
          "sampler3D, samplerCube, sampler2DShadow, sampler2DRect, sampler2DArray, samplerBuffer, "
          "sampler1DArray, sampler1DShadow, sampler1DArrayShadow, sampler2DArrayShadow, sampler2DRectShadow, "
          "isampler1D, isampler2D, isampler3D, isamplerCube, isampler1DArray, isampler2DArray, isampler2DRect, "
          "isamplerBuffer, usampler1D, usampler2D, usampler3D, usamplerCube, usampler1DArray, usampler2DArray, "
          "usampler2DRect, usamplerBuffer",
          {GL_FLOAT, GL_FLOAT_VEC2, GL_FLOAT_VEC3, GL_FLOAT_VEC4, GL_INT, GL_INT_VEC2, GL_INT_VEC3,
           GL_INT_VEC4, GL_UNSIGNED_INT, GL_UNSIGNED_INT_VEC2, GL_UNSIGNED_INT_VEC3, GL_UNSIGNED_INT_VEC4,
           GL_BOOL, GL_BOOL_VEC2, GL_BOOL_VEC3, GL_BOOL_VEC4, GL_FLOAT_MAT2, GL_FLOAT_MAT3, GL_FLOAT_MAT4,
           GL_FLOAT_MAT2x3, GL_FLOAT_MAT2x4, GL_FLOAT_MAT3x2, GL_FLOAT_MAT3x4, GL_FLOAT_MAT4x2,
           GL_FLOAT_MAT4x3, GL_SAMPLER_1D, GL_SAMPLER_2D, GL_SAMPLER_3D, GL_SAMPLER_CUBE,
           GL_SAMPLER_2D_SHADOW, GL_SAMPLER_2D_RECT, GL_SAMPLER_2D_ARRAY, GL_SAMPLER_BUFFER,
           GL_SAMPLER_1D_ARRAY, GL_SAMPLER_1D_SHADOW, GL_SAMPLER_1D_ARRAY_SHADOW, GL_SAMPLER_2D_ARRAY_SHADOW,
           GL_SAMPLER_2D_RECT_SHADOW, GL_INT_SAMPLER_1D, GL_INT_SAMPLER_2D, GL_INT_SAMPLER_3D,
           GL_INT_SAMPLER_CUBE, GL_INT_SAMPLER_1D_ARRAY, GL_INT_SAMPLER_2D_ARRAY, GL_INT_SAMPLER_2D_RECT,
           GL_INT_SAMPLER_BUFFER, GL_UNSIGNED_INT_SAMPLER_1D, GL_UNSIGNED_INT_SAMPLER_2D,
           GL_UNSIGNED_INT_SAMPLER_3D, GL_UNSIGNED_INT_SAMPLER_CUBE, GL_UNSIGNED_INT_SAMPLER_1D_ARRAY,
           GL_UNSIGNED_INT_SAMPLER_2D_ARRAY, GL_UNSIGNED_INT_SAMPLER_2D_RECT,
           GL_UNSIGNED_INT_SAMPLER_BUFFER});
// clang-format on
#undef TABLA

std::string de(const Tabla &tabla, GLenum cual) {
    const auto hallado = tabla.find(cual);
    if (hallado != tabla.end())
        return hallado->second;
    char texto[16];
    std::snprintf(texto, sizeof texto, "0x%04X", cual);
    return texto;
}

} // namespace

std::string nombreDe(GLenum constante) {
    return de(CONSTANTES, constante);
}
std::string nombreModo(GLenum modo) {
    return de(MODOS, modo);
}
std::string nombreFactor(GLenum factor) {
    return de(FACTORES, factor);
}
std::string tipoDe(GLenum tipo) {
    return de(TIPOS, tipo);
}

bool esSampler(GLenum tipo) { // los que no están en la tabla lo son
    return tipoDe(tipo).find("sampler") != std::string::npos || TIPOS.count(tipo) == 0;
}

std::string nombreBuferes(GLbitfield buferes) {
    std::string texto;
    for (const auto &[bit, nombre] : {std::pair(GL_COLOR_BUFFER_BIT, "GL_COLOR_BUFFER_BIT"),
                                      {GL_DEPTH_BUFFER_BIT, "GL_DEPTH_BUFFER_BIT"},
                                      {GL_STENCIL_BUFFER_BIT, "GL_STENCIL_BUFFER_BIT"}})
        if (buferes & GLbitfield(bit))
            texto += (texto.empty() ? "" : " | ") + std::string(nombre);
    return texto.empty() ? "0" : texto;
}

} // namespace explica
