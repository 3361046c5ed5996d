// La grúa de obra con cubos de lado uno (ejercicio 3.5, figura 3.3): gira sobre el pie, desplaza la carga por
// el brazo y la sube y baja. Cada movimiento es una transformación que heredan las piezas que mueve (grua.h).
// Controles: a d giran · q e desplazan la carga · w s la suben y bajan · ratón orbita · Esc termina.
#include "grua.h"
#include "colores.h"
#include "objeto.h"
#include "orbita.h"
#include "ventana.h"

static struct {
    GLuint programa;
    Buferes cubo;
    PosturaGrua postura;
    Orbita orbita = {0.5f, 0.25f, 23, {1.5f, 5.2f, 0}};
} estado;

static void inicia() {
    estado.programa = creaProgramaObjeto();
    estado.cubo = creaBuferes(cubo());
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE); // las caras de detrás nunca se ven: los sólidos son cerrados
    glClearColor(CIELO.r, CIELO.g, CIELO.b, 1);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    envia(estado.programa, "proyeccion", perspectivaVentana(0.6f, 1, 100));
    envia(estado.programa, "camara", camaraOrbita(estado.orbita));
    dibujaObjeto(estado.programa, estado.cubo, traslacion({0, -0.1f, 0}) * escalado({20, 0.2f, 20}), SUELO);
    for (const Pieza &pieza : piezasGrua(estado.postura))
        dibujaObjeto(estado.programa, estado.cubo, pieza.M, pieza.color);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (!teclaComun(tecla) && mueve(estado.postura, tecla))
        glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Grúa de obra", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
