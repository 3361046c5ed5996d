// La ventana mínima: un fondo amarillo, con las cuatro etapas de un programa OpenGL a la vista (listado 1.1).
// No usa nada de common/.
// Controles: Esc termina.
#include <GL/freeglut.h>

static void inicia() {
    glClearColor(1.0f, 1.0f, 0.0f, 1.0f);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT);
    glutSwapBuffers();
}

static void cambiaTamano(int ancho, int alto) {
    glViewport(0, 0, ancho, alto);
}

static void teclado(unsigned char tecla, int, int) {
    const unsigned char ESC = 27;
    if (tecla == ESC)
        glutLeaveMainLoop();
}

int main(int argc, char **argv) {
    // 1. Crear una ventana. El tamaño va antes de glutInit para que la opción -geometry pueda cambiarlo.
    glutInitWindowSize(1024, 768);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGBA);
    glutInitContextVersion(3, 1);
    glutCreateWindow("Primer programa");

    // 2. Dar valor inicial al estado de OpenGL.
    inicia();

    // 3. Decir qué función atiende cada suceso y esperar; 4. dibujar la escena es uno de ellos.
    glutDisplayFunc(dibuja);
    glutReshapeFunc(cambiaTamano);
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
