// La ventana mínima: un fondo amarillo, con las cuatro etapas de un programa OpenGL a la vista (listado 1.1). Las
// teclas dejan ver qué hace cada función (ejercicio 1.2, contestado en docs/soluciones.md): el estado que se cambia no
// se ve hasta que se dibuja, y lo que se dibuja no se ve hasta que se intercambian los buffers. No usa nada de common/.
// Lo que en el libro son init, display y reshape es aquí inicia, dibuja y cambiaTamano. La ventana mide 960×720 y no
// 1024×768, sin glutInitWindowPosition: el sitio lo elige el sistema. Y se pide OpenGL 3.1 (glutInitContextVersion).
// Dibujado sin ventana o en una página no hay dos buffers que intercambiar: la tecla s solo se nota en una ventana.
// Controles: i da otro color de borrado · d dibuja · s quita o pone glutSwapBuffers · Esc termina.
#include <GL/freeglut.h>
#include <cstdio>
#include <string>

static struct { bool azul = false, intercambia = true; } estado;

static void inicia() {
    if (estado.azul)
        glClearColor(0.16f, 0.38f, 0.80f, 1.0f);
    else
        glClearColor(1.0f, 1.0f, 0.0f, 1.0f);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT);
    if (estado.intercambia)
        glutSwapBuffers();
}

static void cambiaTamano(int ancho, int alto) {
    glViewport(0, 0, ancho, alto);
}

static void teclado(unsigned char tecla, int, int) {
    const unsigned char ESC = 27;
    switch (tecla) {
    case 'i':
        estado.azul = !estado.azul;
        inicia();
        break;
    case 'd': glutPostRedisplay(); break;
    case 's':
        estado.intercambia = !estado.intercambia;
        glutSetWindowTitle(estado.intercambia ? "Primer programa" : "Primer programa: sin glutSwapBuffers");
        break;
    case ESC: glutLeaveMainLoop(); break;
    }
}

int main(int argc, char **argv) {
    // 1. Crear una ventana. El tamaño va antes de glutInit para que la opción -geometry pueda cambiarlo.
    glutInitWindowSize(960, 720);
    glutInit(&argc, argv);
    if (argc > 1) { // glutInit ha quitado sus opciones
        const bool ayuda = std::string(argv[1]) == "-ayuda";
        std::fprintf(ayuda ? stdout : stderr, "uso: primer_programa [opciones de GLUT]\n");
        return ayuda ? 0 : 2;
    }
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
