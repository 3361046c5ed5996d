// Un espejo plano con el buffer de plantilla (listado 7.2, figura 7.2). La simetría (ecuación 7.3, reflexion.h) es
// llevar el plano al origen y a Z = 0, escalar con (1, 1, −1) y deshacer. El libro marca el espejo sin test de
// profundidad y dibuja antes lo reflejado: lo que está detrás del espejo, aquí la tabla, lo tapa (tecla l). Aquí va
// antes la escena, se marca solo lo que se ve del espejo, y ahí se borra la profundidad y se dibuja la escena
// simétrica.
// Controles: a d acercan la F al espejo, hasta cruzarlo, y la alejan · l en el orden del listado ·
// ratón orbita, también por detrás · Esc termina.
#include "colores.h"
#include "escena_dibujada.h"
#include "escena_espejo.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "ventana.h"
#include <algorithm>

static const float PASO = 0.2f, AVANCE_MINIMO = -1, AVANCE_MAXIMO = 3;
static const GLint MARCA = 1;
static const GLuint TODOS_LOS_BITS = 0xff;
static const glm::vec4 AZOGUE(0.40f, 0.52f, 0.60f, 0.25f); // el color y la opacidad del espejo

static struct {
    EscenaDibujada escena;
    float avance = 0;
    bool comoEnElListado = false;
    Orbita orbita = {-0.30f, 0.30f, 15.5f, {0.35f, 0.95f, 0}, 0.02f};
} estado;

static void inicia() {
    estado.escena = creaEscena();
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    ponFondo(CIELO);
}

// Marca en la plantilla los píxeles del espejo, sin que se vea, y deja que se dibuje solo en los marcados.
static void marcaEspejo(const glm::mat4 &camara, const glm::mat4 &proyeccion) {
    const auto pinta = [](GLboolean si) { glColorMask(si, si, si, si); };
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, MARCA, TODOS_LOS_BITS);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE); // por detrás no se ve: GL_CULL_FACE
    pinta(GL_FALSE);
    dibujaEspejo(estado.escena, camara, proyeccion, AZOGUE);
    pinta(GL_TRUE);
    glStencilFunc(GL_EQUAL, MARCA, TODOS_LOS_BITS);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    const glm::mat4 camara = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.5f, 1, 60);
    const std::vector<PiezaEscena> piezas = piezasEscena(estado.avance);
    if (estado.comoEnElListado) {
        glDisable(GL_DEPTH_TEST);
        marcaEspejo(camara, proyeccion);
        glEnable(GL_DEPTH_TEST);
        dibujaEscena(estado.escena, piezas, camara, proyeccion, true);
        glDisable(GL_STENCIL_TEST);
        dibujaEscena(estado.escena, piezas, camara, proyeccion);
    } else {
        dibujaEscena(estado.escena, piezas, camara, proyeccion);
        marcaEspejo(camara, proyeccion);
        borraTrasEspejo(estado.escena, camara, proyeccion);
        dibujaEscena(estado.escena, piezas, camara, proyeccion, true);
        glDisable(GL_STENCIL_TEST);
    }
    // El espejo, con transparencia (listado 7.1): sobre todo lo reflejado
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    dibujaEspejo(estado.escena, camara, proyeccion, AZOGUE);
    glDisable(GL_BLEND);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    switch (tecla) {
    case 'a': estado.avance = std::min(estado.avance + PASO, AVANCE_MAXIMO); break;
    case 'd': estado.avance = std::max(estado.avance - PASO, AVANCE_MINIMO); break;
    case 'l': estado.comoEnElListado = !estado.comoEnElListado; break;
    default: return;
    }
    ponTitulo(estado.comoEnElListado ? "Espejo plano, en el orden del listado 7.2" : "Espejo plano");
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Espejo plano", GLUT_DOUBLE | GLUT_DEPTH | GLUT_STENCIL | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
