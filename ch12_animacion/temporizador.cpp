// Eventos de tiempo (§12.2): tres glutTimerFunc a la vez, cada uno con su periodo. Si la función vuelve a pedirse para
// dentro de un periodo, como dice el libro (tecla l), cada retraso se suma al anterior; aquí se pide lo que falta para
// el siguiente múltiplo, y no se acumula. Se ve con un programa ocupado, al que cada aviso le llega tarde: se hace como
// si se pidiera RETRASO más tarde (tecla o).
// Controles: l como el libro o sin acumular · o ocupado o no · espacio pausa · Esc termina.
#include "animacion.h"
#include "colores.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "reloj.h"
#include "rotulo.h"
#include "trazo.h"
#include "ventana.h"
#include <algorithm>
#include <cmath>

static const struct {
    int periodo; // ms
    glm::vec3 color;
} TEMPORIZADORES[] = {{250, ROJO}, {400, VERDE}, {1000, AZUL}};
static const double VENTANA = 3; // segundos que se ven
static const int RETRASO = 60;   // ms

static struct {
    Reloj reloj;
    bool comoElLibro = false, ocupado = false;
    double siguiente[3];             // ms
    std::vector<double> disparos[3]; // cuándo, en segundos
} estado;

static void dispara(int cual) {
    const double periodo = TEMPORIZADORES[cual].periodo, ahora = 1000 * tiempo(estado.reloj);
    double &siguiente = estado.siguiente[cual];
    if (ahora > siguiente - 0.5) {
        estado.disparos[cual].push_back(ahora / 1000);
        const double multiplo = std::floor((ahora + 0.5) / periodo + 1) * periodo;
        siguiente = estado.comoElLibro ? ahora + periodo : multiplo;
        glutPostRedisplay();
    }
    double falta = siguiente - ahora + (estado.ocupado ? RETRASO : 0);
    if (estado.reloj.parado >= 0) // en pausa se vuelve a mirar al cabo de un cuadro
        falta = PERIODO_CUADRO;
    glutTimerFunc(unsigned(std::max(1L, std::lround(falta))), dispara, cual);
}

static void dibuja() {
    const glm::mat4 proyeccion = paralelaVentana(1);
    const double t = tiempo(estado.reloj);
    const double desde = std::max(0.0, t - VENTANA);
    const auto x = [&](double s) { return float(-0.42 + 1.62 * (s - desde) / VENTANA); };
    glClear(GL_COLOR_BUFFER_BIT);
    trazaSegmentos({{x(t), -0.7f, 0}, {x(t), 0.85f, 0}}, proyeccion, NARANJA, GROSOR / 2); // ahora
    for (int i = 0; i < 3; ++i) {
        const auto &temporizador = TEMPORIZADORES[i];
        const double periodo = temporizador.periodo / 1000.0;
        const float y = 0.6f - 0.55f * float(i);
        trazaSegmentos({{x(desde), y, 0}, {x(desde + VENTANA), y, 0}}, proyeccion, GRIS);
        std::vector<glm::vec3> marcas, previstas; // los disparos, y una raya donde tocan
        for (int n = std::max(1, int(std::ceil(desde / periodo))); n * periodo <= desde + VENTANA; ++n)
            previstas.insert(previstas.end(),
                             {{x(n * periodo), y - 0.07f, 0}, {x(n * periodo), y + 0.07f, 0}});
        for (const double s : estado.disparos[i])
            if (s >= desde)
                marcas.push_back({x(s), y, 0});
        trazaSegmentos(previstas, proyeccion, GRIS);
        trazaPuntos(marcas, proyeccion, temporizador.color, 30);
        rotulaPunto(std::to_string(estado.disparos[i].size()), {-0.88f, y + 0.04f, 0}, proyeccion,
                    temporizador.color, Lado::CENTRO, 0.12f);
        rotulaPunto(std::to_string(temporizador.periodo) + " ms", {-0.88f, y - 0.17f, 0}, proyeccion, OSCURO,
                    Lado::CENTRO);
    }
    const std::string como =
        std::string(estado.ocupado ? ", ocupado" : "") + (estado.comoElLibro ? ", libro" : "");
    rotulaTiempo(estado.reloj, OSCURO, como);
    tituloAnimado(estado.reloj, "Temporizadores: " + std::to_string(estado.disparos[0].size()) + ", " +
                                    std::to_string(estado.disparos[1].size()) + " y " +
                                    std::to_string(estado.disparos[2].size()) + " disparos" +
                                    (estado.comoElLibro ? ", como el libro" : "") +
                                    (estado.ocupado ? ", ocupado" : ""));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    switch (tecla) { // ni s ni h: un temporizador no dispara por un tiempo que no ha pasado
    case ' ': teclaAnimacion(estado.reloj, tecla); break;
    case 'l': estado.comoElLibro = !estado.comoElLibro; break;
    case 'o': estado.ocupado = !estado.ocupado; break;
    default: teclaComun(tecla); return;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Temporizadores", GLUT_DOUBLE | GLUT_MULTISAMPLE);
    ponFondo(FONDO_CLARO);
    glutDisplayFunc(dibuja);
    for (int i = 0; i < 3; ++i) {
        estado.siguiente[i] = TEMPORIZADORES[i].periodo;
        dispara(i);
    }
    animaConReloj(estado.reloj);
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
