// Un objeto que aparece y se desvanece (§12.1): la opacidad alfa es una función del tiempo que el shader recibe en un
// uniform. Con la mezcla, el color es alfa · el del objeto + (1 − alfa) · el que había.
// Controles: espacio pausa · s adelanta medio segundo · d una décima · h diez horas · ratón orbita · Esc termina.
#include "animacion.h"
#include "buferes.h"
#include "ch03_transformaciones/objeto.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "malla.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "reloj.h"
#include "shader.h"
#include "texto.h"
#include "ventana.h"
#include <glm/gtc/constants.hpp>

static const double PERIODO = 4; // segundos

static struct {
    GLuint opaco, translucido;
    Buferes cubo, toro;
    Orbita orbita = {0.5f, 0.55f, 9.5f};
    Reloj reloj;
} estado;

// Entre 0 y 1 y vuelta, sin tirones; empieza a medias.
static float alfaEn(double t) {
    return 0.5f + 0.5f * std::sin(glm::two_pi<float>() * fase(t, PERIODO));
}

static void usa(GLuint programa, const glm::mat4 &camara) {
    usaPrograma(programa, camara, perspectivaVentana(0.42f, 1, 50));
}

static void dibuja() {
    const glm::mat4 camara = camaraOrbita(estado.orbita);
    const float alfa = alfaEn(tiempo(estado.reloj));
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    usa(estado.opaco, camara);
    dibujaObjeto(estado.opaco, estado.cubo, escalado(1.5f), AMARILLO);
    for (int i = 0; i < 64; ++i) { // el suelo, en damero: se nota cuánto se ve a través del anillo
        const int x = i % 8, z = i / 8;
        dibujaObjeto(estado.opaco, estado.cubo,
                     traslacion({float(x) - 3.5f, -1.9f, float(z) - 3.5f}) * escalado({1, 0.1f, 1}),
                     (x + z) % 2 ? GRIS : BLANCO);
    }

    usa(estado.translucido, camara);
    envia(estado.translucido, "alfa", alfa);
    // dos veces: la primera deja solo la profundidad, y así se mezcla una sola capa, la de delante
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    dibujaObjeto(estado.translucido, estado.toro, giroX(0.6f), AZUL);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthFunc(GL_EQUAL);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    dibujaObjeto(estado.translucido, estado.toro, giroX(0.6f), AZUL);
    glDisable(GL_BLEND);
    glDepthFunc(GL_LESS);

    const std::string ademas = formatea(", α = %.2f", alfa);
    rotulaTiempo(estado.reloj, OSCURO, ademas);
    tituloAnimado(estado.reloj, "Aparecer y desvanecerse" + ademas);
    glutSwapBuffers();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Aparecer y desvanecerse", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    estado.opaco = creaProgramaObjeto();
    estado.translucido = creaPrograma("ch03_transformaciones/objeto.vert", "ch12_animacion/desvanecer.frag");
    estado.cubo = creaBuferes(cubo());
    estado.toro = creaBuferes(toro(1.45f, 0.35f, 90, 36));
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    ponFondo(CIELO);
    glutDisplayFunc(dibuja);
    orbitaConRaton(estado.orbita);
    animaConReloj(estado.reloj);
    glutMainLoop();
    return 0;
}
