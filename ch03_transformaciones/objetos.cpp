// Objetos compuestos de cubos, esferas y toros (figura 3.2): cada pieza es una primitiva con su matriz M y su
// matriz N, que el vertex shader del listado 3.1 (objeto.vert) aplica a la posición y a la normal (objetos.h).
// Como es su listado, aquí las llamadas a OpenGL están a la vista: es lo que hacen envia y dibuja (common/).
// Controles: ratón orbita · rueda acerca · Esc termina.
#include "objetos.h"
#include "buferes.h"
#include "colores.h"
#include "malla.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "shader.h"
#include "ventana.h"
#include <glm/gtc/type_ptr.hpp>

static struct {
    GLuint programa;
    Buferes primitivas[3]; // en el orden de Primitiva
    PiezasObjeto piezas = piezasObjetos();
    Orbita orbita = {0.25f, 0.32f, 14.2f, {-0.05f, 1.5f, 0}, 0.02f};
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
    ponFondo(CIELO);
}

static void enviaMatriz(const char *nombre, const glm::mat4 &valor) {
    glUniformMatrix4fv(uniforme(estado.programa, nombre), 1, GL_FALSE, glm::value_ptr(valor));
}

static void dibujaPieza(const PiezaObjeto &pieza) {
    const Buferes &primitiva = estado.primitivas[int(pieza.primitiva)];
    const glm::mat3 N = matrizNormal(pieza.M);
    enviaMatriz("M", pieza.M);
    glUniformMatrix3fv(uniforme(estado.programa, "N"), 1, GL_FALSE, glm::value_ptr(N));
    glUniform3fv(uniforme(estado.programa, "colorObjeto"), 1, glm::value_ptr(pieza.color));
    glBindVertexArray(primitiva.vao);
    glDrawElements(GL_TRIANGLES, primitiva.nIndices, GL_UNSIGNED_INT, nullptr);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    enviaMatriz("proyeccion", perspectivaVentana(0.5f, 1, 60));
    enviaMatriz("camara", camaraOrbita(estado.orbita));
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
