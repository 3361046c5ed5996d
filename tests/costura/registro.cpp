// Escribe en stdout todo lo que GLUT le dice: lo mismo sin ventana y con FreeGLUT (tests/costura/registro.sh lo
// compara). Con el argumento `menu` pone un menú en el botón derecho. Esc termina.
#include "ventana.h"
#include <cstdio>

static int dibujos = 0;

static void escribe(const char *suceso, int a, int b, int c, int d) {
    std::printf("%s %d %d %d %d\n", suceso, a, b, c, d);
    std::fflush(stdout);
}

static void dibuja() {
    ++dibujos;
    glClear(GL_COLOR_BUFFER_BIT);
    glutSwapBuffers();
}

static void cambiaTamano(int ancho, int alto) {
    glViewport(0, 0, ancho, alto);
    escribe("tamano", ancho, alto, glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT));
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "registro", GLUT_DOUBLE | GLUT_RGBA | GLUT_DEPTH);
    glutDisplayFunc(dibuja);
    glutReshapeFunc(cambiaTamano);
    glutKeyboardFunc([](unsigned char tecla, int x, int y) {
        escribe("tecla", tecla, x, y, 0);
        teclaComun(tecla);
    });
    glutKeyboardUpFunc([](unsigned char tecla, int x, int y) { escribe("tecla arriba", tecla, x, y, 0); });
    glutSpecialFunc([](int tecla, int x, int y) { escribe("especial", tecla, x, y, 0); });
    glutSpecialUpFunc([](int tecla, int x, int y) { escribe("especial arriba", tecla, x, y, 0); });
    glutMouseFunc([](int boton, int estado, int x, int y) { escribe("boton", boton, estado, x, y); });
    glutMotionFunc([](int x, int y) { escribe("arrastre", x, y, 0, 0); });
    glutPassiveMotionFunc([](int x, int y) { escribe("movimiento", x, y, 0, 0); });
    glutMouseWheelFunc(
        [](int rueda, int direccion, int x, int y) { escribe("rueda", rueda, direccion, x, y); });
    glutCloseFunc([] { escribe("cierre", dibujos > 0, 0, 0, 0); });
    glutMainLoop();
    escribe("fin", 0, 0, 0, 0);
    return 0;
}
