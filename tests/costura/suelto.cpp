// Un programa de GLUT que no usa common/ ni mira sus argumentos.
#include <GL/freeglut.h>

int main(int argc, char **argv) {
    glutInit(&argc, argv);
    glutInitWindowSize(50, 40); // después de glutInit, tampoco puede más que -geometry
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGBA);
    glutInitContextVersion(3, 1);
    glutCreateWindow("suelto");
    glutDisplayFunc(glutSwapBuffers);
    glutMainLoop();
    return 0;
}
