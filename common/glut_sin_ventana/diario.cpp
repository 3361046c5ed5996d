// La opción -diario: tras cada orden, lo que ha quedado en la ventana y en OpenGL, para ver lo que todo programa
// cumple.
#include "../captura.h"
#include "../error.h"
#include "../imagen.h"
#include "interior.h"
#include <GL/glew.h>
#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstdint>
#include <cstdio>

namespace sin_ventana {
namespace {

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

using Estado = std::array<std::array<GLfloat, 4>, std::size(PARAMETROS)>;

Estado estadoActual() {
    Estado estado{};
    for (std::size_t i = 0; i < estado.size(); ++i)
        glGetFloatv(PARAMETROS[i].cual, estado[i].data());
    return estado;
}

std::string diferencia(const Estado &antes, const Estado &despues) {
    std::string texto;
    for (std::size_t i = 0; i < antes.size(); ++i)
        for (int k = 0; k < PARAMETROS[i].valores; ++k)
            if (antes[i][k] != despues[i][k])
                texto += std::string(PARAMETROS[i].nombre) + " " + std::to_string(int(antes[i][k])) + "→" +
                         std::to_string(int(despues[i][k])) + " ";
    return texto;
}

// FNV-1a de 64 bits: la misma imagen, el mismo número.
std::uint64_t resumen() {
    std::uint64_t h = 14695981039346656037u;
    for (const unsigned char c : leeVentana().rgb)
        h = (h ^ c) * 1099511628211u;
    return h;
}

bool seEscribe = false;
std::string cambiado; // lo que los cuadros, desde la última línea, no han dejado como estaba

} // namespace

void empiezaDiario() {
    seEscribe = true;
    glewExperimental = GL_TRUE;
    glewInit(); // el programa puede no haberlo necesitado
}

void dibujaParaElDiario(void (*dibuja)()) {
    if (!seEscribe)
        return dibuja();
    const Estado antes = estadoActual();
    dibuja();
    cambiado += diferencia(antes, estadoActual());
}

void apuntaEnElDiario(const std::string &orden, const std::string &titulo, std::size_t temporizadores) {
    if (!seEscribe)
        return;
    const std::uint64_t imagen = resumen();
    dibujaCuadro();
    compruebaGL("al repetir el cuadro");
    const bool repetida = resumen() == imagen;
    const Ocupado o = ocupado();
    std::printf("diario\t%s\t%016" PRIx64 "\t%s\t%s\t%s\t%d %d %d %d %d %d %d\t%lld\t%zu\n", orden.c_str(),
                imagen, repetida ? "" : "otra", titulo.c_str(), cambiado.c_str(), o.buferes, o.texturas,
                o.programas, o.shaders, o.framebuffers, o.renderbuffers, o.vaos,
                o.bytesBuferes + o.bytesTexturas, temporizadores);
    std::fflush(stdout);
    cambiado.clear();
}

} // namespace sin_ventana
