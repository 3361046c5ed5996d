// Las siete primitivas de dibujo (§2.2.1) con los mismos seis vértices, enviados en el mismo orden: solo cambia el
// primer argumento de glDrawArrays. Con `flat` cada punto, segmento o triángulo toma el color de su último vértice, y
// se ve cuáles salen. Las líneas de OpenGL 3.1 miden un píxel: para que se vean de lejos se repiten corridas, como con
// un pincel.
// Controles: 1 puntos · 2 3 4 líneas · 5 6 7 triángulos · 0 todas · Esc termina.
#include "buferes.h"
#include "colores.h"
#include "modos.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "ventana.h"
#include <algorithm>

// El vértice 0 abajo en el centro y los demás a su alrededor, con radio grande y pequeño alternos: así no
// se solapan ni los triángulos de la tira ni los del abanico.
static const std::vector<VerticeColor> VERTICES = {
    {{0.00f, -0.68f, 0}, NARANJA}, {{0.81f, -0.42f, 0}, ROJO},      {{0.34f, -0.08f, 0}, AZUL},
    {{0.00f, 0.66f, 0}, VERDE},    {{-0.34f, -0.08f, 0}, AMARILLO}, {{-0.81f, -0.42f, 0}, MORADO}};
// Del vértice al centro de su número: hacia donde no hay nada, o menos.
static const glm::vec3 AL_NUMERO[] = {{0, -0.16f, 0}, {0, -0.16f, 0},     {0.13f, 0.08f, 0},
                                      {0, 0.16f, 0},  {-0.13f, 0.08f, 0}, {0, -0.16f, 0}};
static const int N_VERTICES = 6;

static const struct {
    GLenum primitiva;
    const char *nombre, *enLineas; // el segundo cabe en un panel pequeño
} PRIMITIVAS[] = {{GL_POINTS, "GL_POINTS", "GL_POINTS"},
                  {GL_LINES, "GL_LINES", "GL_LINES"},
                  {GL_LINE_STRIP, "GL_LINE_STRIP", "GL_LINE_STRIP"},
                  {GL_LINE_LOOP, "GL_LINE_LOOP", "GL_LINE_LOOP"},
                  {GL_TRIANGLES, "GL_TRIANGLES", "GL_TRIANGLES"},
                  {GL_TRIANGLE_STRIP, "GL_TRIANGLE_STRIP", "GL_TRIANGLE_\nSTRIP"},
                  {GL_TRIANGLE_FAN, "GL_TRIANGLE_FAN", "GL_TRIANGLE_\nFAN"}};
static const int N_PRIMITIVAS = 7;

static struct {
    GLuint programa;
    int elegido = TODOS;
} estado;

// `altoFigura`: la parte del alto que ocupa; encima va el nombre, de esa talla.
static void dibujaPanel(const Recuadro &panel, int i, const char *nombre, float altoFigura, float talla) {
    abreRecuadro(panel);
    ponFondo(FONDO_CLARO);
    glClear(GL_COLOR_BUFFER_BIT);
    rotula(nombre, {0.5f, 0.99f}, OSCURO, Lado::DEBAJO, talla);
    const int alto = int(altoFigura * float(panel.alto));
    const int lado = std::max(std::min(panel.ancho, alto), 1);
    const int x = panel.x + (panel.ancho - lado) / 2, y = panel.y + (alto - lado) / 2;
    const GLenum primitiva = PRIMITIVAS[i].primitiva;
    const bool esLinea = primitiva == GL_LINES || primitiva == GL_LINE_STRIP || primitiva == GL_LINE_LOOP;
    const int pincel = esLinea ? lado / 72 : 0; // medio lado del pincel, en píxeles
    envia(estado.programa, "diametroPunto", std::max(float(lado) / 20, 3.0f));
    for (int dy = -pincel; dy <= pincel; ++dy)
        for (int dx = -pincel; dx <= pincel; ++dx) {
            glViewport(x + dx, y + dy, lado, lado);
            glDrawArrays(primitiva, 0, N_VERTICES);
        }
    glViewport(x, y, lado, lado);
    for (int k = 0; k < N_VERTICES; ++k)
        rotulaPunto(std::to_string(k), VERTICES[k].posicion + AL_NUMERO[k], glm::mat4(1), OSCURO,
                    Lado::CENTRO, 0.07f * float(lado) / altoUtil());
}

static void dibuja() {
    abreRecuadro(ventanaEntera());
    ponFondo(GRIS);
    glClear(GL_COLOR_BUFFER_BIT);
    const glm::mat4 I(1); // los vértices ya están en las coordenadas del panel
    usaPrograma(estado.programa, I, I);
    if (estado.elegido != TODOS) {
        dibujaPanel(ventanaEntera(), estado.elegido, PRIMITIVAS[estado.elegido].nombre, 0.9f, TALLA_ROTULO);
    } else {
        std::vector<Recuadro> paneles = reparte(N_PRIMITIVAS + 1, 0.8f);
        paneles.back().ancho =
            glutGet(GLUT_WINDOW_WIDTH) - paneles.back().x; // hasta el borde: no sobran casillas
        for (int i = 0; i < N_PRIMITIVAS; ++i)
            dibujaPanel(paneles[i], i, PRIMITIVAS[i].enLineas, 2.0f / 3, 0.0265f);
        abreRecuadro(paneles.back());
        ponFondo(FONDO_CLARO);
        glClear(GL_COLOR_BUFFER_BIT);
        rotula("El color\nes el del\núltimo\nvértice", {0.5f, 0.5f}, OSCURO);
    }
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (!teclaComun(tecla) && eligeModoOTodos(estado.elegido, N_PRIMITIVAS, tecla))
        ponTitulo(estado.elegido == TODOS ? "Primitivas" : PRIMITIVAS[estado.elegido].nombre);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Primitivas", GLUT_DOUBLE | GLUT_MULTISAMPLE);
    estado.programa = creaPrograma("ch02_modelado/sin_interpolar.vert", "ch02_modelado/sin_interpolar.frag");
    creaVerticesColor(VERTICES);
    glEnable(GL_PROGRAM_POINT_SIZE);
    glutDisplayFunc(dibuja);
    glutReshapeFunc([](int, int) { glutPostRedisplay(); }); // cada panel pone su glViewport
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
