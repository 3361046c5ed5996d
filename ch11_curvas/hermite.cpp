// La curva de Hermite (ecuaciones 11.5 a 11.11): sus extremos P1 y P4 y sus tangentes R1 y R4. Con un segundo tramo
// unido con continuidad G1: empieza en P4 y con una tangente paralela a R4 (ejercicio 11.6). Y con una transformación
// T: transformar los puntos de la curva (puntos) o sus cuatro restricciones (línea) da lo mismo.
// Controles: arrastra puntos y puntas de flecha (o n y flechas) · g segundo tramo · + - su tangente ·
// t transforma · Esc termina.
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "curvas.h"
#include "editor.h"
#include "escenas_curvas.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "texto.h"
#include "trazo.h"
#include "ventana.h"

static const float PASO_K = 0.1f, K_MINIMA = 0.2f, K_MAXIMA = 1.5f;
static const int PUNTOS_T = 16; // que se transforman de la curva

enum { P1, P4, PUNTA1, PUNTA4, FIN, PUNTA_FIN, NINGUNO }; // los puntos que se arrastran

static struct {
    std::vector<glm::vec3> puntos = PUNTOS_HERMITE;
    float k = K_HERMITE;
    bool segundo = false, transforma = false;
    Editor editor;
} estado;

static glm::mat4 vista() {
    return estado.segundo ? paralelaVentana(1.38f) * traslacion({-0.55f, -0.12f, 0}) : paralelaVentana(1);
}

static Geometria<float> primero() {
    const auto &p = estado.puntos;
    // E11.6: el vector de geometría: los extremos y las tangentes, que van de cada extremo a la punta de su flecha
    return {p[P1], p[P4], p[PUNTA1] - p[P1], p[PUNTA4] - p[P4]};
    // de partida: return {p[P1], p[P4], glm::vec3(0), glm::vec3(0)};
    // fin de E11.6
}

// Las restricciones transformadas.
static Geometria<float> transformada(const glm::mat4 &T, const Geometria<float> &G) {
    // E11.6: las cuatro restricciones transformadas con T
    // los puntos con w = 1 y las tangentes, que son vectores, con w = 0
    return {T * glm::vec4(G[0], 1), T * glm::vec4(G[1], 1), T * glm::vec4(G[2], 0), T * glm::vec4(G[3], 0)};
    // de partida: return {T * glm::vec4(G[0], 1), G[1], G[2], G[3]};
    // fin de E11.6
}

struct Nombre {
    const char *texto;
    std::size_t punto; // el que se arrastra
};

// La curva con sus extremos, sus tangentes y sus nombres.
static void dibujaTramo(const Geometria<float> &G, const glm::vec3 &color, const Nombre nombres[4],
                        const glm::vec3 &color1 = VERDE, const glm::vec3 &color4 = NARANJA) {
    // el nombre del final, al otro lado de su flecha
    const glm::vec3 final = G[1] + glm::vec3(0, G[3].y < 0 ? 0.05f : -0.05f, 0);
    trazaPolilinea(polilineaCubica(Base::HERMITE, G, 0.2 / altoUtil()), vista(), color, 1.7f * GROSOR);
    trazaFlecha(G[0], G[0] + G[2], vista(), color1);
    trazaFlecha(G[1], G[1] + G[3], vista(), color4);
    trazaPuntos({G[0], G[1]}, vista(), OSCURO, 4 * GROSOR);
    const glm::vec3 sitios[] = {G[0], final, G[0] + G[2], G[1] + G[3]};
    for (std::size_t i = 0; i < 4; ++i)
        rotulaPunto(nombres[i].texto, sitios[i], vista(), colorNombre(estado.editor, nombres[i].punto),
                    i == 0 ? Lado::DEBAJO : Lado::DERECHA);
}

static void dibuja() {
    static const Nombre NOMBRES[] = {{"P1", P1}, {"P4", P4}, {"R1", PUNTA1}, {"R4", PUNTA4}},
                        SIN_NOMBRE[] = {{"", P1}, {"", P4}, {"", PUNTA1}, {"", PUNTA4}};
    glClear(GL_COLOR_BUFFER_BIT);
    const Geometria<float> G = primero();
    std::string titulo = "Curva de Hermite";
    if (estado.segundo) {
        const auto &p = estado.puntos;
        titulo += formatea(": dos tramos G1, k = %.2f", estado.k);
        dibujaTramo(G, AZUL, NOMBRES);
        // E11.6: el vector de geometría del segundo tramo, que acaba en P4' con R4' y se une al primero con G1
        const Geometria<float> G2 = {G[1], p[FIN], estado.k * G[3], p[PUNTA_FIN] - p[FIN]};
        // de partida: const Geometria<float> G2 = {p[FIN], p[FIN], glm::vec3(0), glm::vec3(0)};
        // fin de E11.6
        const std::string kR4 = formatea("%.2g·R4", estado.k);
        const Nombre segundos[] = {{"", P4}, {"P4'", FIN}, {kR4.c_str(), NINGUNO}, {"R4'", PUNTA_FIN}};
        dibujaTramo(G2, MORADO, segundos);
    } else if (estado.transforma) {
        const glm::mat4 T = traslacion(T_TRASLACION) * giroZ(T_GIRO) * escalado(T_ESCALADO);
        std::vector<glm::vec3> transformados;
        for (int i = 0; i <= PUNTOS_T; ++i) {
            const glm::vec3 Q = potencias(float(i) / PUNTOS_T) * M_H * enFilas(G); // ecuación 11.11
            transformados.push_back(T * glm::vec4(Q, 1));
        }
        dibujaTramo(G, GRIS, SIN_NOMBRE, GRIS, GRIS);
        dibujaTramo(transformada(T, G), AZUL, NOMBRES);
        trazaPuntos(transformados, vista(), ROJO);
        titulo += ": transformar las restricciones o los puntos";
    } else
        dibujaTramo(G, AZUL, NOMBRES);
    rotulaPunto(filasDe("M_H = ", M_H, 3), {-0.14f, -0.64f, 0}, vista(), OSCURO, Lado::CENTRO,
                0.9f * TALLA_MATRIZ);
    ponTitulo(titulo);
    glutSwapBuffers();
}

// La punta de la flecha acompaña a su punto: la tangente no cambia.
static void alMover(std::size_t i, const glm::vec3 &cuanto) {
    if (i == P1 || i == P4)
        estado.puntos[i + 2] += cuanto;
    if (i == FIN)
        estado.puntos[PUNTA_FIN] += cuanto;
}

// Con el segundo tramo hay dos puntos más que arrastrar.
static void ponSegundo(bool si) {
    estado.segundo = si;
    estado.puntos.resize(FIN);
    if (si)
        estado.puntos.insert(estado.puntos.end(), SEGUNDO_HERMITE.begin(), SEGUNDO_HERMITE.end());
    estado.editor.elegido = -1; // el que se arrastraba puede haberse ido
    estado.editor.arrastrando = false;
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || teclaEditor(estado.editor, tecla))
        return;
    switch (tecla) {
    case 'g':
        ponSegundo(!estado.segundo);
        estado.transforma = false;
        break;
    case 't':
        estado.transforma = !estado.transforma;
        ponSegundo(false);
        break;
    case '+':
    case '-': estado.k = glm::clamp(estado.k + (tecla == '+' ? PASO_K : -PASO_K), K_MINIMA, K_MAXIMA); break;
    default: return;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Curva de Hermite", GLUT_DOUBLE | GLUT_MULTISAMPLE);
    ponFondo(FONDO_CLARO);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    estado.editor = {&estado.puntos, vista, false, alMover};
    editaConRaton(estado.editor);
    glutMainLoop();
    return 0;
}
