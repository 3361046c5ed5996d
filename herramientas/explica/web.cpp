// La entrada de la página: las funciones de OpenGL que llaman los programas y que hay que oír, que mientras no se
// explica hacen lo de siempre, y lo que pide cuadro_vivo.mjs.
#include "cuadro.h"
#include "glut_sin_ventana.h"
#include <emscripten.h>

DECLARA(glClear)
DECLARA(glDrawArrays)
DECLARA(glDrawElements)

namespace explica {

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
TAPA(void, glUseProgram, (GLuint programa), programa)
// De las que dan valor a un uniform, las que llama algún programa.
TAPA(void, glUniform1f, (GLint donde, GLfloat v), donde, v)
TAPA(void, glUniform1i, (GLint donde, GLint v), donde, v)
TAPA(void, glUniform1fv, (GLint donde, GLsizei n, const GLfloat *v), donde, n, v)
TAPA(void, glUniform2fv, (GLint donde, GLsizei n, const GLfloat *v), donde, n, v)
TAPA(void, glUniform3fv, (GLint donde, GLsizei n, const GLfloat *v), donde, n, v)
TAPA(void, glUniform4fv, (GLint donde, GLsizei n, const GLfloat *v), donde, n, v)
TAPA(void, glUniformMatrix3fv, (GLint donde, GLsizei n, GLboolean t, const GLfloat *v), donde, n, t, v)
TAPA(void, glUniformMatrix4fv, (GLint donde, GLsizei n, GLboolean t, const GLfloat *v), donde, n, t, v)

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
