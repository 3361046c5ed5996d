// El estado de OpenGL que se toca para explicar, y el framebuffer en que se dibuja.
#pragma once
#include "opengl.h"
#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace explica {

using Color = std::array<double, 4>; // de 0 a 255, o lo que haya si es de float

/// Lo que se cambia vuelve a ser lo que era al destruirse.
class Guardado {
    static constexpr GLenum INTERRUPTORES[] = {GL_SCISSOR_TEST, GL_CULL_FACE, GL_STENCIL_TEST,
                                               GL_DEPTH_TEST,   GL_BLEND,     GL_RASTERIZER_DISCARD};
    static constexpr GLenum PAQUETE[] = {GL_PACK_ALIGNMENT, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS,
                                         GL_PACK_SKIP_PIXELS};
    GLboolean activo[6], mascaraColor[4];
    GLint mascaraProfundidad, mascaraPlantilla[2], funcionProfundidad, recorte[4], programa, vao, indices,
        dibuja, lee, buferDeLeer, paquete[4], buferPaquete, textura, renderbuffer, unidad, lectura, bufer;
    GLfloat colorDeBorrar[4];
    GLdouble profundidadDeBorrar;

public:
    Guardado();
    ~Guardado();
    Guardado(const Guardado &) = delete;
    Guardado &operator=(const Guardado &) = delete;
    bool lleva(GLenum interruptor) const;
    bool escribeColor() const;
};

/// Un framebuffer, con lo que se puede leer de él.
struct Lienzo {
    GLuint nombre = 0; // 0: la ventana
    int ancho = 0, alto = 0, muestras = 0, bitsProfundidad = 0, bitsPlantilla = 0;
    GLenum buferColor = GL_NONE; // en el que se escribe el color
    GLenum formato = GL_RGBA8, componentes = GL_UNSIGNED_NORMALIZED;

    bool conColor() const {
        return buferColor != GL_NONE && componentes != GL_INT && componentes != GL_UNSIGNED_INT;
    }
    bool dentro(int x, int y) const {
        return x >= 0 && y >= 0 && x < ancho && y < alto;
    }
};

/// El framebuffer en que se dibuja, o el que se lee. Si es la ventana, mide eso.
Lienzo lienzoActual(int ancho, int alto, GLenum objetivo = GL_DRAW_FRAMEBUFFER);

/// Lo que hay en un rectángulo suyo, fila a fila desde abajo. Hay que tener un Guardado.
std::vector<float> leeColores(const Lienzo &lienzo, int x, int y, int ancho, int alto);       // RGBA
std::vector<float> leeProfundidades(const Lienzo &lienzo, int x, int y, int ancho, int alto); // de 0 a 1
std::vector<unsigned char> leePlantilla(const Lienzo &lienzo, int x, int y, int ancho, int alto);

Color leeColor(const Lienzo &lienzo, int x, int y);

/// Cuántas muestras pasan de lo que dibuja. -1 si ya se están contando otras.
long muestrasDe(const std::function<void()> &dibuja);

void pon(GLenum interruptor, bool activo);

} // namespace explica
