// Un programa de GLUT que no usa common/ ni mira sus argumentos. Escribe cuánto mide lo que dibuja.
#include <GL/freeglut.h>
#include <cstdio>

static void dibuja() {
    GLint v[4];
    glGetIntegerv(GL_VIEWPORT, v);
    std::printf("%d %d\n", v[2], v[3]);
    glutSwapBuffers();
}

int main(int argc, char **argv) {
    glutInit(&argc, argv);
    glutInitWindowSize(50, 40); // después de glutInit, tampoco puede más que -geometry
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGBA);
    glutInitContextVersion(3, 1);
    glutCreateWindow("suelto");
    glutDisplayFunc(dibuja);
    glutMainLoop();
    return 0;
}
