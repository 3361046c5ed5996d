// Programas mal hechos, uno por argumento: lo que glut_sin_ventana debe notar (tests/costura/costura_test.cpp).
// «taller» son dos cuadrados, con los shaders taller/a.* y taller/b.* de $LAB_RAIZ: las teclas 0 a 9 ponen en taller/
// la versión $LAB_RAIZ/N (el usuario edita), n va a una carpeta que ya no existe y v vuelve
// (tests/common/taller_test.cpp).
#include "buferes.h"
#include "shader.h"
#include "ventana.h"
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace fs = std::filesystem;

static std::string defecto;
static GLuint programas[2]; // del taller
static Buferes cuadrado;

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT);
    if (defecto == "enum") {
        glEnable(GL_TEXTURE_2D); // no existe en un contexto core
    } else if (defecto == "begin") {
        glBegin(GL_TRIANGLES);
        glEnd();
    } else if (defecto == "sin_vao") {
        glDrawArrays(GL_TRIANGLES, 0, 3);
    } else if (defecto == "callado") { // el programa se traga el error
        glEnable(GL_TEXTURE_2D);
        while (glGetError() != GL_NO_ERROR) {
        }
    } else if (defecto == "repetido") { // se ve en el cuadro siguiente
        glClearColor(1, 0, 0, 0);
    } else if (defecto == "lectura") {
        GLint bufer;
        glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &bufer);
        std::printf("%d\n", bufer);
    } else if (defecto == "taller") {
        for (const GLuint programa : programas) {
            glUseProgram(programa);
            dibujaMalla(cuadrado);
        }
    }
    glutSwapBuffers();
}

static void edita(char version) {
    const std::string carpetas = std::getenv("LAB_RAIZ");
    const fs::path raiz = carpetas.substr(0, carpetas.find(':')); // la primera
    fs::remove_all(raiz / "taller");
    fs::copy(raiz / std::string(1, version), raiz / "taller");
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

/// Un programa que no usa common/ ni mira sus argumentos. Escribe cuánto mide lo que dibuja.
static void suelto(int argc, char **argv) {
    glutInit(&argc, argv);
    glutInitWindowSize(50, 40); // después de glutInit, tampoco puede más que -geometry
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGBA);
    glutInitContextVersion(3, 1);
    glutCreateWindow("suelto");
    glutDisplayFunc([] {
        GLint v[4];
        glGetIntegerv(GL_VIEWPORT, v);
        std::printf("%d %d\n", v[2], v[3]);
        glutSwapBuffers();
    });
    glutMainLoop();
}

int main(int argc, char **argv) {
    if (std::string(argv[argc - 1]) == "suelto") {
        suelto(argc, argv);
        return 0;
    }
    abreVentana(argc, argv, "defectuoso", GLUT_DOUBLE | GLUT_RGBA | GLUT_DEPTH, "DEFECTO");
    defecto = argc > 1 ? argv[1] : "";
    glutDisplayFunc(dibuja);
    if (defecto == "inicio") {
        glEnable(GL_TEXTURE_2D);
    } else if (defecto == "exit") {
        glEnable(GL_TEXTURE_2D);
        std::exit(0);
    } else if (defecto == "uniforme") {
        const GLuint p =
            creaPrograma("ch06_texturas/textura_objeto.vert", "ch06_texturas/textura_objeto.frag");
        uniforme(p, "noExiste");
        uniforme(p, "noExiste");
    } else if (defecto == "lectura") {
        GLuint bufer;
        glGenBuffers(1, &bufer);
        glBindBuffer(GL_PIXEL_PACK_BUFFER, bufer);
    } else if (defecto == "taller") {
        edita('0');
        programas[0] = creaPrograma("taller/a.vert", "taller/a.frag");
        programas[1] = creaPrograma("taller/b.vert", "taller/b.frag");
        cuadrado = creaBuferes(plano(1));
        glutKeyboardFunc(teclado);
    }
    glutMainLoop();
    return 0;
}
