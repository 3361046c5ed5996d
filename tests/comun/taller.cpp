// Un programa para probar common/ por dentro: dos cuadrados, cada uno con sus shaders, taller/a.* y taller/b.* de
// $LAB_RAIZ. Teclas: 0 a 9 ponen en taller/ la versión $LAB_RAIZ/N (el usuario edita); n va a una carpeta que ya no
// existe y v vuelve.
#include "buferes.h"
#include "shader.h"
#include "ventana.h"
#include <cstdlib>
#include <filesystem>
#include <string>

namespace fs = std::filesystem;

static struct {
    GLuint programas[2];
    Buferes cuadrado;
} estado;

static void edita(char version) {
    const std::string carpetas = std::getenv("LAB_RAIZ");
    const fs::path raiz = carpetas.substr(0, carpetas.find(':')); // la primera
    fs::remove_all(raiz / "taller");
    fs::copy(raiz / std::string(1, version), raiz / "taller");
}

static void inicia() {
    edita('0');
    estado.programas[0] = creaPrograma("taller/a.vert", "taller/a.frag");
    estado.programas[1] = creaPrograma("taller/b.vert", "taller/b.frag");
    estado.cuadrado = creaBuferes(plano(1));
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT);
    for (const GLuint programa : estado.programas) {
        glUseProgram(programa);
        dibuja(estado.cuadrado);
    }
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    static const fs::path carpeta = fs::current_path();
    if (tecla == 'n') {
        fs::create_directory("efimera");
        fs::current_path("efimera");
        fs::remove(carpeta / "efimera");
    } else if (tecla == 'v') {
        fs::current_path(carpeta);
    } else if (!teclaComun(tecla)) {
        edita(char(tecla));
    }
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "taller", GLUT_DOUBLE | GLUT_RGBA);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
