// Curvas de Bézier de cualquier grado (ecuaciones 11.20 a 11.22): con n + 1 puntos, grado n. Abajo, los polinomios de
// Bernstein b_{k,n}(u), que en cada u suman 1: lo que pesa cada punto, del color del punto. Con muchos puntos cada uno
// manda menos y la curva se aleja de ellos. Los coeficientes binomiales no se calculan con factoriales, que se
// desbordan: los da la recurrencia de los polinomios (curvas.h).
// Controles: + - un punto más o menos · 1 2 3 4 dan 4, 10, 40 y 61 puntos · Esc termina.
#include "colores.h"
#include "curvas.h"
#include "escenas_curvas.h"
#include "modos.h"
#include "recuadro.h"
#include "rotulo.h"
#include "trazo.h"
#include "ventana.h"

static const std::size_t PUNTOS[] = {4, 10, 40, 61}, MINIMO = 2, MAXIMO = 61;

static struct {
    std::size_t n = 4; // puntos de control
} estado;

// Del primero al último, de azul a rojo pasando por el naranja.
static glm::vec3 colorDe(std::size_t i) {
    const float t = 2 * float(i) / float(estado.n - 1);
    return t < 1 ? glm::mix(AZUL, NARANJA, t) : glm::mix(NARANJA, ROJO, t - 1);
}

// Lo que mide un píxel en los paneles, que no tienen más de una unidad de lado.
static double pixel(const Recuadro &panel) {
    return 1.0 / std::max({panel.ancho, panel.alto, 1});
}

static void dibujaCurva(const Recuadro &panel) {
    abreRecuadro(panel);
    ponFondo(FONDO_CLARO);
    glClear(GL_COLOR_BUFFER_BIT);
    // a lo ancho del panel, como los polinomios de abajo
    const glm::mat4 vista(1.7f, 0, 0, 0, 0, 0.9f, 0, 0, 0, 0, 1, 0, -0.85f, 0, 0, 1);
    const std::vector<glm::vec3> P = puntosZigzag(estado.n);
    trazaPolilinea(P, vista, GRIS, 0.5f * GROSOR);
    trazaPolilinea(polilineaBezier(P, 0.2 * pixel(panel)), vista, AZUL, 1.7f * GROSOR);
    for (std::size_t i = 0; i < estado.n; ++i)
        trazaPuntos({P[i]}, vista, colorDe(i), 3 * GROSOR);
    rotulaPunto("P0", P.front(), vista, OSCURO, Lado::DEBAJO);
    rotulaPunto("P" + std::to_string(estado.n - 1), P.back(), vista, OSCURO, Lado::ENCIMA);
}

static void dibujaBernstein(const Recuadro &panel) {
    abreRecuadro(panel);
    ponFondo(FONDO_CLARO);
    glClear(GL_COLOR_BUFFER_BIT);
    // u de 0 a 1 en horizontal y b de 0 a 1 en vertical, con un margen
    const glm::mat4 vista = glm::mat4(1.7f, 0, 0, 0, 0, 1.4f, 0, 0, 0, 0, 1, 0, -0.85f, -0.6f, 0, 1);
    trazaPolilinea({{0, 1, 0}, {0, 0, 0}, {1, 0, 0}}, vista, OSCURO, 0.6f * GROSOR);
    // la gráfica de b_{k,n} es la curva de Bézier de los puntos (i/n, 0), con el k subido a 1
    for (std::size_t k = 0; k < estado.n; ++k) {
        std::vector<glm::vec3> P;
        for (std::size_t i = 0; i < estado.n; ++i)
            P.push_back({float(i) / float(estado.n - 1), i == k ? 1 : 0, 0});
        trazaPolilinea(polilineaBezier(P, 0.2 * pixel(panel)), vista, colorDe(k), 0.8f * GROSOR);
    }
    rotulaPunto("0", {0, 0, 0}, vista, OSCURO, Lado::DEBAJO);
    rotulaPunto("u", {0.5f, 0, 0}, vista, OSCURO, Lado::DEBAJO);
    rotulaPunto("1", {1, 0, 0}, vista, OSCURO, Lado::DEBAJO);
    rotulaPunto("1", {0, 1, 0}, vista, OSCURO, Lado::IZQUIERDA);
}

static void dibuja() {
    const std::vector<Recuadro> paneles = rejilla(1, 2);
    abreRecuadro(ventanaEntera());
    ponFondo(GRIS);
    glClear(GL_COLOR_BUFFER_BIT);
    dibujaCurva(paneles[0]);
    dibujaBernstein(paneles[1]);
    ponTitulo("Bézier de grado " + std::to_string(estado.n - 1) + ": " + std::to_string(estado.n) +
              " puntos");
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    if (int i; eligeModo(i, 4, tecla))
        estado.n = PUNTOS[i];
    else if (tecla == '+')
        estado.n = std::min(estado.n + 1, MAXIMO);
    else if (tecla == '-')
        estado.n = std::max(estado.n - 1, MINIMO);
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Bézier de grado n", GLUT_DOUBLE | GLUT_MULTISAMPLE);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
