// La entrada de la página: las funciones de OpenGL que llaman los programas y que hay que oír, que mientras no se
// explica hacen lo de siempre, y lo que pide cuadro_vivo.mjs.
#include "cuadro.h"
#include "glut_sin_ventana.h"
#include "pila.h"
#include <emscripten.h>

DECLARA(glClear)
DECLARA(glDrawArrays)
DECLARA(glDrawElements)

namespace explica {

int pilaActual() {
    return -1; // aquí no hay cómo saber en qué línea del fuente está una llamada
}
std::vector<Json> pilasEnJson() {
    return {};
}

const DeVerdad &deVerdad() {
    static const DeVerdad funciones = {emscripten_glClear, emscripten_glDrawArrays,
                                       emscripten_glDrawElements};
    return funciones;
}

} // namespace explica

using namespace explica;

extern "C" {

void glClear(GLbitfield buferes) {
    if (!seExplica() || esNuestro())
        return emscripten_glClear(buferes);
    llega(ordenBorra(buferes));
}

void glDrawArrays(GLenum modo, GLint primero, GLsizei vertices) {
    if (!seExplica() || esNuestro())
        return emscripten_glDrawArrays(modo, primero, vertices);
    llega(ordenDibuja(modo, primero, vertices));
}

void glDrawElements(GLenum modo, GLsizei vertices, GLenum tipo, const void *indices) {
    if (!seExplica() || esNuestro())
        return emscripten_glDrawElements(modo, vertices, tipo, indices);
    llega(ordenDibuja(modo, vertices, tipo, indices));
}

#define TAPA(devuelve, funcion, parametros, ...)                                                             \
    devuelve funcion parametros {                                                                            \
        static const auto suya = reinterpret_cast<devuelve(*) parametros>(tapa(#funcion));                   \
        return suya(__VA_ARGS__);                                                                            \
    }
TAPA(void, glBlitFramebuffer,
     (GLint x0, GLint y0, GLint x1, GLint y1, GLint u0, GLint v0, GLint u1, GLint v1, GLbitfield b, GLenum f),
     x0, y0, x1, y1, u0, v0, u1, v1, b, f)
TAPA(GLint, glGetUniformLocation, (GLuint programa, const GLchar *nombre), programa, nombre)
TAPA(void, glBindAttribLocation, (GLuint programa, GLuint donde, const GLchar *nombre), programa, donde,
     nombre)
TAPA(void, glLinkProgram, (GLuint programa), programa)
TAPA(GLuint, glCreateProgram, (void), )
// Las que dan valor a un uniform: de un número, de varios y de una matriz.
#define VECTOR(forma, Numero)                                                                                \
    TAPA(void, glUniform##forma, (GLint donde, GLsizei n, const Numero *v), donde, n, v)
#define NUMEROS(letra, Numero)                                                                               \
    TAPA(void, glUniform1##letra, (GLint donde, Numero x), donde, x)                                         \
    TAPA(void, glUniform2##letra, (GLint donde, Numero x, Numero y), donde, x, y)                            \
    TAPA(void, glUniform3##letra, (GLint donde, Numero x, Numero y, Numero z), donde, x, y, z)               \
    TAPA(void, glUniform4##letra, (GLint donde, Numero x, Numero y, Numero z, Numero w), donde, x, y, z, w)  \
    VECTOR(1##letra##v, Numero)                                                                              \
    VECTOR(2##letra##v, Numero)                                                                              \
    VECTOR(3##letra##v, Numero)                                                                              \
    VECTOR(4##letra##v, Numero)
#define MATRIZ(forma)                                                                                        \
    TAPA(void, glUniformMatrix##forma##fv, (GLint donde, GLsizei n, GLboolean t, const GLfloat *v), donde,   \
         n, t, v)
NUMEROS(f, GLfloat)
NUMEROS(i, GLint)
NUMEROS(ui, GLuint)
MATRIZ(2)
MATRIZ(3)
MATRIZ(4)
MATRIZ(2x3)
MATRIZ(3x2)
MATRIZ(2x4)
MATRIZ(4x2)
MATRIZ(3x4)
MATRIZ(4x3)

/// Antes de explicar; cuando explicaResponde sea verdad se puede seguir.
EMSCRIPTEN_KEEPALIVE void explicaPregunta(void) {
    pregunta(glutRedibuja);
}

EMSCRIPTEN_KEEPALIVE bool explicaResponde(void) {
    return hayRespuestas();
}

/// El cuadro que se ve y, si x no es negativa, ese píxel, en JSON.
EMSCRIPTEN_KEEPALIVE const char *explicaCuadroVivo(int ancho, int alto, int x, int y) {
    static std::string json;
    Pedido que{true, false};
    if (x >= 0)
        que.pixeles = {{x, y}};
    json = explica::explica(glutRedibuja, ancho, alto, que);
    glutRedibuja();
    while (glGetError()) { // ninguno es del programa
    }
    return json.c_str();
}

} // extern "C"
