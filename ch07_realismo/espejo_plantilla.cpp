// Para qué sirve el buffer de plantilla en un espejo (figura 7.3): sin él, la escena simétrica se ve también fuera de los límites
// del espejo; con él, solo dentro. Aquí se ve el mismo espejo de las dos maneras (espejo.cpp explica los pasos).
// Controles: p con plantilla o sin ella · v las dos a la vez · ratón orbita · Esc termina.
#include "colores.h"
#include "escena_iluminada.h"
#include "orbita.h"
#include "recuadro.h"
#include "rotulo.h"
#include "ventana.h"

static struct {
    EscenaIluminada escena;
    GLuint programaEspejo;
    Buferes espejo;
    bool conPlantilla = true, compara = false;
    Orbita orbita = {-0.30f, 0.30f, 15.5f, {0.35f, 0.95f, 0}, 0.02f};
} estado;

static void inicia() {
    estado.escena = creaEscena();
    estado.programaEspejo = creaPrograma("ch03_transformaciones/objeto.vert", "ch07_realismo/espejo.frag");
    estado.espejo = creaBuferes(plano(1));
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
}

static void dibujaEspejo(const glm::mat4 &camara, const glm::mat4 &proyeccion) {
    glUseProgram(estado.programaEspejo);
    envia(estado.programaEspejo, "proyeccion", proyeccion);
    envia(estado.programaEspejo, "camara", camara);
    envia(estado.programaEspejo, "M", colocaEspejo());
    envia(estado.programaEspejo, "color", glm::vec4(CIELO, 1));
    dibuja(estado.espejo);
}

static void dibujaVista(const Recuadro &r, bool conPlantilla) {
    abreRecuadro(r, CIELO);
    const glm::mat4 camara = camaraOrbita(estado.orbita),
                    proyeccion = perspectivaVentana(0.5f, 1, 60, aspecto(r));
    const std::vector<PiezaEscena> piezas = piezasEscena(0);
    glUseProgram(estado.escena.programa);
    envia(estado.escena.programa, "proyeccion", proyeccion);
    dibujaEscena(estado.escena, piezas, camara);

    // 1 donde se ve el espejo; la profundidad se borra en él, o en toda la vista
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 1, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    glDepthMask(GL_FALSE);
    dibujaEspejo(camara, proyeccion);
    glDepthMask(GL_TRUE);
    glStencilFunc(conPlantilla ? GL_EQUAL : GL_ALWAYS, 1, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glDepthFunc(GL_ALWAYS);
    glDepthRange(1, 1);
    dibujaEspejo(camara, proyeccion);
    glDepthRange(0, 1);
    glDepthFunc(GL_LESS);
    glUseProgram(estado.escena.programa);
    dibujaEscena(estado.escena, piezas, camara, reflexion(planoEspejo()));
    glDisable(GL_STENCIL_TEST);
    rotula(conPlantilla ? "con plantilla" : "sin plantilla", {0.5f, 0.94f}, OSCURO);
}

static void dibuja() {
    glClear(GL_STENCIL_BUFFER_BIT);
    if (estado.compara) {
        abreRecuadro(ventanaEntera(), GRIS);
        const std::vector<Recuadro> mitades = reparte(2, 4.0f / 3);
        dibujaVista(mitades[0], false);
        dibujaVista(mitades[1], true);
    } else {
        dibujaVista(ventanaEntera(), estado.conPlantilla);
    }
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    switch (tecla) {
    case 'p': estado.conPlantilla = !estado.conPlantilla; break;
    case 'v': estado.compara = !estado.compara; break;
    default: return;
    }
    ponTitulo(estado.compara
                  ? "Espejo sin plantilla y con ella"
                  : std::string("Espejo ") + (estado.conPlantilla ? "con plantilla" : "sin plantilla"));
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Espejo con plantilla",
                GLUT_DOUBLE | GLUT_DEPTH | GLUT_STENCIL | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
