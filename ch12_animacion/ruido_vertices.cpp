// Vértices desplazados por un ruido que cambia con el tiempo (listado 12.1). El listado suma el ruido tal cual, de 0 a
// 1, y el objeto, además de ondular, se va de su sitio: restándole antes ½ se queda. El círculo es la esfera sin
// desplazar. El tiempo llega al shader reducido a su periodo: a las 100 horas ondula igual de suave.
// Controles: 1 centrado · 2 como el listado · v los dos · + - amplitud S2 · espacio pausa · s adelanta medio segundo ·
// d una décima · h diez horas · ratón orbita · Esc termina.
#include "animacion.h"
#include "ch03_transformaciones/objeto.h"
#include "orbita.h"
#include "recuadro.h"
#include "trazo.h"
#include <algorithm>
#include <glm/gtc/constants.hpp>

static const double PERIODO = 5; // segundos
static const float S1 = 1.2f, PASO_S2 = 0.1f, S2_MAXIMA = 0.8f;
static const struct {
    const char *nombre;
    float centro;
} MODOS[] = {{"centrado", 0.5f}, {"listado 12.1", 0}};

static struct {
    GLuint programa;
    Buferes esfera;
    int elegido = 0;
    bool ambos = false;
    float S2 = 0.7f;
    Orbita orbita = {0.3f, 0.2f, 10};
    Reloj reloj;
} estado;

static void dibujaModo(const Recuadro &r, int cual) {
    const glm::mat4 camara = camaraOrbita(estado.orbita),
                    proyeccion = perspectivaVentana(aspecto(r) < 1 ? 0.29f : 0.38f, 1, 50, aspecto(r));
    abreRecuadro(r, FONDO_CLARO);
    glUseProgram(estado.programa);
    envia(estado.programa, "camara", camara);
    envia(estado.programa, "proyeccion", proyeccion);
    envia(estado.programa, "M", glm::mat4(1));
    envia(estado.programa, "colorObjeto", cual == 0 ? VERDE : NARANJA);
    envia(estado.programa, "tiempo", fase(tiempo(estado.reloj), PERIODO));
    envia(estado.programa, "S1", S1);
    envia(estado.programa, "S2", estado.S2);
    envia(estado.programa, "centro", MODOS[cual].centro);
    dibuja(estado.esfera);

    glDisable(GL_DEPTH_TEST);
    std::vector<glm::vec3> contorno; // de la esfera sin desplazar, de cara a la cámara
    const glm::mat4 haciaMundo = glm::inverse(camara);
    for (int i = 0; i < 90; ++i) {
        const float a = glm::two_pi<float>() * float(i) / 90;
        contorno.push_back(haciaMundo * glm::vec4(std::cos(a), std::sin(a), -estado.orbita.distancia, 1));
    }
    trazaPolilinea(contorno, proyeccion * camara, OSCURO, GROSOR / 2, true);
    glEnable(GL_DEPTH_TEST);
    rotula(MODOS[cual].nombre, {0.5f, 0.95f}, OSCURO);
}

static void dibuja() {
    if (estado.ambos) {
        const std::vector<Recuadro> paneles = reparte(2);
        abreRecuadro(ventanaEntera(), GRIS);
        for (int i = 0; i < 2; ++i)
            dibujaModo(paneles[i], i);
    } else {
        dibujaModo(ventanaEntera(), estado.elegido);
    }
    char ademas[32];
    std::snprintf(ademas, sizeof ademas, ", S2 = %.1f", estado.S2);
    rotulaTiempo(estado.reloj, OSCURO, ademas);
    tituloAnimado(estado.reloj, std::string("Vértices desplazados por ruido: ") +
                                    (estado.ambos ? "los dos" : MODOS[estado.elegido].nombre) + ademas);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaAnimacion(estado.reloj, tecla))
        return;
    switch (tecla) {
    case '1':
    case '2':
        estado.elegido = tecla - '1';
        estado.ambos = false;
        break;
    case 'v': estado.ambos = !estado.ambos; break;
    case '+': estado.S2 = std::min(estado.S2 + PASO_S2, S2_MAXIMA); break;
    case '-': estado.S2 = std::max(estado.S2 - PASO_S2, 0.0f); break;
    default: return;
    }
    glutPostRedisplay();
}

static void anima(int) {
    pideCuadro(estado.reloj, anima);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Vértices desplazados por ruido", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    estado.programa = creaPrograma("ch12_animacion/ruido_vertices.vert", "ch03_transformaciones/objeto.frag");
    estado.esfera = creaBuferes(esfera(120));
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    anima(0);
    glutMainLoop();
    return 0;
}
