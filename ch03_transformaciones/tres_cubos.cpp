// Tres cubos, cada uno con la mitad de lado que el anterior (ejercicio 3.2). La figura del libro no está en el texto: aquí
// cada cubo se apoya centrado sobre el anterior, y las transformaciones se detallan en pasos.h. Los ejes salen del
// origen, el centro del primer cubo.
// Controles: ratón orbita · Esc termina.
#include "ejes.h"
#include "objeto.h"
#include "orbita.h"
#include "pasos.h"
#include "ventana.h"

static const glm::vec3 COLOR_CUBO[3] = {NARANJA, AMARILLO, GRIS};
static const char *const LADO_CUBO[3] = {"lado 1", "1/2", "1/4"};

static struct {
    GLuint programa;
    Buferes cubo;
    Orbita orbita = {0.55f, 0.35f, 6.1f, {0.1f, 0.45f, 0}};
} estado;

static void inicia() {
    estado.programa = creaProgramaObjeto();
    estado.cubo = creaBuferes(cubo());
    glEnable(GL_DEPTH_TEST);
    glClearColor(FONDO_CLARO.r, FONDO_CLARO.g, FONDO_CLARO.b, 1);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 camara = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.5f, 1, 100);
    glUseProgram(estado.programa);
    envia(estado.programa, "proyeccion", proyeccion);
    envia(estado.programa, "camara", camara);
    const std::array<glm::mat4, 3> cubos = tresCubos();
    for (std::size_t i = 0; i < cubos.size(); ++i)
        dibujaObjeto(estado.programa, estado.cubo, cubos[i], COLOR_CUBO[i]);
    trazaEjes(proyeccion * camara, glm::vec3(1.4f, 1.55f, 1.4f));
    for (std::size_t i = 0; i < cubos.size(); ++i) // junto a la arista vertical de la izquierda
        rotulaPunto(LADO_CUBO[i], cubos[i] * glm::vec4(-0.5f, 0, 0.5f, 1), proyeccion * camara, OSCURO,
                    Lado::IZQUIERDA);
    glutSwapBuffers();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Tres cubos, cada uno la mitad", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
