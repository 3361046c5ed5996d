// Enrejado (§8.2, listado 8.3, figura 8.2): una textura procedural que no da un color sino huecos, con `discard`. De
// cada periodo de (s, t) queda la parte `talla`, una en s y otra en t; lo demás se descarta, y con ello su profundidad:
// por los huecos se ve el interior, que se ilumina con la normal del revés. Los periodos que hay de una vuelta a otra
// son `nVeces`.
// Controles: + - barrotes más anchos o más finos · a d la talla en s · w x la talla en t · b n más o menos veces ·
// ratón orbita · Esc termina.
#include "buferes.h"
#include "ch03_transformaciones/transformaciones.h"
#include "ch05_iluminacion/iluminacion.h"
#include "ch05_iluminacion/materiales.h"
#include "colores.h"
#include "malla.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "texto.h"
#include "ventana.h"
#include <algorithm>
#include <glm/gtc/constants.hpp>

static const glm::ivec2 VECES(2, 1); // lo que cambia nVeces
static const int VECES_MAXIMAS = 24;
static const Material FUERA = {0.22f * NARANJA, 0.80f * NARANJA, {0.55f, 0.55f, 0.55f}, 50};
static const glm::vec3 DENTRO = AZUL;

static struct {
    GLuint programa;
    Buferes esfera;
    glm::ivec2 talla = glm::ivec2(7); // en s y en t, veinteavos
    int veces = 12;
    Orbita orbita = {0.4f, 0.35f, 6, {0, 0, 0}};
} estado;

static void inicia() {
    estado.programa =
        creaPrograma("ch08_texturas_avanzadas/enrejado.vert", "ch08_texturas_avanzadas/enrejado.frag");
    estado.esfera = creaBuferes(esfera(segmentosEsfera(400)));
    glEnable(GL_DEPTH_TEST);
    ponFondo(FONDO_CLARO);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 camara = camaraOrbita(estado.orbita),
                    M = giroX(-glm::half_pi<float>()); // los polos, en ±Y
    const glm::ivec2 veces = estado.veces * VECES;
    const glm::vec2 talla = glm::vec2(estado.talla) / 20.0f;
    usaIluminado(estado.programa, camara, perspectivaVentana(0.4f, 1, 100), {{-4, 6, 5, 1}});
    envia(estado.programa, "colorInterior", DENTRO);
    envia(estado.programa, "nVeces", glm::vec2(veces));
    envia(estado.programa, "talla", talla);
    dibujaIluminado(estado.programa, estado.esfera, M, camara, FUERA);

    const std::string textoTalla = formatea("talla = (%.2f, %.2f)", talla.s, talla.t),
                      textoVeces = formatea("nVeces = (%d, %d)", veces.s, veces.t);
    rotula(textoTalla, {0.02f, 0.98f}, OSCURO, Lado::DERECHA);
    rotula(textoVeces, {0.02f, 0.02f}, OSCURO, Lado::DERECHA);
    ponTitulo("Enrejado: " + textoTalla + ", " + textoVeces);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    glm::ivec2 cambio(0);
    switch (tecla) {
    case '+': cambio = {1, 1}; break;
    case '-': cambio = {-1, -1}; break;
    case 'a': cambio = {-1, 0}; break;
    case 'd': cambio = {1, 0}; break;
    case 'x': cambio = {0, -1}; break;
    case 'w': cambio = {0, 1}; break;
    case 'b': estado.veces = std::min(estado.veces + 1, VECES_MAXIMAS); break;
    case 'n': estado.veces = std::max(estado.veces - 1, 1); break;
    default: return;
    }
    estado.talla = glm::clamp(estado.talla + cambio, 1, 20);
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Enrejado", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
