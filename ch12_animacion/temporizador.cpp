// Eventos de tiempo (§12.2): tres glutTimerFunc a la vez, cada uno con su periodo. Uno que se vuelve a pedir para
// dentro de un periodo se retrasa un poco cada vez; aquí se pide lo que falta para el siguiente múltiplo, y el retraso
// no se acumula.
// Controles: espacio pausa · Esc termina.
#include "animacion.h"
#include "proyeccion.h"
#include "trazo.h"
#include <algorithm>
#include <cmath>

static const struct {
    int periodo; // ms
    glm::vec3 color;
} TEMPORIZADORES[] = {{250, ROJO}, {400, VERDE}, {1000, AZUL}};
static const double VENTANA = 3; // segundos que se ven

static struct {
    Reloj reloj;
    int disparos[3];
} estado;

static void dispara(int cual) {
    const double periodo = TEMPORIZADORES[cual].periodo, ahora = 1000 * tiempo(estado.reloj);
    if (ahora > (estado.disparos[cual] + 1) * periodo - 0.5) {
        ++estado.disparos[cual];
        glutPostRedisplay();
    }
    // en pausa se vuelve a mirar al cabo de un cuadro
    const double falta =
        estado.reloj.parado < 0 ? (estado.disparos[cual] + 1) * periodo - ahora : PERIODO_CUADRO;
    glutTimerFunc(unsigned(std::max(1L, std::lround(falta))), dispara, cual);
}

static void dibuja() {
    const glm::mat4 proyeccion = paralelaVentana(1);
    const double t = tiempo(estado.reloj), desde = std::max(0.0, t - VENTANA);
    const auto x = [&](double s) { return float(-0.42 + 1.62 * (s - desde) / VENTANA); };
    glClear(GL_COLOR_BUFFER_BIT);
    trazaSegmentos({{x(t), -0.7f, 0}, {x(t), 0.85f, 0}}, proyeccion, NARANJA, GROSOR / 2); // ahora
    for (int i = 0; i < 3; ++i) {
        const auto &temporizador = TEMPORIZADORES[i];
        const double periodo = temporizador.periodo / 1000.0;
        const float y = 0.6f - 0.55f * float(i);
        trazaSegmentos({{x(desde), y, 0}, {x(desde + VENTANA), y, 0}}, proyeccion, GRIS);
        std::vector<glm::vec3> marcas, previstas; // los disparos, y los que faltan
        for (int n = std::max(1, int(std::ceil(desde / periodo))); n * periodo <= desde + VENTANA; ++n)
            (n <= estado.disparos[i] ? marcas : previstas).push_back({x(n * periodo), y, 0});
        trazaPuntos(previstas, proyeccion, GRIS, 20);
        trazaPuntos(marcas, proyeccion, temporizador.color, 30);
        rotulaPunto(std::to_string(estado.disparos[i]), {-0.88f, y + 0.04f, 0}, proyeccion,
                    temporizador.color, Lado::CENTRO, 0.12f);
        rotulaPunto(std::to_string(temporizador.periodo) + " ms", {-0.88f, y - 0.17f, 0}, proyeccion, OSCURO,
                    Lado::CENTRO);
    }
    rotulaTiempo(estado.reloj, OSCURO);
    tituloAnimado(estado.reloj, "Temporizadores: " + std::to_string(estado.disparos[0]) + ", " +
                                    std::to_string(estado.disparos[1]) + " y " +
                                    std::to_string(estado.disparos[2]) + " disparos");
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (tecla == ' ') // no s ni h: un temporizador no dispara por un tiempo que no ha pasado
        teclaAnimacion(estado.reloj, tecla);
    else
        teclaComun(tecla);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Temporizadores", GLUT_DOUBLE | GLUT_MULTISAMPLE);
    ponFondo(FONDO_CLARO);
    glutDisplayFunc(dibuja);
    for (int i = 0; i < 3; ++i)
        dispara(i);
    animaConReloj(estado.reloj);
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
