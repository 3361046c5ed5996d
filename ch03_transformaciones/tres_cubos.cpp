// Tres cubos, cada uno con la mitad de lado que el anterior (ejercicio 3.2). La figura del libro no está en
// el texto: aquí cada cubo se apoya centrado sobre el anterior, y las transformaciones se detallan en
// ejercicios.h. Los ejes salen del origen, el centro del primer cubo: X rojo, Y verde, Z azul.
// Controles: ratón orbita · Esc termina.
#include "ejercicios.h"
#include "malla.h"
#include "orbita.h"
#include "shader.h"
#include "ventana.h"

static const glm::vec3 colorCubo[3] = {{0.95f, 0.55f, 0.10f}, {0.98f, 0.78f, 0.15f}, {0.55f, 0.58f, 0.62f}};
static const glm::vec3 colorEje[3] = {{0.85f, 0.20f, 0.18f}, {0.20f, 0.62f, 0.28f}, {0.16f, 0.38f, 0.80f}};

static struct {
    GLuint programa;
    Buferes cubo, cilindro;
    Orbita orbita = {0.55f, 0.35f, 5.4f, {0.1f, 0.42f, 0}};
} estado;

static void inicia() {
    estado.programa = creaPrograma("ch03_transformaciones/objeto.vert", "ch03_transformaciones/objeto.frag");
    estado.cubo = creaBuferes(cubo());
    estado.cilindro = creaBuferes(cilindro(16));
    glEnable(GL_DEPTH_TEST);
    glClearColor(0.95f, 0.96f, 0.98f, 1);
}

static void dibujaObjeto(const Buferes &objeto, const glm::mat4 &M, const glm::vec3 &color) {
    const glm::mat3 N = matrizNormal(M);
    envia(estado.programa, "M", M);
    envia(estado.programa, "N", N);
    envia(estado.programa, "colorObjeto", color);
    dibuja(objeto);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    const glm::mat4 camara = perspectivaVentana(0.5f, 1, 100) * camaraOrbita(estado.orbita);
    envia(estado.programa, "camara", camara);
    const std::array<glm::mat4, 3> cubos = tresCubos();
    for (std::size_t i = 0; i < cubos.size(); ++i)
        dibujaObjeto(estado.cubo, cubos[i], colorCubo[i]);
    for (int eje = 0; eje < 3; ++eje)
        dibujaObjeto(estado.cilindro, ejeCoordenado(eje, 1.6f, 0.025f), colorEje[eje]);
    glutSwapBuffers();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Tres cubos", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
