// Escribe en stdout todo lo que GLUT le dice: lo mismo sin ventana y con FreeGLUT (tests/costura/registro.sh lo
// compara). Con el argumento `menu` no atiende la rueda aparte, pone un menú en el botón derecho y con la tecla `o`
// una función de ocio, o la quita. Esc termina.
#include "ventana.h"
#include <cstdio>

static int dibujos = 0;
static bool dibujado = false, conOcio = false, ocioPendiente = false;

static void escribe(const char *suceso, int a, int b, int c, int d) {
    std::printf("%s %d %d %d %d\n", suceso, a, b, c, d);
    std::fflush(stdout);
}

static void dibuja() {
    ++dibujos;
    dibujado = true;
    glClear(GL_COLOR_BUFFER_BIT);
    glutSwapBuffers();
}

static void cambiaTamano(int ancho, int alto) {
    glViewport(0, 0, ancho, alto);
    escribe("tamano", ancho, alto, glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT));
}

// FreeGLUT la llama sin parar: se escribe la primera vez tras soltar una tecla, y si antes se ha dibujado.
static void ocio() {
    if (ocioPendiente)
        escribe("ocio", dibujado, 0, 0, 0);
    ocioPendiente = false;
}

static void submenu(int valor) {
    escribe("submenu", valor, glutGetMenu(), 0, 0);
}

static void menu(int valor) {
    escribe("menu", valor, glutGetMenu(), 0, 0);
    if (valor == 3)
        glutChangeToMenuEntry(2, "Ejes puestos", 4);
    else if (valor == 5)
        glutLeaveMainLoop();
}

static void ponMenus() {
    const int vistas = glutCreateMenu(submenu);
    glutAddMenuEntry("Planta, que es como se ve desde arriba", 1);
    glutAddMenuEntry("Perfil", 2);
    glutCreateMenu(menu);
    glutAddSubMenu("Vista", vistas);
    glutAddMenuEntry("Ejes quitados", 3);
    glutAddMenuEntry("Salir", 5);
    glutAttachMenu(GLUT_RIGHT_BUTTON);
    glutSetMenu(vistas);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Registro, así: θ · 2° → π", GLUT_DOUBLE | GLUT_RGBA | GLUT_DEPTH, "[menu]");
    const bool conMenu = argc > 1;
    glutDisplayFunc(dibuja);
    glutReshapeFunc(cambiaTamano);
    glutKeyboardFunc([](unsigned char tecla, int x, int y) {
        escribe("tecla", tecla, x, y, glutGetMenu());
        teclaComun(tecla);
        if (tecla == 'o')
            glutIdleFunc((conOcio = !conOcio) ? ocio : nullptr);
    });
    glutKeyboardUpFunc([](unsigned char tecla, int x, int y) {
        escribe("tecla arriba", tecla, x, y, 0);
        dibujado = false;
        ocioPendiente = true;
        glutPostRedisplay();
    });
    glutSpecialFunc([](int tecla, int x, int y) { escribe("especial", tecla, x, y, 0); });
    glutSpecialUpFunc([](int tecla, int x, int y) { escribe("especial arriba", tecla, x, y, 0); });
    glutMouseFunc([](int boton, int estado, int x, int y) { escribe("boton", boton, estado, x, y); });
    glutMotionFunc([](int x, int y) { escribe("arrastre", x, y, 0, 0); });
    glutPassiveMotionFunc([](int x, int y) { escribe("movimiento", x, y, 0, 0); });
    if (conMenu)
        ponMenus();
    else
        glutMouseWheelFunc(
            [](int rueda, int direccion, int x, int y) { escribe("rueda", rueda, direccion, x, y); });
    glutCloseFunc([] { escribe("cierre", dibujos > 0, 0, 0, 0); });
    glutMainLoop();
    return 0;
}
