// Cómo se ve un error de compilación y uno de enlazado (§1.6, listado 1.3): fichero, línea y texto de la línea, en la
// consola. El programa sigue vivo con los shaders que tenía y el fondo se pone rojo; F5 vuelve a intentarlo.
// Controles: 1 sin error · 2 error de compilación · 3 error de enlazado · F5 relee · Esc termina.
#include "colores.h"
#include "rotulo.h"
#include "shader.h"
#include "ventana.h"
#include <algorithm>
#include <cstdio>
#include <string>

static const struct {
    const char *fragmentShader, *titulo;
} CASOS[] = {{"ch01_intro/errores_shader.frag", "Compila y enlaza"},
             {"ch01_intro/errores_shader_compila.frag", "Error de compilación"},
             {"ch01_intro/errores_shader_enlaza.frag", "Error de enlazado"}};

static const GLfloat VERTICES[3][6] = { // posición y color
    {-0.95f, -0.92f, 0, 0.98f, 0.78f, 0.15f},
    {0.95f, -0.92f, 0, 0.20f, 0.62f, 0.28f},
    {0.0f, 0.62f, 0, 0.16f, 0.38f, 0.80f}};

static struct {
    GLuint programa = 0;
    int elegido = 0;
    bool hayError = false;
} estado;

static void intenta() {
    std::string error;
    const char *fragmentShader = CASOS[estado.elegido].fragmentShader;
    const GLuint nuevo = intentaPrograma("ch01_intro/errores_shader.vert", fragmentShader, error);
    estado.hayError = nuevo == 0;
    if (nuevo) {
        borraPrograma(estado.programa);
        estado.programa = nuevo;
        std::printf("%s: compila y enlaza\n", fragmentShader);
    } else {
        std::printf("%s\n", error.c_str());
    }
    std::fflush(stdout);
    ponTitulo(CASOS[estado.elegido].titulo);
    glutPostRedisplay();
}

static void inicia() {
    GLuint vao, buffer;
    glGenVertexArrays(1, &vao);
    glBindVertexArray(vao);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof VERTICES, VERTICES, GL_STATIC_DRAW);
    glVertexAttribPointer(ATRIBUTO_POSICION, 3, GL_FLOAT, GL_FALSE, sizeof VERTICES[0], nullptr);
    glVertexAttribPointer(ATRIBUTO_COLOR, 3, GL_FLOAT, GL_FALSE, sizeof VERTICES[0],
                          reinterpret_cast<const void *>(3 * sizeof(GLfloat)));
    glEnableVertexAttribArray(ATRIBUTO_POSICION);
    glEnableVertexAttribArray(ATRIBUTO_COLOR);
    intenta();
}

static void dibuja() {
    const glm::vec3 &fondo = estado.hayError ? ROJO : FONDO_CLARO;
    glClearColor(fondo.r, fondo.g, fondo.b, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(estado.programa);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    rotula(CASOS[estado.elegido].titulo + std::string(estado.hayError ? ":\nsigue el programa de antes" : ""),
           {0.5f, 0.97f}, estado.hayError ? BLANCO : OSCURO, Lado::DEBAJO);
    glutSwapBuffers();
}

static void cambiaTamano(int ancho, int alto) {
    const int lado = std::max(std::min(ancho, alto), 1);
    glViewport((ancho - lado) / 2, (alto - lado) / 2, lado, lado);
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla < '1' || tecla > '3')
        return;
    estado.elegido = tecla - '1';
    intenta();
}

static void tecladoEspecial(int tecla, int, int) {
    if (tecla == GLUT_KEY_F5)
        intenta();
    else
        teclaEspecialComun(tecla);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Errores en los shaders", GLUT_DOUBLE | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutReshapeFunc(cambiaTamano);
    glutKeyboardFunc(teclado);
    glutSpecialFunc(tecladoEspecial);
    glutMainLoop();
    return 0;
}
