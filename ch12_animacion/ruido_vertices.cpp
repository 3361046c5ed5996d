// Vértices desplazados por una textura de ruido y el tiempo (listado 12.1): cada vértice lee sus tres componentes. El
// listado las suma tal cual, de 0 a 1, y el objeto, además de ondular, se va de su sitio: restándoles antes ½ se queda.
// Los círculos son los del toro sin desplazar. El tiempo llega al shader reducido a su periodo: a las 100 horas ondula
// igual de suave. La textura es periódica y en cada vuelta del toro cabe S1 veces, entera: no hay costura.
// Controles: 1 centrado · 2 como el listado · v los dos · + - amplitud S2 · espacio pausa · s adelanta medio segundo ·
// d una décima · h diez horas · ratón orbita · Esc termina.
#include "animacion.h"
#include "buferes.h"
#include "colores.h"
#include "imagen_ruido.h"
#include "malla.h"
#include "modos.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "reloj.h"
#include "rotulo.h"
#include "shader.h"
#include "texto.h"
#include "textura.h"
#include "trazo.h"
#include "ventana.h"
#include <algorithm>
#include <glm/gtc/constants.hpp>

static const double PERIODO = 5; // segundos
static const float S1 = 2, PASO_S2 = 0.1f, S2_MAXIMA = 0.8f;
static const float RADIO = 1, RADIO_TUBO = 0.42f; // el del tubo, como en ruido_vertices.vert
static const struct {
    const char *nombre;
    float centro;
} MODOS[] = {{"centrado", 0.5f}, {"listado 12.1", 0}};

static struct {
    GLuint programa, textura;
    Buferes toro;
    Modos modos = {2};
    float S2 = 0.3f;
    Orbita orbita = {-0.3f, 0.35f, 10};
    Reloj reloj;
} estado;

static void dibujaModo(int cual, const Recuadro &r) {
    const glm::mat4 camara = camaraOrbita(estado.orbita),
                    proyeccion = estado.modos.todos ? perspectivaVentana(0.51f, 1, 50, aspecto(r), 0.8)
                                                    : perspectivaVentana(0.4f, 1, 50);
    abreRecuadro(r);
    ponFondo(FONDO_CLARO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    usaPrograma(estado.programa, camara, proyeccion);
    envia(estado.programa, "M", glm::mat4(1));
    envia(estado.programa, "colorObjeto", cual == 0 ? VERDE : NARANJA);
    envia(estado.programa, "tiempo", fase(tiempo(estado.reloj), PERIODO));
    envia(estado.programa, "S1", S1);
    envia(estado.programa, "S2", estado.S2);
    envia(estado.programa, "centro", MODOS[cual].centro);
    envia(estado.programa, "ruido", 0);
    dibujaMalla(estado.toro);

    glDisable(GL_DEPTH_TEST);
    for (const float radio : {RADIO - RADIO_TUBO, RADIO + RADIO_TUBO})
        trazaPolilinea(circunferencia(radio, 90), proyeccion * camara, OSCURO, GROSOR / 2, true);
    glEnable(GL_DEPTH_TEST);
    rotula(MODOS[cual].nombre, {0.5f, 0.95f}, OSCURO);
    rotulaTiempo(estado.reloj, OSCURO, formatea("%sS2 = %.1f", estado.modos.todos ? "\n" : ", ", estado.S2));
}

static void dibuja() {
    dibujaModos(estado.modos, dibujaModo);
    tituloAnimado(estado.reloj,
                  formatea("Vértices desplazados por ruido: %s, S2 = %.1f",
                           estado.modos.todos ? "los dos" : MODOS[estado.modos.elegido].nombre, estado.S2));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaAnimacion(estado.reloj, tecla) || teclaModos(estado.modos, tecla))
        return;
    switch (tecla) {
    case '+': estado.S2 = std::min(estado.S2 + PASO_S2, S2_MAXIMA); break;
    case '-': estado.S2 = std::max(estado.S2 - PASO_S2, 0.0f); break;
    default: return;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Vértices desplazados por ruido", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    estado.programa = creaPrograma("ch12_animacion/ruido_vertices.vert", "ch03_transformaciones/objeto.frag");
    estado.toro = creaBuferes(toro(RADIO, RADIO_TUBO, 128, 64));
    estado.textura = creaTextura2D(imagenRuido());
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(dibuja);
    orbitaConRaton(estado.orbita);
    animaConReloj(estado.reloj);
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
