// Escribe en stdout todo lo que GLUT le dice y todo lo que él le pide, y cómo queda (glut_test.cpp). Lo que pide va
// en su argumento, en tandas separadas por «/», y en cada una, llamadas separadas por «;»: una palabra y sus
// números. La primera tanda, antes de glutMainLoop; las demás, una cada vez que se pulsa una tecla especial o le
// llega un valor acabado en 7 de un menú o de un temporizador.
#include "ventana.h"
#include <cstdio>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <vector>

using Numeros = std::vector<int>;

static std::istringstream tandas;

static void escribe(const std::string &que, const Numeros &numeros = {}) {
    std::printf("%s", que.c_str());
    for (const int n : numeros)
        std::printf(" %d", n);
    std::printf(" | %dx%d, a %d ms\n", glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT),
                glutGet(GLUT_ELAPSED_TIME));
    std::fflush(stdout);
}

static void tanda();

static void llega(const char *que, int quien, int valor) {
    escribe(que, {quien, valor});
    if (valor % 10 == 7)
        tanda();
}

// Cada función, en dos versiones, para que se vea cuál está puesta.
template<int N>
struct De {
    static void dibuja() {
        escribe("dibuja", {N});
        glClear(GL_COLOR_BUFFER_BIT);
        glutSwapBuffers();
        if (N == 2)
            glutPostRedisplay();
    }
    static void tamano(int ancho, int alto) {
        escribe("tamano", {N, ancho, alto});
    }
    static void teclado(unsigned char tecla, int x, int y) {
        escribe("teclado", {N, tecla, x, y});
        teclaComun(tecla);
    }
    static void especial(int tecla, int x, int y) {
        escribe("especial", {N, tecla, x, y});
        tanda();
    }
    static void raton(int boton, int estado, int x, int y) {
        escribe("raton", {N, boton, estado, x, y});
    }
    static void arrastre(int x, int y) {
        escribe("arrastre", {N, x, y});
    }
    static void movimiento(int x, int y) {
        escribe("movimiento", {N, x, y});
    }
    static void rueda(int cual, int giro, int x, int y) {
        escribe("rueda", {N, cual, giro, x, y});
    }
    static void menu(int valor) {
        llega("menu", N, valor);
    }
};

#define PON(nombre, glutFuncion)                                                                             \
    {                                                                                                        \
#nombre, [](const Numeros &                                                                          \
                        n) { glutFuncion(n[0] == 0   ? nullptr                                               \
                                         : n[0] == 1 ? De<1>::nombre                                         \
                                                     : De<2>::nombre); } \
    }
static const std::map<std::string, std::function<void(const Numeros &)>> LLAMADAS = {
    PON(dibuja, glutDisplayFunc),
    PON(tamano, glutReshapeFunc),
    PON(teclado, glutKeyboardFunc),
    PON(especial, glutSpecialFunc),
    PON(raton, glutMouseFunc),
    PON(arrastre, glutMotionFunc),
    PON(movimiento, glutPassiveMotionFunc),
    PON(rueda, glutMouseWheelFunc),
    {"crea", [](const Numeros &n) { glutCreateMenu(n[0] == 1 ? De<1>::menu : De<2>::menu); }},
    {"actual", [](const Numeros &n) { glutSetMenu(n[0]); }},
    {"opcion", [](const Numeros &n) { glutAddMenuEntry(std::to_string(n[0]).c_str(), n[1]); }},
    {"submenu", [](const Numeros &n) { glutAddSubMenu(std::to_string(n[0]).c_str(), n[1]); }},
    {"enlaza", [](const Numeros &n) { glutAttachMenu(n[0]); }},
    {"temporizador",
     [](const Numeros &n) {
         glutTimerFunc(
             unsigned(n[0]), [](int valor) { llega("temporizador", 0, valor); }, n[1]);
     }},
    {"repinta", [](const Numeros &) { glutPostRedisplay(); }},
    {"talla", [](const Numeros &n) { glutReshapeWindow(n[0], n[1]); }},
    {"completa", [](const Numeros &) { glutFullScreenToggle(); }},
    {"titulo", [](const Numeros &n) { ponTitulo(std::to_string(n[0])); }},
    {"acaba", [](const Numeros &) { glutLeaveMainLoop(); }},
};

static void tanda() {
    std::string llamadas, llamada, nombre;
    std::getline(tandas, llamadas, '/');
    for (std::istringstream todas(llamadas); std::getline(todas, llamada, ';');) {
        std::istringstream palabras(llamada);
        Numeros numeros;
        palabras >> nombre;
        for (int n; palabras >> n;)
            numeros.push_back(n);
        LLAMADAS.at(nombre)(numeros);
        escribe("- " + nombre, numeros);
    }
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Registro, así: θ · 2° → π", GLUT_DOUBLE | GLUT_RGBA | GLUT_DEPTH, "[TANDAS]");
    glutSetOption(GLUT_ACTION_ON_WINDOW_CLOSE, GLUT_ACTION_GLUTMAINLOOP_RETURNS);
    tandas.str(argc > 1 ? argv[1] : "");
    glutDisplayFunc(De<1>::dibuja);
    glutSpecialFunc(De<1>::especial);
    tanda();
    glutMainLoop();
    std::puts("fin");
    return 0;
}
