// Un espejo plano con el buffer de plantilla (listado 7.2, ecuación 7.3, figura 7.2). El libro marca el espejo sin test
// de profundidad y dibuja antes lo reflejado: lo que está detrás del espejo lo taparía. Aquí va antes la escena, se
// marca solo lo que se ve del espejo, y ahí se borra la profundidad y se dibuja la escena simétrica.
// Controles: a d acercan la F al espejo, hasta cruzarlo, y la alejan · ratón orbita, también por detrás · Esc termina.
#include "colores.h"
#include "escena_dibujada.h"
#include "orbita.h"
#include "proyeccion.h"
#include "ventana.h"
#include <algorithm>

static const float PASO = 0.2f, AVANCE_MINIMO = -1, AVANCE_MAXIMO = 3;
static const glm::vec4 AZOGUE(0.40f, 0.52f, 0.60f, 0.25f); // el color y la opacidad del espejo

static struct {
    EscenaDibujada escena;
    float avance = 0;
    Orbita orbita = {-0.30f, 0.30f, 15.5f, {0.35f, 0.95f, 0}, 0.02f};
} estado;

static void inicia() {
    estado.escena = creaEscena();
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    ponFondo(CIELO);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    const glm::mat4 camara = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.5f, 1, 60);
    const std::vector<PiezaEscena> piezas = piezasEscena(estado.avance);
    dibujaEscena(estado.escena, piezas, camara, proyeccion);

    // Marca con un 1 lo que se ve del espejo (por detrás no se ve: GL_CULL_FACE), y lo deja del color del cielo
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 1, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    dibujaEspejo(estado.escena, camara, proyeccion, glm::vec4(CIELO, 1));

    // En lo marcado, y solo ahí, borra la profundidad: el espejo, en el fondo
    glStencilFunc(GL_EQUAL, 1, 0xff);
    borraTrasEspejo(estado.escena, camara, proyeccion);

    dibujaEscena(estado.escena, piezas, camara, proyeccion, true);

    // El espejo, con transparencia (listado 7.1): sobre todo lo reflejado
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    dibujaEspejo(estado.escena, camara, proyeccion, AZOGUE);
    glDisable(GL_BLEND);
    glDisable(GL_STENCIL_TEST);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || (tecla != 'a' && tecla != 'd'))
        return;
    estado.avance = std::clamp(estado.avance + (tecla == 'a' ? PASO : -PASO), AVANCE_MINIMO, AVANCE_MAXIMO);
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
