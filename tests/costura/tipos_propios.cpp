// Un programa que define por su cuenta lo que glut_sin_ventana llama igual por dentro: no se estorban.
#include <GL/freeglut.h>
#include <cstdio>
#include <string>
#include <vector>

struct Orden {
    int cantidad = 7;
    std::string plato = "una orden larga, que no cabe en la propia cadena";
    ~Orden() {
        cantidad = 0;
    }
};
struct Menu {
    std::vector<Orden> ordenes{3};
};
struct Temporizador {
    double segundos = 1.5;
};
struct Entrada {
    char texto[64] = "entrada";
};
struct Talla {
    char cual = 'M';
};
struct Palabras {
    int cuantas = 2;
};

const char *const AYUDA = "ninguna";
std::string errorGL = "no hay";

// Con los nombres de sus funciones: si se enlazaran éstas, no habría imagen.
void creaContexto(int, int, bool, bool) {
}
void cambiaTallaContexto(int, int) {
}
void destruyeContexto() {
}
void (*direccionGL(const char *))() {
    return nullptr;
}
int enteroDe(const std::string &, int, int, const std::string &) {
    return -1;
}
void tallaDe(const std::string &, int &, int &, const std::string &) {
}
std::vector<Orden> leeGuion(const std::string &) {
    return Menu{}.ordenes;
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT);
    glutSwapBuffers();
}

int main(int argc, char **argv) {
    glutInit(&argc, argv);
    glutInitWindowSize(50, 40); // después de glutInit, tampoco puede más que -geometry
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGBA);
    glutInitContextVersion(3, 1);
    glutCreateWindow("tipos propios");
    glClearColor(0, 1, 0, 1);
    glutDisplayFunc(dibuja);
    const Menu carta;
    const std::vector<Temporizador> temporizadores(3);
    glutMainLoop();
    std::printf("%zu %d %.1f %s %d %s %s\n", carta.ordenes.size(), carta.ordenes[2].cantidad,
                temporizadores[2].segundos, Entrada{}.texto, Palabras{}.cuantas, AYUDA, errorGL.c_str());
    return 0;
}
