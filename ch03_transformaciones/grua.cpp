// La grúa de obra con cubos de lado uno (ejercicio 3.5, figura 3.3): gira sobre el pie, desplaza la carga por
// el brazo y la sube y baja. Cada movimiento es una transformación que heredan las piezas que mueve (grua.h).
// Controles: a d giran · q e desplazan la carga · w s la suben y bajan · ratón orbita · Esc termina.
#include "grua.h"
#include "malla.h"
#include "orbita.h"
#include "shader.h"
#include "transformaciones.h"
#include "ventana.h"
#include <glm/gtc/type_ptr.hpp>

static const float PASO_GIRO = 0.1f; // radianes
static const float PASO = 0.5f;
static const glm::vec3 colorSuelo(0.62f, 0.72f, 0.58f);

static struct {
    GLuint programa;
    Buferes cubo;
    PosturaGrua postura;
    Orbita orbita = {0.5f, 0.25f, 23, {1.5f, 5.2f, 0}};
} estado;

static void inicia() {
    estado.programa = creaPrograma("ch03_transformaciones/objeto.vert", "ch03_transformaciones/objeto.frag");
    estado.cubo = creaBuferes(cubo());
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE); // las caras de detrás nunca se ven: los sólidos son cerrados
    glClearColor(0.87f, 0.93f, 0.98f, 1);
}

static void dibujaCubo(const glm::mat4 &M, const glm::vec3 &color) {
    const glm::mat3 N = matrizNormal(M);
    glUniformMatrix4fv(uniforme(estado.programa, "M"), 1, GL_FALSE, glm::value_ptr(M));
    glUniformMatrix3fv(uniforme(estado.programa, "N"), 1, GL_FALSE, glm::value_ptr(N));
    glUniform3fv(uniforme(estado.programa, "colorObjeto"), 1, glm::value_ptr(color));
    glDrawElements(GL_TRIANGLES, estado.cubo.nIndices, GL_UNSIGNED_INT, nullptr);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    const glm::mat4 camara = perspectivaVentana(0.6f, 1, 100) * vistaOrbita(estado.orbita);
    glUniformMatrix4fv(uniforme(estado.programa, "camara"), 1, GL_FALSE, glm::value_ptr(camara));
    glBindVertexArray(estado.cubo.vao);
    dibujaCubo(traslacion({0, -0.1f, 0}) * escalado({20, 0.2f, 20}), colorSuelo);
    for (const Pieza &pieza : piezasGrua(estado.postura))
        dibujaCubo(pieza.M, pieza.color);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    PosturaGrua &p = estado.postura;
    switch (tecla) {
    case 'a': p.giro += PASO_GIRO; break;
    case 'd': p.giro -= PASO_GIRO; break;
    case 'q': p.distancia -= PASO; break;
    case 'e': p.distancia += PASO; break;
    case 'w': p.altura += PASO; break;
    case 's': p.altura -= PASO; break;
    default: return;
    }
    p = limita(p);
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Grúa de obra", 800, 600);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
