// Agua: un plano cuya normal se perturba con ruido (§8.4, figura 8.6). Ni el plano ni las olas tienen geometría: cada
// fragmento busca dónde corta su rayo al plano, y el gradiente del ruido, que se mueve con el tiempo, le da la normal
// (agua.frag).
// Controles: espacio para y sigue · t medio segundo más · ratón orbita · Esc termina.
#include "orbita.h"
#include "proyeccion.h"
#include "shader.h"
#include "texto.h"
#include "ventana.h"
#include <cmath>
#include <glm/glm.hpp>

static const double PERIODO = 64, CELDAS_POR_SEGUNDO = 0.4; // PERIODO, el de agua.frag
static const unsigned MS = 40;

static struct {
    GLuint programa, vao;
    double segundos = 0; // de 0 a lo que tarda en repetirse, en double: el float del shader no pierde cifras
    bool parado = false;
    Orbita orbita = {0, 0.13f, 12, {0, 0.6f, 0}, 0.02f};
} estado;

static void dibuja() {
    const glm::mat4 camara = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.75f, 1, 100);
    const glm::mat3 ejes = glm::transpose(glm::mat3(camara)); // los de la cámara, que mira hacia su −z
    glUseProgram(estado.programa);
    envia(estado.programa, "base", glm::mat3(ejes[0], ejes[1], -ejes[2]));
    envia(estado.programa, "semitalla", glm::vec2(1 / proyeccion[0][0], 1 / proyeccion[1][1]));
    envia(estado.programa, "ventana", glm::vec2(glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT)));
    envia(estado.programa, "ojo", posicionCamara(estado.orbita));
    envia(estado.programa, "tiempo", float(CELDAS_POR_SEGUNDO * estado.segundos));
    glBindVertexArray(estado.vao);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    ponTitulo(
        formatea("Agua: ruido en la normal, %.1f s%s", estado.segundos, estado.parado ? " (parada)" : ""));
    glutSwapBuffers();
}

static void avanza(double segundos) {
    estado.segundos = std::fmod(estado.segundos + segundos, PERIODO / CELDAS_POR_SEGUNDO);
    glutPostRedisplay();
}

static void reloj(int antes) {
    const int ahora = glutGet(GLUT_ELAPSED_TIME);
    if (!estado.parado)
        avanza((ahora - antes) / 1000.0);
    glutTimerFunc(MS, reloj, ahora);
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    if (tecla == ' ')
        estado.parado = !estado.parado;
    else if (tecla == 't')
        avanza(0.5);
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Agua", GLUT_DOUBLE | GLUT_MULTISAMPLE);
    estado.programa = creaPrograma("ch08_texturas_avanzadas/agua.vert", "ch08_texturas_avanzadas/agua.frag");
    glGenVertexArrays(1, &estado.vao);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutTimerFunc(MS, reloj, glutGet(GLUT_ELAPSED_TIME));
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
