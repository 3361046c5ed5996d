// Programas mal hechos, uno por argumento: lo que glut_sin_ventana debe notar (tests/costura/costura_test.cpp).
#include "error.h"
#include "imagen.h"
#include "shader.h"
#include "ventana.h"
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

static std::string defecto;

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
    } else if (defecto == "ocio") {
        std::printf("dibuja\n");
    } else if (defecto == "recarga") {
        glDrawArrays(GL_TRIANGLES, 0, 3);
        const Imagen imagen = leeVentana();
        std::printf("%d %d %d\n", imagen.rgb[0], imagen.rgb[1], imagen.rgb[2]);
    } else if (defecto == "lectura") {
        GLint bufer;
        glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &bufer);
        std::printf("%d\n", bufer);
    }
    glutSwapBuffers();
}

// El usuario edita el shader mientras el programa corre: primero se equivoca y luego lo arregla.
static void edita(int version) {
    const std::string cuerpo = version == 0   ? "1.0, 0.0, 0.0, 1.0"
                               : version == 1 ? "1.0, ,"
                                              : "0.0, 1.0, 0.0, 1.0";
    std::ofstream(std::getenv("LAB_RAIZ") + std::string("/tests/costura/recarga.frag"))
        << "#version 140\nout vec4 colorFragmento;\nvoid main() {\n    colorFragmento = vec4(" << cuerpo
        << ");\n}\n";
}

static void temporizador(int valor) {
    std::printf("%d a %d ms\n", valor, glutGet(GLUT_ELAPSED_TIME));
    glutTimerFunc(static_cast<unsigned>(valor), temporizador, valor);
    glutPostRedisplay();
}

static void enseguida(int quedan) {
    std::printf("%d\n", glutGet(GLUT_ELAPSED_TIME));
    if (quedan > 0)
        glutTimerFunc(0, enseguida, quedan - 1);
}

static void menu(int valor) {
    std::printf("menu %d en el %d\n", valor, glutGetMenu());
}

static void ocio() {
    static int veces = 0;
    std::printf("ocio %d\n", ++veces);
    glutPostRedisplay();
    if (veces == 3)
        glutIdleFunc(nullptr);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "defectuoso", GLUT_DOUBLE | GLUT_RGBA, "DEFECTO [SHADER]");
    defecto = argc > 1 ? argv[1] : "";
    glutDisplayFunc(dibuja);
    if (defecto == "inicio") {
        glEnable(GL_TEXTURE_2D);
    } else if (defecto == "exit") {
        glEnable(GL_TEXTURE_2D);
        std::exit(0);
    } else if (defecto == "dos_ventanas") {
        glutCreateWindow("otra");
    } else if (defecto == "shader") {
        creaPrograma(std::string("tests/costura/") + argv[2], "tests/comparador/escena.frag");
    } else if (defecto == "uniforme") {
        const GLuint p = creaPrograma("tests/comparador/escena.vert", "tests/comparador/escena.frag");
        uniforme(p, "noExiste");
        uniforme(p, "noExiste");
    } else if (defecto == "recarga") {
        GLuint vao;
        glGenVertexArrays(1, &vao);
        glBindVertexArray(vao);
        edita(0);
        glUseProgram(creaPrograma("tests/costura/recarga.vert", "tests/costura/recarga.frag"));
        glutTimerFunc(10, edita, 1);
        glutTimerFunc(20, edita, 2);
    } else if (defecto == "lectura") {
        GLuint bufer;
        glGenBuffers(1, &bufer);
        glBindBuffer(GL_PIXEL_PACK_BUFFER, bufer);
    } else if (defecto == "tiempo") {
        glutTimerFunc(250, temporizador, 250);
        glutTimerFunc(100, temporizador, 100);
        glutTimerFunc(250, menu, 1); // vence a la vez que el primero y se pidió después
    } else if (defecto == "enseguida") {
        glutTimerFunc(0, enseguida, 9);
    } else if (defecto == "menu_borrado") {
        const int borrado = glutCreateMenu(menu);
        glutCreateMenu(menu);
        glutAddSubMenu("Vista", borrado);
        glutDestroyMenu(borrado);
        glutAttachMenu(GLUT_RIGHT_BUTTON);
    } else if (defecto == "submenu_que_no_hay") {
        glutCreateMenu(menu);
        glutAddSubMenu("Vista", 77);
    } else if (defecto == "ocio") {
        glutIdleFunc(ocio);
    } else if (defecto == "muestras") {
        glutSetOption(GLUT_MULTISAMPLE, 4);
        std::printf("%d\n", glutGet(GLUT_WINDOW_NUM_SAMPLES));
    }
    glutMainLoop();
    return 0;
}
