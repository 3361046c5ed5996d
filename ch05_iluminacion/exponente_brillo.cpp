// El exponente del brillo en la reflexión especular (ecuación 5.4, figura 5.3): cinco esferas del mismo
// material con alfa = 1, 5 y 20 arriba y 100 y 500 abajo. Cuanto mayor es alfa, menor es el brillo.
// Controles: ratón orbita · rueda acerca · Esc termina.
#include "ch03_transformaciones/transformaciones.h"
#include "iluminacion.h"
#include "malla.h"
#include "orbita.h"
#include "ventana.h"

static const struct {
    glm::vec3 centro;
    float alfa;
} ESFERAS[] = {
    {{-2.15f, 0.95f, 0}, 1},     {{0, 0.95f, 0}, 5},         {{2.15f, 0.95f, 0}, 20},
    {{-1.075f, -0.95f, 0}, 100}, {{1.075f, -0.95f, 0}, 500},
};
static const Material esmalte = {{0.09f, 0.02f, 0.03f}, {0.44f, 0.07f, 0.10f}, {0.85f, 0.85f, 0.85f}, 1};
static const glm::vec3 La(1);
static const Luz luz{{-0.45f, 0.60f, 1, 0}}; // en el infinito: el brillo cae en el mismo sitio de cada esfera

static struct {
    GLuint programa;
    Buferes esfera;
    Orbita orbita = {0, 0, 16, {0, 0, 0}};
} estado;

static void inicia() {
    estado.programa =
        creaPrograma("ch05_iluminacion/sombreado_phong.vert", "ch05_iluminacion/sombreado_phong.frag");
    estado.esfera = creaBuferes(esfera(segmentosPara(150, 0.05f)));
    glEnable(GL_DEPTH_TEST);
    glClearColor(0.16f, 0.17f, 0.20f, 1);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    const glm::mat4 vista = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.30f, 1, 100);
    envia(estado.programa, "vista", vista);
    envia(estado.programa, "proyeccion", proyeccion);
    envia(estado.programa, "La", La);
    enviaLuz(estado.programa, "luz", luz, vista);
    glBindVertexArray(estado.esfera.vao);
    for (const auto &e : ESFERAS) {
        const glm::mat4 M = traslacion(e.centro);
        const glm::mat3 N = matrizNormal(vista * M);
        Material material = esmalte;
        material.alfa = e.alfa;
        envia(estado.programa, "M", M);
        envia(estado.programa, "N", N);
        enviaMaterial(estado.programa, material);
        glDrawElements(GL_TRIANGLES, estado.esfera.nIndices, GL_UNSIGNED_INT, nullptr);
    }
    glutSwapBuffers();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Exponente del brillo", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
