// El estado de OpenGL que se toca para explicar, y el framebuffer en que se dibuja.
#pragma once
#include "opengl.h"
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace explica {

using Color = std::array<double, 4>; // de 0 a 255, o lo que haya si es de float
using Pixel = std::array<float, 4>;
const Pixel NINGUNO = {-12345, 0, 0, -1}; // el color que no da ningún shader

/// Lo que se cambia vuelve a ser lo que era al destruirse.
class Guardado {
    static constexpr GLenum INTERRUPTORES[] = {GL_SCISSOR_TEST, GL_CULL_FACE, GL_STENCIL_TEST,
                                               GL_DEPTH_TEST,   GL_BLEND,     GL_RASTERIZER_DISCARD};
    GLboolean activo[6];
    std::vector<std::function<void()>> repone;

public:
    Guardado();
    ~Guardado();
    Guardado(const Guardado &) = delete;
    Guardado &operator=(const Guardado &) = delete;
    bool lleva(GLenum interruptor) const;
};

/// Un framebuffer, con lo que se puede leer de él.
struct Lienzo {
    GLuint nombre = 0;  // 0: la ventana
    GLuint textura = 0; // la de su color, si lo que se ve de ella es todo ese framebuffer
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

// --- lo que WebGL 2 no dice, o dice tarde: lee.cpp y, en la página, lee_web.cpp ---

/// Cuántas muestras pasan de lo que dibuja, que no tiene que escribir nada; en la página, si pasa alguna. -1 si ya se
/// están contando otras. Hay que tener un Guardado.
long muestrasDe(const std::function<void()> &dibuja);

/// Dibuja y dice lo mismo, de lo que sí escribe. En la página, -1 si ha pasado alguna: es lo que se ha preguntado antes
/// de la orden de ese número.
void preguntaSiDibuja(const std::function<void()> &dibuja, int numero);
long dibujaYCuenta(const std::function<void()> &dibuja, int numero);
bool hayRespuestas(); // si se puede saber ya

/// Pone donde se dibuja un framebuffer en float, de esa talla y con profundidad de los mismos bits, que de ellos
/// depende glPolygonOffset; y lo que hay en él. Hay que tener un Guardado.
void abreAparte(const Lienzo &lienzo);

/// Lo que da el shader en un rectángulo de ese framebuffer, sin mezclar ni acotar; NINGUNO donde no dibuja nada.
std::vector<Pixel> coloresAparte(int x, int y, int ancho, int alto, const std::function<void()> &dibuja);
float profundidadAparte(int x, int y);

int bitsDe(GLenum objetivo, GLenum adjunto, GLenum cual);
void bitsDeLaVentana(GLenum objetivo, Lienzo &lienzo);
void leePixeles(const Lienzo &lienzo, int x, int y, int ancho, int alto, float *rgba);

/// GL_STENCIL_REF.
GLint pideLaPlantilla();

void pon(GLenum interruptor, bool activo);

} // namespace explica
