// Cómo se ve un error de compilación y uno de enlazado (§1.6, listado 1.3): fichero, línea y texto de la
// línea. El programa sigue vivo con los shaders que tenía y el fondo se pone rojo; F5 vuelve a intentarlo.
// Controles: 1 shaders correctos · 2 error de compilación · 3 error de enlazado · F5 relee · Esc termina.
#include "shader.h"
#include "ventana.h"
#include <algorithm>
#include <cstdio>
#include <string>

static const char *const FRAGMENT_SHADERS[] = {"ch01_intro/errores_shader.frag",
                                               "ch01_intro/errores_shader_compila.frag",
                                               "ch01_intro/errores_shader_enlaza.frag"};

static const GLfloat vertices[3][6] = { // posición y color
    {-0.8f, -0.7f, 0, 0.98f, 0.80f, 0.15f},
    {0.8f, -0.7f, 0, 0.10f, 0.60f, 0.25f},
    {0.0f, 0.8f, 0, 0.10f, 0.35f, 0.85f}};

static struct {
    GLuint programa = 0;
    int elegido = 0;
    bool hayError = false;
} estado;

static void intenta() {
    std::string error;
    const GLuint nuevo =
        intentaPrograma("ch01_intro/errores_shader.vert", FRAGMENT_SHADERS[estado.elegido], error);
    estado.hayError = nuevo == 0;
    if (nuevo) {
        glDeleteProgram(estado.programa);
        estado.programa = nuevo;
        std::printf("%s: compila y enlaza\n", FRAGMENT_SHADERS[estado.elegido]);
    } else {
        std::printf("%s\n", error.c_str());
    }
    std::fflush(stdout);
    glutPostRedisplay();
}

static void inicia() {
    GLuint vao, buffer;
    glGenVertexArrays(1, &vao);
    glBindVertexArray(vao);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof vertices, vertices, GL_STATIC_DRAW);
    glVertexAttribPointer(ATRIBUTO_POSICION, 3, GL_FLOAT, GL_FALSE, sizeof vertices[0], nullptr);
    glVertexAttribPointer(ATRIBUTO_COLOR, 3, GL_FLOAT, GL_FALSE, sizeof vertices[0],
                          reinterpret_cast<const void *>(3 * sizeof(GLfloat)));
    glEnableVertexAttribArray(ATRIBUTO_POSICION);
    glEnableVertexAttribArray(ATRIBUTO_COLOR);
    intenta();
}

static void dibuja() {
    if (estado.hayError)
        glClearColor(0.80f, 0.25f, 0.22f, 1);
    else
        glClearColor(0.95f, 0.96f, 0.98f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(estado.programa);
    glDrawArrays(GL_TRIANGLES, 0, 3);
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
    abreVentana(argc, argv, "Errores en los shaders", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutReshapeFunc(cambiaTamano);
    glutKeyboardFunc(teclado);
    glutSpecialFunc(tecladoEspecial);
    glutMainLoop();
    return 0;
}
