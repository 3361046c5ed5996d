// La curva de Hermite (ecuaciones 11.5 a 11.11): sus extremos P1 y P4 y sus tangentes R1 y R4. Con un segundo tramo unido con
// continuidad G1: empieza en P4 y con una tangente paralela a R4 (ejercicio 11.6). Y con una transformación T: transformar
// los puntos de la curva (puntos) o sus cuatro restricciones (línea) da lo mismo.
// Controles: arrastra puntos y puntas de flecha (o n y flechas) · g segundo tramo · + - su tangente ·
// t transforma · Esc termina.
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "curvas.h"
#include "editor.h"
#include "rotulo.h"
#include "trazo.h"

static const float FACTOR_K = 1.25f, K_MINIMA = 0.2f, K_MAXIMA = 3;
static const int PUNTOS_T = 16; // que se transforman de la curva

enum { P1, P4, PUNTA1, PUNTA4, FIN, PUNTA_FIN }; // los puntos que se arrastran
static struct {
    std::vector<glm::vec3> puntos = {{-0.98f, -0.62f, 0}, {0.30f, 0.22f, 0}, {-0.72f, 0.72f, 0},
                                     {1.00f, -0.66f, 0},  {1.75f, 0.55f, 0}, {1.95f, 1.0f, 0}};
    float k = 0.5f; // lo que mide la tangente del segundo tramo, en veces R4
    bool segundo = false, transforma = false;
} estado;

static glm::mat4 vista() {
    return estado.segundo ? paralelaVentana(1.38f) * traslacion({-0.46f, -0.12f, 0}) : paralelaVentana(1);
}

static Geometria<float> primero() {
    const auto &p = estado.puntos;
    return {p[P1], p[P4], p[PUNTA1] - p[P1], p[PUNTA4] - p[P4]};
}

/// Las restricciones transformadas: los puntos con w = 1 y las tangentes, que son vectores, con w = 0.
static Geometria<float> transformada(const glm::mat4 &T, const Geometria<float> &G) {
    return {T * glm::vec4(G[0], 1), T * glm::vec4(G[1], 1), T * glm::vec4(G[2], 0), T * glm::vec4(G[3], 0)};
}

/// La curva con sus extremos, sus tangentes y sus nombres.
static void dibujaTramo(const Geometria<float> &G, const glm::vec3 &color, const char *const nombres[4]) {
    trazaPolilinea(polilineaCubica(Base::HERMITE, G, 0.2 / static_cast<double>(altoUtil())), vista(), color,
                   1.7f * GROSOR);
    for (std::size_t i = 0; i < 2; ++i) {
        trazaFlecha(G[i], G[i] + G[i + 2], vista(), i == 0 ? VERDE : NARANJA);
        rotulaPunto(nombres[i + 2], G[i] + G[i + 2], vista(), OSCURO, Lado::DERECHA);
    }
    trazaPuntos({G[0], G[1]}, vista(), OSCURO, 4 * GROSOR);
    rotulaPunto(nombres[0], G[0], vista(), OSCURO, Lado::DEBAJO);
    rotulaPunto(nombres[1], G[1], vista(), OSCURO, Lado::IZQUIERDA);
}

static void dibuja() {
    static const char *const NOMBRES[] = {"P1", "P4", "R1", "R4"};
    glClear(GL_COLOR_BUFFER_BIT);
    const Geometria<float> G = primero();
    std::string titulo = "Curva de Hermite";
    if (estado.segundo) {
        static const char *const NOMBRES2[] = {"", "P4'", "k·R4", "R4'"};
        const auto &p = estado.puntos;
        char k[40];
        std::snprintf(k, sizeof k, ": dos tramos G1, k = %.2f", static_cast<double>(estado.k));
        titulo += k;
        dibujaTramo(G, AZUL, NOMBRES);
        dibujaTramo({G[1], p[FIN], estado.k * G[3], p[PUNTA_FIN] - p[FIN]}, MORADO, NOMBRES2);
    } else if (estado.transforma) {
        const glm::mat4 T = traslacion({0.28f, 0.28f, 0}) * giroZ(-0.5f) * escalado({0.75f, 0.6f, 1});
        std::vector<glm::vec3> transformados;
        for (const glm::vec3 &p : polilinea([&](float u) { return cubica(Base::HERMITE, G, u); }, PUNTOS_T))
            transformados.push_back(T * glm::vec4(p, 1));
        trazaPolilinea(polilineaCubica(Base::HERMITE, G, 0.2 / static_cast<double>(altoUtil())), vista(),
                       GRIS);
        dibujaTramo(transformada(T, G), AZUL, NOMBRES);
        trazaPuntos(transformados, vista(), ROJO);
        titulo += ": transformar las restricciones o los puntos";
    } else
        dibujaTramo(G, AZUL, NOMBRES);
    ponTitulo(titulo);
    glutSwapBuffers();
}

/// La punta de la flecha acompaña a su punto: la tangente no cambia.
static void alMover(std::size_t i, const glm::vec3 &cuanto) {
    if (i == P1 || i == P4)
        estado.puntos[i + 2] += cuanto;
    if (i == FIN)
        estado.puntos[PUNTA_FIN] += cuanto;
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || teclaEditor(tecla))
        return;
    switch (tecla) {
    case 'g':
        estado.segundo = !estado.segundo;
        estado.transforma = false;
        break;
    case 't':
        estado.transforma = !estado.transforma;
        estado.segundo = false;
        break;
    case '+':
    case '-':
        estado.k = glm::clamp(estado.k * (tecla == '+' ? FACTOR_K : 1 / FACTOR_K), K_MINIMA, K_MAXIMA);
        break;
    default: return;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Curva de Hermite", GLUT_DOUBLE | GLUT_MULTISAMPLE);
    glClearColor(FONDO_CLARO.r, FONDO_CLARO.g, FONDO_CLARO.b, 1);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    editaConRaton({&estado.puntos, vista, alMover});
    glutMainLoop();
    return 0;
}
