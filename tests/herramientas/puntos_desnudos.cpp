// Lo que cuesta un cuadro de particulas frente a dibujar los mismos puntos sin calcular nada: los mismos lugares, tamaños y
// colores, leídos de un buffer object con un vertex shader que solo los copia, y el mismo fragment shader y mezcla. No es una
// prueba: mide. Es el propio programa, con esto en vez de su bucle: build/tests/puntos_desnudos -geometry 960x720
#include "ventana.h"
#define glutMainLoop comparaConDesnudos
static void comparaConDesnudos();
#include "ch12_animacion/particulas.cpp"
#undef glutMainLoop
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>

static const char *const COPIA = R"(#version 140
in vec4 lugar, tinte;
in float diametro;
out vec4 color;
void main() {
    color = tinte;
    gl_Position = lugar;
    gl_PointSize = diametro;
})";

static double milisegundos(const std::function<void()> &f) {
    const auto antes = std::chrono::steady_clock::now();
    f();
    glFinish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - antes).count();
}

static double mediana(std::vector<double> v) {
    std::sort(v.begin(), v.end());
    return v[v.size() / 2];
}

static void compila(GLuint programa, GLenum tipo, const std::string &texto) {
    const GLuint shader = glCreateShader(tipo);
    const char *const fuente = texto.c_str();
    glShaderSource(shader, 1, &fuente, nullptr);
    glCompileShader(shader);
    glAttachShader(programa, shader);
}

/// Los puntos del cuadro que toca, tal como los deja el vertex shader del programa: 9 floats cada uno.
static void capturaPuntos() {
    const char *const salidas[] = {"gl_Position", "gl_PointSize", "color"};
    glTransformFeedbackVaryings(estado.programa, 3, salidas, GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(estado.programa);
    dibuja(); // da valor a los uniform
    glUseProgram(estado.programa);
    glBindVertexArray(estado.vao);
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, estado.cuantas);
    glEndTransformFeedback();
    glDisable(GL_RASTERIZER_DISCARD);
    glTransformFeedbackVaryings(estado.programa, 0, salidas, GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(estado.programa);
}

static void comparaConDesnudos() {
    const GLuint desnudo = glCreateProgram();
    compila(desnudo, GL_VERTEX_SHADER, COPIA);
    std::ifstream frag(LAB_FUENTES "/ch12_animacion/particulas.frag");
    compila(desnudo, GL_FRAGMENT_SHADER, std::string(std::istreambuf_iterator<char>(frag), {}));
    const struct {
        const char *nombre;
        GLint partes;
        std::size_t donde;
    } ATRIBUTOS[] = {{"lugar", 4, 0}, {"diametro", 1, 16}, {"tinte", 4, 20}};
    GLuint vao, buffer;
    glGenVertexArrays(1, &vao);
    glBindVertexArray(vao);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, 36 * MAXIMO, nullptr, GL_STATIC_DRAW);
    for (GLuint i = 0; i < 3; ++i) {
        glBindAttribLocation(desnudo, i, ATRIBUTOS[i].nombre);
        glVertexAttribPointer(i, ATRIBUTOS[i].partes, GL_FLOAT, GL_FALSE, 36,
                              reinterpret_cast<const void *>(ATRIBUTOS[i].donde));
        glEnableVertexAttribArray(i);
    }
    glLinkProgram(desnudo);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);

    const auto dibujaDesnudos = [&] {
        glClear(GL_COLOR_BUFFER_BIT);
        glEnable(GL_BLEND); // con la función que ha dejado dibuja()
        glUseProgram(desnudo);
        glBindVertexArray(vao);
        glDrawArrays(GL_POINTS, 0, estado.cuantas);
        glDisable(GL_BLEND);
        glutSwapBuffers();
    };
    reloj.parado = 1.5;
    for (estado.elegido = 0; estado.elegido < 3; ++estado.elegido)
        for (const int cuantas : {NORMAL, MAXIMO}) {
            estado.cuantas = cuantas;
            capturaPuntos();
            std::vector<double> cuadro, desnudos;
            for (int i = 0; i < 11; ++i) { // alternados: lo que estorbe a la máquina, que estorbe a los dos
                cuadro.push_back(milisegundos(dibuja));
                desnudos.push_back(milisegundos(dibujaDesnudos));
            }
            const double a = mediana(cuadro), b = mediana(desnudos);
            std::printf("%s\t%d\t%.1f ms\tdesnudos %.1f ms\t×%.2f\n", MODOS[estado.elegido].nombre, cuantas,
                        a, b, a / b);
        }
    std::exit(0);
}
