// Objetos compuestos de cubos, esferas y toros (figura 3.2): cada pieza es una primitiva con su matriz M y su
// matriz N, que el vertex shader del listado 3.1 (objeto.vert) aplica a la posición y a la normal (objetos.h).
// Controles: ratón orbita · rueda acerca · Esc termina.
#include "objetos.h"
#include "malla.h"
#include "orbita.h"
#include "shader.h"
#include "ventana.h"

static struct {
    GLuint programa;
    Buferes primitivas[3]; // en el orden de Primitiva
    PiezasObjeto piezas = piezasObjetos();
    Orbita orbita = {0.25f, 0.32f, 12.5f, {0, 1.65f, 0}};
} estado;

static void inicia() {
    estado.programa = creaPrograma("ch03_transformaciones/objeto.vert", "ch03_transformaciones/objeto.frag");
    const float radioPx = 130; // el de la esfera y el toro mayores, en 960x720
    const int n = segmentosPara(radioPx), m = segmentosPara(RADIO_TUBO * radioPx);
    estado.primitivas[0] = creaBuferes(cubo());
    estado.primitivas[1] = creaBuferes(esfera(n));
    estado.primitivas[2] = creaBuferes(toro(1, RADIO_TUBO, n, m));
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE); // las caras de detrás nunca se ven: los sólidos son cerrados
    glClearColor(0.87f, 0.93f, 0.98f, 1);
}

static void dibujaPieza(const PiezaObjeto &pieza) {
    const Buferes &malla = estado.primitivas[static_cast<int>(pieza.primitiva)];
    const glm::mat3 N = matrizNormal(pieza.M);
    envia(estado.programa, "M", pieza.M);
    envia(estado.programa, "N", N);
    envia(estado.programa, "colorObjeto", pieza.color);
    dibuja(malla);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    const glm::mat4 camara = perspectivaVentana(0.5f, 1, 60) * camaraOrbita(estado.orbita);
    envia(estado.programa, "camara", camara);
    for (const PiezaObjeto &pieza : estado.piezas)
        dibujaPieza(pieza);
    glutSwapBuffers();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Objetos hechos de cubos, esferas y toros",
                GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
