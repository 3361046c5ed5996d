// Dos cristales que se solapan (ecuación 7.2): con la mezcla de la ecuación 7.1 el color depende de cuál se dibuja
// antes. O se ordenan de atrás adelante, o se suma al color acumulado: entonces el orden da igual, pero todo brilla
// más. A la izquierda se manda dibujar antes el rojo y a la derecha el azul.
// Controles: 1 según llegan · 2 ordenados de atrás adelante · 3 aditivo · ratón orbita · Esc termina.
#include "buferes.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "orbita.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "ventana.h"
#include <algorithm>
#include <array>

static const float ALFA = 0.55f;
static const struct {
    glm::mat4 M;
    glm::vec3 color;
} CRISTALES[2] = {{traslacion({-0.35f, 0.15f, 0.5f}) * escalado({1.5f, 2.4f, 1}), {1, 0.25f, 0.2f}},
                  {traslacion({0.35f, -0.15f, -0.5f}) * escalado({1.5f, 2.4f, 1}), {0.25f, 0.6f, 1}}};
static const char *const MODOS[3] = {"según llegan", "ordenados", "aditivo"};

static struct {
    GLuint programa;
    Buferes cuadrado, cubo;
    int elegido = 0;
    Orbita orbita = {0.35f, 0.15f, 6.5f};
} estado;

static void inicia() {
    estado.programa = creaPrograma("ch03_transformaciones/objeto.vert", "ch07_realismo/liso.frag");
    estado.cuadrado = creaBuferes(plano(1));
    estado.cubo = creaBuferes(cubo());
    glEnable(GL_DEPTH_TEST);
}

static void dibujaPieza(const Buferes &pieza, const glm::mat4 &M, const glm::vec4 &color) {
    envia(estado.programa, "M", M);
    envia(estado.programa, "color", color);
    dibuja(pieza);
}

static void dibujaVista(const Recuadro &r, std::array<int, 2> orden, const char *texto) {
    abreRecuadro(r, FONDO_OSCURO);
    const glm::mat4 camara = camaraOrbita(estado.orbita);
    glUseProgram(estado.programa);
    envia(estado.programa, "camara", camara);
    envia(estado.programa, "proyeccion", perspectivaVentana(0.36f, 1, 30, aspecto(r)));
    for (const float x : {-0.9f, 0.0f, 0.9f}) // lo opaco, antes
        dibujaPieza(estado.cubo, traslacion({x, 0, -1}) * escalado({0.12f, 2, 0.12f}), glm::vec4(GRIS, 1));

    if (estado.elegido == 1) { // antes el que está más lejos de la cámara
        const auto profundidad = [&](int i) { return (camara * CRISTALES[i].M[3]).z; };
        std::sort(orden.begin(), orden.end(), [&](int a, int b) { return profundidad(a) < profundidad(b); });
    }
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, estado.elegido == 2 ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    for (const int i : orden)
        dibujaPieza(estado.cuadrado, CRISTALES[i].M, glm::vec4(CRISTALES[i].color, ALFA));
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    rotula(MODOS[estado.elegido], {0.5f, 0.94f}, AMARILLO);
    rotula(texto, {0.5f, 0.06f}, BLANCO);
}

static void dibuja() {
    abreRecuadro(ventanaEntera(), GRIS);
    const std::vector<Recuadro> mitades = reparte(2, 2.0f / 3);
    dibujaVista(mitades[0], {0, 1}, "antes el rojo");
    dibujaVista(mitades[1], {1, 0}, "antes el azul");
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla < '1' || tecla > '3')
        return;
    estado.elegido = tecla - '1';
    ponTitulo(std::string("Dos cristales: ") + MODOS[estado.elegido]);
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Dos cristales: según llegan", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
