// La opción -diario: tras cada orden, lo que ha quedado en la ventana y en OpenGL, para ver lo que todo programa
// cumple.
#include "captura.h"
#include "error.h"
#include "imagen.h"
#include "interior.h"
#include "parametros.h"
#include <GL/glew.h>
#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstdint>
#include <cstdio>

namespace sin_ventana {
namespace {

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
