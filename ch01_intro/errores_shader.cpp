// Cómo se ve un error de compilación y uno de enlazado (§1.6, listado 1.3): fichero, línea y texto de la línea, en la
// consola. El programa sigue vivo con los shaders que tenía y el fondo se pone rojo; F5 vuelve a intentarlo. Lo que en
// el libro es initShader lo hace intentaPrograma, que también mira los errores (chequeaCompilacion y chequeaEnlazado):
// está en common/shader.cpp.
// Controles: 1 sin error · 2 error de compilación · 3 error de enlazado · F5 relee · Esc termina.
#include "buferes.h"
#include "colores.h"
#include "modos.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "ventana.h"
#include <algorithm>
#include <cstdio>
#include <string>

static const struct {
    const char *fragmentShader, *titulo;
} CASOS[] = {{"ch01_intro/errores_shader.frag", "Compila y enlaza"},
             {"ch01_intro/errores_shader_compila.frag", "Error de compilación"},
             {"ch01_intro/errores_shader_enlaza.frag", "Error de enlazado"}};

static const std::vector<VerticeColor> VERTICES = {
    {{-0.95f, -0.92f, 0}, AMARILLO}, {{0.95f, -0.92f, 0}, VERDE}, {{0, 0.62f, 0}, AZUL}};

static struct {
    GLuint programa = 0;
    int elegido = 0;
    bool hayError = false;
} estado;

static void intenta() {
    std::string error;
    const char *fragmentShader = CASOS[estado.elegido].fragmentShader;
    const GLuint nuevo = intentaPrograma("ch01_intro/errores_shader.vert", fragmentShader, error);
    estado.hayError = nuevo == 0;
    if (nuevo) {
        borraPrograma(estado.programa);
        estado.programa = nuevo;
        std::printf("%s: compila y enlaza\n", fragmentShader);
    } else {
        std::printf("%s\n", error.c_str());
    }
    std::fflush(stdout);
    ponTitulo(CASOS[estado.elegido].titulo);
    glutPostRedisplay();
}

static void dibuja() {
    const glm::vec3 &fondo = estado.hayError ? ROJO : FONDO_CLARO;
    ponFondo(fondo);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(estado.programa);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    rotula(CASOS[estado.elegido].titulo + std::string(estado.hayError ? ":\nsigue el programa de antes" : ""),
           {0.5f, 0.97f}, estado.hayError ? BLANCO : OSCURO, Lado::DEBAJO);
    glutSwapBuffers();
}

static void cambiaTamano(int ancho, int alto) {
    const int lado = std::max(std::min(ancho, alto), 1);
    glViewport((ancho - lado) / 2, (alto - lado) / 2, lado, lado);
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || !eligeModo(estado.elegido, 3, tecla))
        return;
    intenta();
}

static void tecladoEspecial(int tecla, int, int) {
    if (tecla == GLUT_KEY_F5)
        intenta();
    else
        teclaEspecialComun(tecla);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Errores en los shaders", GLUT_DOUBLE | GLUT_MULTISAMPLE);
    creaVerticesColor(VERTICES);
    intenta();
    glutDisplayFunc(dibuja);
    glutReshapeFunc(cambiaTamano);
    glutKeyboardFunc(teclado);
    glutSpecialFunc(tecladoEspecial);
    glutMainLoop();
    return 0;
}
