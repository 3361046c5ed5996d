// Lo que cuesta un cuadro de particulas frente a dibujar los mismos puntos sin calcular nada: mismos lugares, tamaños y colores, leídos
// de un buffer object, y el mismo fragment shader. Es el propio programa con otro bucle; se llama con -geometry 960x720.
#define glutMainLoop comparaConDesnudos
static void comparaConDesnudos();
#include "ch12_animacion/particulas.cpp" // NOLINT
#undef glutMainLoop
#include <chrono>
#include <fstream>
#include <functional>
#include <iterator>
#define PROGRAMA estado.programa

static const char *const VERTICE = R"(#version 140
in vec4 lugar, tinte;
in float tamano;
out vec4 color;
void main() {
    color = tinte;
    gl_Position = lugar;
    gl_PointSize = tamano;
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

static GLuint compila(GLenum tipo, const char *texto) {
    const GLuint shader = glCreateShader(tipo);
    glShaderSource(shader, 1, &texto, nullptr);
    glCompileShader(shader);
    return shader;
}

static void comparaConDesnudos() {
    const GLuint desnudo = glCreateProgram();
    glAttachShader(desnudo, compila(GL_VERTEX_SHADER, VERTICE));
    const std::string frag = [] {
        std::ifstream f(LAB_FUENTES "/ch12_animacion/particulas.frag");
        return std::string(std::istreambuf_iterator<char>(f), {});
    }();
    glAttachShader(desnudo, compila(GL_FRAGMENT_SHADER, frag.c_str()));
    const char *const atributos[] = {"lugar", "tamano", "tinte"};
    for (GLuint i = 0; i < 3; ++i)
        glBindAttribLocation(desnudo, i, atributos[i]);
    glLinkProgram(desnudo);
    GLuint vao, buffer;
    glGenVertexArrays(1, &vao);
    glBindVertexArray(vao);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, MAXIMO * 36, nullptr, GL_STATIC_DRAW);
    const GLint partes[] = {4, 1, 4};
    const std::size_t lugar[] = {0, 16, 20};
    for (GLuint i = 0; i < 3; ++i) {
        glVertexAttribPointer(i, partes[i], GL_FLOAT, GL_FALSE, 36, reinterpret_cast<const void *>(lugar[i]));
        glEnableVertexAttribArray(i);
    }
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
    const auto dibujaDesnudos = [&] {
        glClear(GL_COLOR_BUFFER_BIT);
        glEnable(GL_BLEND);
        glUseProgram(desnudo);
        glBindVertexArray(vao);
        glDrawArrays(GL_POINTS, 0, estado.cuantas);
        glDisable(GL_BLEND);
        glutSwapBuffers();
    };
    reloj.parado = 1.5;
    for (int modo = 0; modo < 3; ++modo)
        for (const int cuantas : {NORMAL, MAXIMO}) {
            teclado(static_cast<unsigned char>('1' + modo), 0, 0);
            estado.cuantas = cuantas;
            const GLuint programa = PROGRAMA;
            const char *const salidas[] = {"gl_Position", "gl_PointSize", "color"};
            glTransformFeedbackVaryings(programa, 3, salidas, GL_INTERLEAVED_ATTRIBS);
            glLinkProgram(programa);
            dibuja(); // los uniforms
            glUseProgram(programa);
            glEnable(GL_RASTERIZER_DISCARD);
            glBeginTransformFeedback(GL_POINTS);
            glBindVertexArray(estado.vao);
            glDrawArrays(GL_POINTS, 0, estado.cuantas);
            glEndTransformFeedback();
            glDisable(GL_RASTERIZER_DISCARD);
            glTransformFeedbackVaryings(programa, 0, salidas, GL_INTERLEAVED_ATTRIBS);
            glLinkProgram(programa);
            std::vector<double> cuadro, desnudos;
            for (int i = 0; i < 9; ++i) { // alternados
                cuadro.push_back(milisegundos(dibuja));
                desnudos.push_back(milisegundos(dibujaDesnudos));
            }
            const double a = mediana(cuadro), b = mediana(desnudos);
            std::printf("%s\t%d\t%.1f ms\tdesnudos %.1f ms\t%.2f\n", MODOS[modo].nombre, cuantas, a, b, a / b);
            std::fflush(stdout);
        }
    std::exit(0);
}
