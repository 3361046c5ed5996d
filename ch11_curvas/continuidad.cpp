// La continuidad en la unión de dos tramos (§11.1.2, ejercicio 11.5): un coche los recorre con el parámetro u
// proporcional al tiempo, y con él una cámara. Debajo, el módulo de su velocidad, |Q'|, y el de su aceleración, |Q''|:
// con C0 salta hasta la dirección; con G1, el módulo de la velocidad; con C1, la aceleración; con C2, nada.
// Controles: 1 C0 · 2 G1 · 3 C1 · 4 C2 · v los cuatro · t o espacio anda o para · Esc termina.
#include "continuidad.h"
#include "colores.h"
#include "modos.h"
#include "recuadro.h"
#include "rotulo.h"
#include "texto.h"
#include "trazo.h"
#include "ventana.h"
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

static const char *const NOMBRES[CONTINUIDADES] = {"C0", "G1", "C1", "C2"};
static const int CADA = 16;     // milisegundos de una imagen a la siguiente
static const int MUESTRAS = 48; // de cada tramo
static const int MONTES = 16;
static const float ALTURA_OJO = 0.07f, MEDIA_CARRETERA = 0.05f, TALLA_EJES = 0.032f;

static struct {
    Modos modos{4, C0, true};
    bool anda = false;
    int recorridos = AL_EMPEZAR, desde = 0; // milisegundos andados y reloj al arrancar
} estado;

static float parametro() {
    const int t = estado.recorridos + (estado.anda ? glutGet(GLUT_ELAPSED_TIME) - estado.desde : 0);
    return 2 * float(t % PERIODO) / float(PERIODO);
}

// Proyección paralela que abarca en el panel [−semiancho, semiancho]×[−semialto, semialto], como poco, desde un
// centro.
static glm::mat4 abarca(const Recuadro &panel, float semiancho, float semialto, const glm::vec3 &centro) {
    const float y = std::max(semialto, semiancho / aspecto(panel));
    const float x = y * aspecto(panel);
    return glm::translate(glm::ortho(-x, x, -y, y), -centro);
}

// La trayectoria desde arriba, con el coche y su velocidad.
static void dibujaPlano(const Recuadro &panel, Continuidad c) {
    abreRecuadro(panel);
    ponFondo(FONDO_CLARO);
    glClear(GL_COLOR_BUFFER_BIT);
    const glm::mat4 vista = abarca(panel, 1.3f, 0.7f, {0, 0.22f, 0});
    const double tolerancia = 0.4 / std::max(panel.alto, 1);
    trazaPolilinea(polilineaCubica(Base::HERMITE, PRIMER_TRAMO, tolerancia), vista, AZUL, 1.7f * GROSOR);
    trazaPolilinea(polilineaCubica(Base::HERMITE, segundoTramo(c), tolerancia), vista, MORADO, 1.7f * GROSOR);
    trazaPuntos({PRIMER_TRAMO[1]}, vista, OSCURO, 3 * GROSOR);
    const float u = parametro();
    const glm::vec3 Q = recorrido(c, u), velocidad = recorrido(c, u, 1);
    const glm::vec3 F = glm::normalize(velocidad);
    const glm::vec3 L(-F.y, F.x, 0);
    trazaFlecha(Q, Q + VELOCIDAD * velocidad, vista, VERDE);
    trazaPoligono({Q + 0.10f * F, Q - 0.08f * F + 0.07f * L, Q - 0.08f * F - 0.07f * L}, vista, NARANJA);
    rotula(NOMBRES[c], {0.12f, 0.2f}, OSCURO, Lado::CENTRO, 1.3f * TALLA_ROTULO);
}

// El módulo de una derivada a lo largo de los dos tramos: el salto de la unión, u = 1, queda entre uno y otro.
static void dibujaGrafica(const Recuadro &panel, Continuidad c, int derivada) {
    abreRecuadro(panel);
    ponFondo(FONDO_CLARO);
    glClear(GL_COLOR_BUFFER_BIT);
    const float maxima = derivada == 1 ? RAPIDEZ_MAXIMA : ACELERACION_MAXIMA, u = parametro();
    const glm::vec3 color = derivada == 1 ? VERDE : ROJO;
    // de 0 a 2 en horizontal y de 0 a la máxima en vertical
    const glm::mat4 vista(0.78f, 0, 0, 0, 0, 1.45f / maxima, 0, 0, 0, 0, 1, 0, -0.86f, -0.75f, 0, 1);
    trazaSegmentos({{u, 0, 0}, {u, maxima, 0}}, vista, GRIS, 0.6f * GROSOR);
    trazaPolilinea({{0, maxima, 0}, {0, 0, 0}, {2, 0, 0}}, vista, OSCURO, 0.6f * GROSOR);
    trazaPuntos({{1, 0, 0}}, vista, OSCURO);
    glm::vec3 junto[2];
    for (int tramo = 0; tramo < 2; ++tramo) {
        const Geometria<float> G = tramo == 0 ? PRIMER_TRAMO : segundoTramo(c);
        const auto altura = [&](float t) {
            return glm::vec3(t + float(tramo), glm::length(cubica(Base::HERMITE, G, t, derivada)), 0);
        };
        trazaPolilinea(polilinea(altura, MUESTRAS), vista, color, 1.3f * GROSOR);
        junto[tramo] = altura(tramo == 0 ? 1.0f : 0.0f);
    }
    if (glm::distance(junto[0], junto[1]) > 0.01f)
        trazaPuntos({junto[0], junto[1]}, vista, color);
    rotulaPunto(derivada == 1 ? "|Q'|" : "|Q''|", {0, maxima, 0}, vista, color, Lado::DERECHA, TALLA_EJES);
    rotulaPunto("u", {2, 0, 0}, vista, OSCURO, Lado::DERECHA, TALLA_EJES);
}

// Lo que se ve desde el coche: un suelo cuadriculado, con montes al fondo, y la carretera. Los saltos de la velocidad
// y de la aceleración se notan cuando anda.
static void dibujaVista(const Recuadro &panel, Continuidad c) {
    abreRecuadro(panel);
    ponFondo(CIELO);
    glClear(GL_COLOR_BUFFER_BIT);
    const float u = parametro();
    const glm::vec3 ojo = recorrido(c, u) + glm::vec3(0, 0, ALTURA_OJO);
    const glm::mat4 vista = glm::perspective(1.0f, aspecto(panel), 0.05f, 100.0f) *
                            glm::lookAt(ojo, ojo + recorrido(c, u, 1), {0, 0, 1});
    for (int i = 0; i < MONTES; ++i) {
        const auto en = [&](float k, float alto) {
            const float a = glm::two_pi<float>() * (float(i) + k) / MONTES;
            return glm::vec3(20 * std::cos(a), 20 * std::sin(a), alto);
        };
        trazaPoligono({en(-0.6f, 0), en(0.6f, 0), en(0, 1.5f + float(i * 5 % 7) * 0.5f)}, vista,
                      glm::mix(CIELO, AZUL, 0.2f + 0.1f * float(i % 3)));
    }
    trazaPoligono({{-1, -1, 0}, {1, -1, 0}, {1, 0, 0}, {-1, 0, 0}}, glm::mat4(1), SUELO);
    trazaSegmentos(cuadricula(4, 0.25f), vista, glm::mix(SUELO, BLANCO, 0.45f), 0.5f * GROSOR);
    for (const int tramo : {1, 0}) // lo de lejos, antes
        for (int i = MUESTRAS - 1; i >= 0; --i) {
            const Geometria<float> G = tramo == 0 ? PRIMER_TRAMO : segundoTramo(c);
            const auto borde = [&](int k, float lado) {
                const float t = float(k) / MUESTRAS;
                const glm::vec3 F = glm::normalize(cubica(Base::HERMITE, G, t, 1));
                return cubica(Base::HERMITE, G, t) + lado * MEDIA_CARRETERA * glm::vec3(-F.y, F.x, 0);
            };
            trazaPoligono({borde(i, -1), borde(i, 1), borde(i + 1, 1), borde(i + 1, -1)}, vista,
                          glm::mix(tramo == 0 ? AZUL : MORADO, BLANCO, i % 4 < 2 ? 0.0f : 0.2f));
        }
    rotula("desde el coche", {0.5f, 0.9f}, OSCURO, Lado::CENTRO, TALLA_EJES);
}

static void dibuja() {
    abreRecuadro(ventanaEntera());
    ponFondo(GRIS);
    glClear(GL_COLOR_BUFFER_BIT);
    if (estado.modos.todos) { // una en cada fila
        const std::vector<Recuadro> celdas = rejilla(3, CONTINUIDADES);
        for (int c = 0; c < CONTINUIDADES; ++c) {
            dibujaPlano(celdas[3 * c], Continuidad(c));
            for (const int derivada : {1, 2})
                dibujaGrafica(celdas[3 * c + derivada], Continuidad(c), derivada);
        }
    } else {
        const Continuidad c = Continuidad(estado.modos.elegido);
        const std::vector<Recuadro> celdas = rejilla(2, 2);
        dibujaPlano(celdas[0], c);
        dibujaVista(celdas[1], c);
        for (const int derivada : {1, 2})
            dibujaGrafica(celdas[1 + derivada], c, derivada);
    }
    ponTitulo(formatea("Continuidad: %s, u = %.2f",
                       estado.modos.todos ? "las cuatro" : NOMBRES[estado.modos.elegido], parametro()));
    glutSwapBuffers();
}

static void avanza(int) {
    if (estado.anda)
        glutPostRedisplay();
    glutTimerFunc(CADA, avanza, 0);
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || teclaModos(estado.modos, tecla))
        return;
    if (tecla == 't' || tecla == ' ') {
        const int ahora = glutGet(GLUT_ELAPSED_TIME);
        if (estado.anda)
            estado.recorridos = (estado.recorridos + ahora - estado.desde) % PERIODO;
        estado.desde = ahora;
        estado.anda = !estado.anda;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Continuidad", GLUT_DOUBLE | GLUT_MULTISAMPLE);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutTimerFunc(CADA, avanza, 0);
    glutMainLoop();
    return 0;
}
