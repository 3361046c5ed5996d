// Enrejado (§8.2, listado 8.3, figura 8.2): una textura procedural que no da un color sino huecos, con `discard`. De
// cada periodo de (s, t) queda la parte `talla`, una en s y otra en t; lo demás se descarta, y con ello su profundidad:
// por los huecos se ve el interior, que se ilumina con la normal del revés.
// Controles: + - barrotes más anchos o más finos · a d la talla en s · w x la talla en t · ratón orbita · Esc termina.
#include "ch05_iluminacion/iluminacion.h"
#include "colores.h"
#include "orbita.h"
#include "proyeccion.h"
#include "rotulo.h"
#include "texto.h"
#include "ventana.h"
#include <glm/gtc/constants.hpp>

static const glm::vec2 VECES(24, 12);
static const Material FUERA = {0.22f * NARANJA, 0.80f * NARANJA, {0.55f, 0.55f, 0.55f}, 50};
static const glm::vec3 DENTRO = AZUL;

static struct {
    GLuint programa;
    Buferes esfera;
    glm::ivec2 talla = glm::ivec2(7); // en s y en t, veinteavos
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
    const glm::vec2 talla = glm::vec2(estado.talla) / 20.0f;
    usaPrograma(estado.programa, camara, perspectivaVentana(0.4f, 1, 100), {{-4, 6, 5, 1}});
    envia(estado.programa, "colorInterior", DENTRO);
    envia(estado.programa, "nVeces", VECES);
    envia(estado.programa, "talla", talla);
    dibujaObjeto(estado.programa, estado.esfera, M, camara, FUERA);

    const std::string texto = formatea("talla = (%.2f, %.2f)", talla.s, talla.t);
    rotula(texto, {0.02f, 0.98f}, OSCURO, Lado::DERECHA);
    ponTitulo("Enrejado: " + texto);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    glm::ivec2 cambio;
    switch (tecla) {
    case '+': cambio = {1, 1}; break;
    case '-': cambio = {-1, -1}; break;
    case 'a': cambio = {-1, 0}; break;
    case 'd': cambio = {1, 0}; break;
    case 'x': cambio = {0, -1}; break;
    case 'w': cambio = {0, 1}; break;
    default: return;
    }
    estado.talla = glm::clamp(estado.talla + cambio, 0, 20);
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
