// rarezas SEMILLA: lo que OpenGL deja hacer y ningún programa del laboratorio hace, al azar: cada primitiva, con
// cortes, dibujada y borrada con cada función que hay para ello, cada test y cada mezcla, con parte de los colores, en
// la ventana o en un framebuffer del que se copia con otra escala y del revés, y que también se pinta sin dibujar. Sus
// shaders apuntan si es igual lo que se usa y lo que el enlazador quita, que vale lo mismo. Lo que ./lab explica dice
// de ello lo mira propiedades/explica.py.
#include "shader.h"
#include "ventana.h"
#include <cstdlib>
#include <random>
#include <vector>

static const GLuint CORTE = 0xffffffff, GEMELO = 6; // un atributo que da lo mismo que el color
static const int ORDENES = 14, LADO = 60;           // el framebuffer es cuadrado
static const GLenum MODOS[] = {GL_POINTS,    GL_LINES,          GL_LINE_STRIP,   GL_LINE_LOOP,
                               GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_TRIANGLE_STRIP};
static const GLenum FACTORES[] = {GL_ZERO,           GL_ONE,
                                  GL_SRC_COLOR,      GL_ONE_MINUS_SRC_COLOR,
                                  GL_DST_COLOR,      GL_ONE_MINUS_DST_COLOR,
                                  GL_SRC_ALPHA,      GL_ONE_MINUS_SRC_ALPHA,
                                  GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_COLOR};
static const GLenum ECUACIONES[] = {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX};
static const GLenum COMPARA[] = {GL_NEVER,   GL_LESS,     GL_EQUAL,  GL_LEQUAL,
                                 GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};
static const GLenum PLANTILLA[] = {GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR_WRAP, GL_INVERT};

static std::mt19937 azar;
static unsigned semilla;
static GLuint programa, aparte, textura, array, vertices, indices;
static GLint copia; // de opacidad, que nada usa: OpenGL dice que no está

static int n(int cuantos) {
    return int(azar() % unsigned(cuantos));
}

template<std::size_t N>
static GLenum una(const GLenum (&de)[N]) {
    return de[n(int(N))];
}

static float entre(float a, float b) {
    return a + (b - a) * float(n(10001)) / 10000;
}

static void enciende(GLenum que, bool si) {
    si ? glEnable(que) : glDisable(que);
}

static void estadoAlAzar() {
    const bool alguno = n(5) > 0;
    glColorMask(alguno && n(4), alguno && n(4), alguno && n(4), alguno);
    enciende(GL_BLEND, n(2));
    glBlendFunc(una(FACTORES), una(FACTORES));
    glBlendEquation(una(ECUACIONES));
    glBlendColor(entre(0, 1), entre(0, 1), entre(0, 1), 1);
    enciende(GL_DEPTH_TEST, n(2));
    glDepthFunc(una(COMPARA));
    glDepthMask(n(3) > 0);
    enciende(GL_STENCIL_TEST, n(4) == 0);
    glStencilFunc(una(COMPARA), n(4), 0xff);
    glStencilOp(una(PLANTILLA), una(PLANTILLA), una(PLANTILLA));
    enciende(GL_CULL_FACE, n(3) == 0);
    glCullFace(n(2) ? GL_FRONT : GL_BACK);
    glFrontFace(n(2) ? GL_CW : GL_CCW);
    enciende(GL_PRIMITIVE_RESTART, n(3) > 0);
    enciende(GL_SCISSOR_TEST, n(5) == 0);
    glScissor(n(30), n(30), 20 + n(60), 20 + n(60));
}

// Con una de las funciones que hay, esos índices o los vértices por su orden.
static void dibujaAlAzar(GLenum modo, GLsizei cuantos) {
    const auto desde = [](GLsizei indice) { return reinterpret_cast<const void *>(sizeof(GLuint) * indice); };
    const GLint primeros[] = {n(6), n(6)}, bases[] = {1, 0};
    const GLsizei trozos[] = {3 + n(5), 3 + n(5)}, veces = 1 + n(3);
    const void *const partes[] = {desde(n(7)), desde(n(7))};
    switch (n(11)) {
    case 0: return glDrawArrays(modo, primeros[0], trozos[0]);
    case 1: return glDrawArraysInstanced(modo, primeros[0], trozos[0], veces);
    case 2: return glDrawElementsInstanced(modo, cuantos, GL_UNSIGNED_INT, desde(0), veces);
    case 3: return glDrawRangeElements(modo, 0, 11, cuantos, GL_UNSIGNED_INT, desde(0));
    case 4: return glMultiDrawArrays(modo, primeros, trozos, 2);
    case 5: return glMultiDrawElements(modo, trozos, GL_UNSIGNED_INT, partes, 2);
    case 6: return glDrawElementsBaseVertex(modo, cuantos - 2, GL_UNSIGNED_INT, desde(2), 1);
    case 7: return glDrawRangeElementsBaseVertex(modo, 0, 11, trozos[0], GL_UNSIGNED_INT, partes[0], 1);
    case 8: return glDrawElementsInstancedBaseVertex(modo, cuantos, GL_UNSIGNED_INT, desde(0), veces, 1);
    case 9: return glMultiDrawElementsBaseVertex(modo, trozos, GL_UNSIGNED_INT, partes, 2, bases);
    default: return glDrawElements(modo, cuantos, GL_UNSIGNED_INT, desde(0));
    }
}

static void borraAlAzar() {
    const GLfloat color[] = {entre(0, 1), entre(0, 1), entre(0, 1), 1}, lejos = entre(0, 1);
    const GLint plantilla = n(4);
    switch (n(4)) {
    case 0: return glClearBufferfv(GL_COLOR, 0, color);
    case 1: return glClearBufferfv(GL_DEPTH, 0, &lejos);
    case 2: return glClearBufferiv(GL_STENCIL, 0, &plantilla);
    default: return glClearBufferfi(GL_DEPTH_STENCIL, 0, lejos, plantilla);
    }
}

static void pintaAlAzar() {
    std::vector<float> datos;
    for (int i = 0; i < 13; ++i)
        for (const float limite : {1.2f, 1.2f, 1.0f, 0.0f, 0.0f, 0.0f})
            datos.push_back(limite != 0 ? entre(-limite, limite) : entre(0, 1));
    std::vector<GLuint> cuales;
    for (int i = 0; i < 14; ++i)
        cuales.push_back(glIsEnabled(GL_PRIMITIVE_RESTART) && n(5) == 0 ? CORTE : GLuint(n(12)));
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(datos.size() * sizeof(float)), datos.data(), GL_STREAM_DRAW);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(cuales.size() * sizeof(GLuint)), cuales.data(),
                 GL_STREAM_DRAW);
    const float opacidad = entre(0, 1);
    glUniform1f(glGetUniformLocation(programa, "opacidad"), opacidad);
    glUniform1f(copia, opacidad);
    dibujaAlAzar(una(MODOS), GLsizei(cuales.size()));
}

// Con otra talla y, a veces, del revés. Sin que el centro de un píxel caiga entre dos: sería de cualquiera.
static void copiaAlAzar() {
    const int ancho = glutGet(GLUT_WINDOW_WIDTH), alto = glutGet(GLUT_WINDOW_HEIGHT), x = n(ancho / 2),
              y = n(alto / 2);
    const int x1 = x + 4 * (2 + n(ancho / 8)), y1 = y + 4 * (2 + n(alto / 8));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, aparte);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glDisable(GL_SCISSOR_TEST);
    n(3) ? glBlitFramebuffer(0, 0, LADO, LADO, x, y, x1, y1, GL_COLOR_BUFFER_BIT, GL_NEAREST)
         : glBlitFramebuffer(5, 0, LADO, LADO - 9, x1, y, x, y1, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

static void dibuja() {
    azar.seed(semilla);
    glUseProgram(programa);
    for (const GLuint lienzo : {aparte, 0u}) {
        glBindFramebuffer(GL_FRAMEBUFFER, lienzo);
        glDisable(GL_SCISSOR_TEST);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glDepthMask(GL_TRUE);
        glClearColor(entre(0, 1), entre(0, 1), entre(0, 1), 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }
    for (int i = 0; i < ORDENES; ++i) {
        if (i == ORDENES / 2) {
            copiaAlAzar();
            continue;
        }
        const bool enVentana = n(2);
        glBindFramebuffer(GL_FRAMEBUFFER, enVentana ? 0 : aparte);
        glViewport(0, 0, enVentana ? glutGet(GLUT_WINDOW_WIDTH) : LADO,
                   enVentana ? glutGet(GLUT_WINDOW_HEIGHT) : LADO);
        estadoAlAzar();
        n(6) ? pintaAlAzar() : borraAlAzar();
        if (enVentana)
            continue;
        const std::vector<GLubyte> gris(4 * LADO * LADO, GLubyte(n(256)));
        glTexSubImage2D(GL_TEXTURE_2D, 0, n(LADO / 2), n(LADO / 2), LADO / 2, LADO / 2, GL_RGBA,
                        GL_UNSIGNED_BYTE, gris.data());
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glutSwapBuffers();
}

static void creaAparte() {
    GLuint parte;
    glGenTextures(1, &textura);
    glBindTexture(GL_TEXTURE_2D, textura);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, LADO, LADO, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glGenRenderbuffers(1, &parte);
    glBindRenderbuffer(GL_RENDERBUFFER, parte);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, LADO, LADO);
    glGenFramebuffers(1, &aparte);
    glBindFramebuffer(GL_FRAMEBUFFER, aparte);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textura, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, parte);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Rarezas", GLUT_DOUBLE | GLUT_DEPTH | GLUT_STENCIL, "[SEMILLA]");
    semilla = unsigned(std::atoi(argc > 1 ? argv[1] : "1"));
    programa = creaPrograma("tests/explica/rarezas.vert", "tests/explica/rarezas.frag");
    glBindAttribLocation(programa, GEMELO, "gemelo");
    glLinkProgram(programa);
    copia = glGetUniformLocation(programa, "copia");
    creaAparte();
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(1, &vertices);
    glGenBuffers(1, &indices);
    glBindBuffer(GL_ARRAY_BUFFER, vertices);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
    for (const GLuint atributo : {GLuint(ATRIBUTO_POSICION), GLuint(ATRIBUTO_COLOR), GEMELO}) {
        glEnableVertexAttribArray(atributo);
        glVertexAttribPointer(atributo, 3, GL_FLOAT, GL_FALSE, 24,
                              reinterpret_cast<void *>(atributo == ATRIBUTO_POSICION ? 0L : 12L));
    }
    glPrimitiveRestartIndex(CORTE);
    glEnable(GL_PROGRAM_POINT_SIZE);
    glutDisplayFunc(dibuja);
    glutMainLoop();
    return 0;
}
