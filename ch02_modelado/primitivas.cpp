// Las siete primitivas de dibujo (§2.2.1) con los mismos seis vértices, enviados en el mismo orden: solo
// cambia el primer argumento de glDrawArrays. Con `flat` cada punto, segmento o triángulo toma el color de su
// último vértice, y se ve cuáles salen.
// Controles: 1 puntos · 2 3 4 líneas · 5 6 7 triángulos · 0 todas · Esc termina.
#include "shader.h"
#include "ventana.h"
#include <algorithm>
#include <cstddef>

// El vértice 0 abajo en el centro y los demás a su alrededor, con radio grande y pequeño alternos: así no
// se solapan ni los triángulos de la tira ni los del abanico.
static const struct {
    GLfloat posicion[2], color[3];
} VERTICES[] = {{{0.00f, -0.70f}, {0.95f, 0.55f, 0.10f}},  {{0.86f, -0.44f}, {0.85f, 0.20f, 0.18f}},
                {{0.36f, -0.08f}, {0.16f, 0.38f, 0.80f}},  {{0.00f, 0.80f}, {0.20f, 0.62f, 0.28f}},
                {{-0.36f, -0.08f}, {0.98f, 0.78f, 0.15f}}, {{-0.86f, -0.44f}, {0.55f, 0.25f, 0.70f}}};
static const GLsizei N_VERTICES = sizeof VERTICES / sizeof VERTICES[0];

// Cada familia en una fila de la rejilla de 3×3; la fila 0 es la de abajo.
static const struct {
    GLenum primitiva;
    const char *nombre;
    int columna, fila;
} PANELES[] = {{GL_POINTS, "GL_POINTS", 1, 2},
               {GL_LINES, "GL_LINES", 0, 1},
               {GL_LINE_STRIP, "GL_LINE_STRIP", 1, 1},
               {GL_LINE_LOOP, "GL_LINE_LOOP", 2, 1},
               {GL_TRIANGLES, "GL_TRIANGLES", 0, 0},
               {GL_TRIANGLE_STRIP, "GL_TRIANGLE_STRIP", 1, 0},
               {GL_TRIANGLE_FAN, "GL_TRIANGLE_FAN", 2, 0}};

static struct {
    GLuint programa;
    int elegida = 0; // desde 1; 0: todas
} estado;

static void inicia() {
    estado.programa = creaPrograma("ch02_modelado/primitivas.vert", "ch02_modelado/primitivas.frag");
    GLuint vao, buffer;
    glGenVertexArrays(1, &vao);
    glBindVertexArray(vao);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof VERTICES, VERTICES, GL_STATIC_DRAW);
    glVertexAttribPointer(ATRIBUTO_POSICION, 2, GL_FLOAT, GL_FALSE, sizeof VERTICES[0], nullptr);
    glVertexAttribPointer(ATRIBUTO_COLOR, 3, GL_FLOAT, GL_FALSE, sizeof VERTICES[0],
                          reinterpret_cast<const void *>(sizeof VERTICES[0].posicion));
    glEnableVertexAttribArray(ATRIBUTO_POSICION);
    glEnableVertexAttribArray(ATRIBUTO_COLOR);
}

// Un rectángulo claro con la figura en el mayor cuadrado que cabe.
static void dibujaPanel(GLenum primitiva, int x, int y, int ancho, int alto) {
    const int lado = std::max(std::min(ancho, alto), 1);
    glScissor(x, y, std::max(ancho, 0), std::max(alto, 0));
    glClearColor(0.97f, 0.98f, 0.99f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glViewport(x + (ancho - lado) / 2, y + (alto - lado) / 2, lado, lado);
    glPointSize(std::max(6.0f, static_cast<float>(lado) / 9));
    glLineWidth(std::max(3.0f, static_cast<float>(lado) / 36));
    glDrawArrays(primitiva, 0, N_VERTICES);
}

static void dibuja() {
    const int ancho = glutGet(GLUT_WINDOW_WIDTH), alto = glutGet(GLUT_WINDOW_HEIGHT);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0.80f, 0.84f, 0.90f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(estado.programa);
    glEnable(GL_SCISSOR_TEST);
    if (estado.elegida > 0) {
        dibujaPanel(PANELES[estado.elegida - 1].primitiva, 0, 0, ancho, alto);
    } else {
        const int margen = std::min(ancho, alto) / 60;
        for (const auto &p : PANELES) {
            const int x = p.columna * ancho / 3, y = p.fila * alto / 3;
            dibujaPanel(p.primitiva, x + margen, y + margen, (p.columna + 1) * ancho / 3 - x - 2 * margen,
                        (p.fila + 1) * alto / 3 - y - 2 * margen);
        }
    }
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla < '0' || tecla > '7')
        return;
    estado.elegida = tecla - '0';
    glutSetWindowTitle(estado.elegida > 0 ? PANELES[estado.elegida - 1].nombre : "Primitivas");
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Primitivas", GLUT_DOUBLE | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutReshapeFunc([](int, int) { glutPostRedisplay(); }); // cada panel pone su glViewport
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
