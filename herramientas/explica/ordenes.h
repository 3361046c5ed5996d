// Las órdenes que escriben píxeles: qué se ha llamado, con qué estado.
#pragma once
#include "estado.h"
#include "json.h"
#include "primitivas.h"
#include <functional>

namespace explica {

struct Orden {
    enum class Que { Borra, Dibuja, Copia } que;
    std::function<void()> hazla; // la llamada de verdad
    GLbitfield buferes = 0;      // los que borra o copia
    GLenum modo = GL_POINTS;
    GLint primero = 0;
    GLsizei vertices = 0;
    GLenum tipoIndice = GL_NONE; // GL_NONE: glDrawArrays
    const void *indices = nullptr;
    std::array<GLint, 4> origen{}, destino{}; // de una copia: x0, y0, x1, y1
    GLenum filtro = GL_NEAREST;
};

Orden ordenBorra(GLbitfield buferes);
Orden ordenDibuja(GLenum modo, GLint primero, GLsizei vertices);
Orden ordenDibuja(GLenum modo, GLsizei vertices, GLenum tipoIndice, const void *indices);
Orden ordenCopia(const std::array<GLint, 4> &origen, const std::array<GLint, 4> &destino, GLbitfield buferes,
                 GLenum filtro);

/// Las primitivas que dibuja, sueltas; ninguna si no dibuja o no se pueden saber.
std::optional<Primitivas> primitivasDe(const Orden &orden);

/// `llamada`, `titulo`, `pruebas` (lo que la distingue, en pocas palabras), `estado`, `programa` y `framebuffer`.
Json describe(const Orden &orden, const Lienzo &lienzo);

} // namespace explica
