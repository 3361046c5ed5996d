#include "nombres.h"
#include <cstdio>
#include <map>

namespace explica {
namespace {

using Tabla = std::map<GLenum, const char *>;

#define N(nombre)                                                                                            \
    { nombre, #nombre }
const Tabla MODOS = {N(GL_POINTS),    N(GL_LINES),          N(GL_LINE_LOOP),   N(GL_LINE_STRIP),
                     N(GL_TRIANGLES), N(GL_TRIANGLE_STRIP), N(GL_TRIANGLE_FAN)};
const Tabla FACTORES = {N(GL_ZERO),
                        N(GL_ONE),
                        N(GL_SRC_COLOR),
                        N(GL_ONE_MINUS_SRC_COLOR),
                        N(GL_SRC_ALPHA),
                        N(GL_ONE_MINUS_SRC_ALPHA),
                        N(GL_DST_ALPHA),
                        N(GL_ONE_MINUS_DST_ALPHA),
                        N(GL_DST_COLOR),
                        N(GL_ONE_MINUS_DST_COLOR),
                        N(GL_SRC_ALPHA_SATURATE),
                        N(GL_CONSTANT_COLOR),
                        N(GL_ONE_MINUS_CONSTANT_COLOR),
                        N(GL_CONSTANT_ALPHA),
                        N(GL_ONE_MINUS_CONSTANT_ALPHA)};
const Tabla CONSTANTES = {N(GL_NEVER),
                          N(GL_LESS),
                          N(GL_EQUAL),
                          N(GL_LEQUAL),
                          N(GL_GREATER),
                          N(GL_NOTEQUAL),
                          N(GL_GEQUAL),
                          N(GL_ALWAYS),
                          N(GL_KEEP),
                          N(GL_REPLACE),
                          N(GL_INCR),
                          N(GL_DECR),
                          N(GL_INVERT),
                          N(GL_INCR_WRAP),
                          N(GL_DECR_WRAP),
                          N(GL_FRONT),
                          N(GL_BACK),
                          N(GL_FRONT_AND_BACK),
                          N(GL_CW),
                          N(GL_CCW),
                          N(GL_POINT),
                          N(GL_LINE),
                          N(GL_FILL),
                          N(GL_FUNC_ADD),
                          N(GL_FUNC_SUBTRACT),
                          N(GL_FUNC_REVERSE_SUBTRACT),
                          N(GL_MIN),
                          N(GL_MAX),
                          N(GL_NEAREST),
                          N(GL_LINEAR),
                          N(GL_NEAREST_MIPMAP_NEAREST),
                          N(GL_LINEAR_MIPMAP_NEAREST),
                          N(GL_NEAREST_MIPMAP_LINEAR),
                          N(GL_LINEAR_MIPMAP_LINEAR),
                          N(GL_REPEAT),
                          N(GL_MIRRORED_REPEAT),
                          N(GL_CLAMP_TO_EDGE),
                          N(GL_CLAMP_TO_BORDER),
                          N(GL_BYTE),
                          N(GL_UNSIGNED_BYTE),
                          N(GL_SHORT),
                          N(GL_UNSIGNED_SHORT),
                          N(GL_INT),
                          N(GL_UNSIGNED_INT),
                          N(GL_FLOAT),
                          N(GL_DOUBLE),
                          N(GL_COLOR),
                          N(GL_DEPTH),
                          N(GL_STENCIL),
                          N(GL_DEPTH_STENCIL),
                          N(GL_TEXTURE_1D),
                          N(GL_TEXTURE_2D),
                          N(GL_TEXTURE_3D),
                          N(GL_TEXTURE_CUBE_MAP),
                          N(GL_R8),
                          N(GL_RG8),
                          N(GL_RGB8),
                          N(GL_RGBA8),
                          N(GL_RGB),
                          N(GL_RGBA),
                          N(GL_R32F),
                          N(GL_RGBA32F),
                          N(GL_R32UI),
                          N(GL_DEPTH_COMPONENT24),
                          N(GL_DEPTH_COMPONENT),
                          N(GL_DEPTH24_STENCIL8)};
const Tabla TIPOS = {
    {GL_FLOAT, "float"},
    {GL_FLOAT_VEC2, "vec2"},
    {GL_FLOAT_VEC3, "vec3"},
    {GL_FLOAT_VEC4, "vec4"},
    {GL_INT, "int"},
    {GL_INT_VEC2, "ivec2"},
    {GL_INT_VEC3, "ivec3"},
    {GL_INT_VEC4, "ivec4"},
    {GL_UNSIGNED_INT, "uint"},
    {GL_UNSIGNED_INT_VEC2, "uvec2"},
    {GL_UNSIGNED_INT_VEC3, "uvec3"},
    {GL_UNSIGNED_INT_VEC4, "uvec4"},
    {GL_BOOL, "bool"},
    {GL_BOOL_VEC2, "bvec2"},
    {GL_BOOL_VEC3, "bvec3"},
    {GL_BOOL_VEC4, "bvec4"},
    {GL_FLOAT_MAT2, "mat2"},
    {GL_FLOAT_MAT3, "mat3"},
    {GL_FLOAT_MAT4, "mat4"},
    {GL_FLOAT_MAT2x3, "mat2x3"},
    {GL_FLOAT_MAT2x4, "mat2x4"},
    {GL_FLOAT_MAT3x2, "mat3x2"},
    {GL_FLOAT_MAT3x4, "mat3x4"},
    {GL_FLOAT_MAT4x2, "mat4x2"},
    {GL_FLOAT_MAT4x3, "mat4x3"},
    {GL_SAMPLER_1D, "sampler1D"},
    {GL_SAMPLER_2D, "sampler2D"},
    {GL_SAMPLER_3D, "sampler3D"},
    {GL_SAMPLER_CUBE, "samplerCube"},
    {GL_SAMPLER_2D_SHADOW, "sampler2DShadow"},
    {GL_SAMPLER_2D_RECT, "sampler2DRect"},
    {GL_UNSIGNED_INT_SAMPLER_2D, "usampler2D"},
};
#undef N

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
    const Tabla bits = {{GL_COLOR_BUFFER_BIT, "GL_COLOR_BUFFER_BIT"},
                        {GL_DEPTH_BUFFER_BIT, "GL_DEPTH_BUFFER_BIT"},
                        {GL_STENCIL_BUFFER_BIT, "GL_STENCIL_BUFFER_BIT"}};
    for (const GLenum bit : {GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT, GL_STENCIL_BUFFER_BIT})
        if (buferes & bit)
            texto += (texto.empty() ? "" : " | ") + std::string(bits.at(bit));
    return texto.empty() ? "0" : texto;
}

} // namespace explica
