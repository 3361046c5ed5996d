// La grúa de obra con cubos de lado uno (ejercicio 3.5, figura 3.3): gira sobre el pie, desplaza la carga por
// el brazo y la sube y baja. Cada movimiento es una transformación que heredan las piezas que mueve (grua.h).
// Controles: a d giran · q e desplazan la carga · w s la suben y bajan · ratón orbita · Esc termina.
#include "grua.h"
#include "colores.h"
#include "objeto.h"
#include "orbita.h"
#include "trazo.h"
#include "ventana.h"
#include <cstdio>
#include <glm/gtc/constants.hpp>

static struct {
    GLuint programa;
    Buferes cubo;
    PosturaGrua postura;
    Orbita orbita = {0.5f, 0.25f, 33, {0.3f, 4.2f, 0}, 0.02f};
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
    const glm::mat4 camara = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.6f, 1, 100);
    envia(estado.programa, "proyeccion", proyeccion);
    envia(estado.programa, "camara", camara);
    dibujaObjeto(estado.programa, estado.cubo, soleraGrua(), SUELO);
    dibujaObjeto(estado.programa, estado.cubo, zapataGrua(), GRIS);
    for (const Pieza &pieza : piezasGrua(estado.postura))
        dibujaObjeto(estado.programa, estado.cubo, pieza.M, pieza.color);
    trazaSegmentos(cuadriculaGrua(), proyeccion * camara, BLANCO, 2);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || !mueve(estado.postura, tecla))
        return;
    char titulo[96];
    const PosturaGrua &p = estado.postura;
    std::snprintf(titulo, sizeof titulo, "Grúa de obra: giro %.0f°, carga a %.1f del pie y a %.1f del suelo",
                  glm::degrees(static_cast<double>(p.giro)), static_cast<double>(p.distancia),
                  static_cast<double>(p.altura));
    ponTitulo(titulo);
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
