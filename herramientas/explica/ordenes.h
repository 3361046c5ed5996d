// Las órdenes que escriben píxeles: qué se ha llamado, con qué estado.
#pragma once
#include "estado.h"
#include "json.h"
#include "primitivas.h"
#include <functional>

namespace explica {

/// De lo que se dibuja de una vez, una parte: unos vértices seguidos o, si hay índices, los que dicen.
struct Tramo {
    GLint primero = 0;
    GLsizei vertices = 0;
    const void *indices = nullptr;
    GLint base = 0; // lo que se suma a cada índice
};

struct Orden {
    enum class Que { Borra, Dibuja, Copia } que;
    std::string llamada;
    std::function<void()> hazla; // la llamada de verdad
    GLbitfield buferes = 0;      // los que borra o copia
    GLenum modo = GL_POINTS;
    GLenum tipoIndice = GL_NONE; // GL_NONE: sin índices
    std::vector<Tramo> tramos = {};
    GLsizei instancias = 1;
    std::array<GLint, 4> origen{}, destino{}; // de una copia: x0, y0, x1, y1

    GLsizei vertices() const;
};

Orden ordenBorra(GLbitfield buferes);
Orden ordenDibuja(GLenum modo, GLint primero, GLsizei vertices);
Orden ordenDibuja(GLenum modo, GLsizei vertices, GLenum tipoIndice, const void *indices);

/// Las demás que escriben píxeles, por su nombre: una función que se llama igual y da su orden a `llega`, o nulo.
Direccion tapaOrden(const std::string &nombre, void (*llega)(const Orden &orden));

/// Las primitivas que dibuja, sueltas; ninguna si no dibuja o no se pueden saber.
std::optional<Primitivas> primitivasDe(const Orden &orden);

/// `llamada`, `titulo`, `pruebas` (lo que la distingue, en pocas palabras), `estado`, `programa` y `framebuffer`.
Json describe(const Orden &orden, const Lienzo &lienzo);

} // namespace explica
