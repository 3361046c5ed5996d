// Para qué sirve el buffer de plantilla en un espejo (figura 7.3): sin él, la escena simétrica se ve también fuera de
// los límites del espejo; con él, solo dentro. Los pasos están en espejo.cpp.
// Controles: p con plantilla o sin ella · v las dos a la vez · ratón orbita · Esc termina.
#include "colores.h"
#include "escena_dibujada.h"
#include "escena_espejo.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "ventana.h"
#include <algorithm>

static const float ANGULO = 0.5f, ANGULO_MINIMO = 0.36f; // a 4:3, y en un panel con sitio a los lados

static struct {
    EscenaDibujada escena;
    bool conPlantilla = true, compara = false;
    Orbita orbita = {-0.30f, 0.30f, 17.5f, {-0.7f, 0.95f, 0}, 0.02f};
} estado;

static void inicia() {
    estado.escena = creaEscena();
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
}

static void dibujaVista(const Recuadro &r, bool conPlantilla) {
    abreRecuadro(r);
    ponFondo(CIELO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const float angulo = std::clamp(ANGULO * 4 / (3 * aspecto(r)), ANGULO_MINIMO, ANGULO);
    const glm::mat4 camara = camaraOrbita(estado.orbita),
                    proyeccion = perspectivaVentana(angulo, 1, 60, aspecto(r));
    const std::vector<PiezaEscena> piezas = piezasEscena(0);
    dibujaEscena(estado.escena, piezas, camara, proyeccion);

    // Marca lo que se ve del espejo y ahí borra la profundidad
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 1, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    dibujaEspejo(estado.escena, camara, proyeccion, glm::vec4(CIELO, 1));
    glStencilFunc(GL_EQUAL, 1, 0xff);
    borraTrasEspejo(estado.escena, camara, proyeccion);

    if (!conPlantilla)
        glDisable(GL_STENCIL_TEST);
    glEnable(GL_POLYGON_OFFSET_FILL); // fuera del espejo, el suelo y su reflejo están en el mismo plano
    glPolygonOffset(1, 2);
    dibujaEscena(estado.escena, piezas, camara, proyeccion, true);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_STENCIL_TEST);
    rotula(conPlantilla ? "con plantilla" : "sin plantilla", {0.98f, 0.06f}, OSCURO, Lado::IZQUIERDA);
}

static void dibuja() {
    glClear(GL_STENCIL_BUFFER_BIT);
    if (estado.compara) {
        abreRecuadro(ventanaEntera());
        ponFondo(GRIS);
        glClear(GL_COLOR_BUFFER_BIT);
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
    case 'p':
        estado.conPlantilla = !estado.conPlantilla;
        estado.compara = false;
        break;
    case 'v': estado.compara = !estado.compara; break;
    default: return;
    }
    const char *const uno = estado.conPlantilla ? "Espejo con plantilla" : "Espejo sin plantilla";
    ponTitulo(estado.compara ? "Espejo sin plantilla y con ella" : uno);
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
