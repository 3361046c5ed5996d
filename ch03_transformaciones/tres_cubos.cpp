// Tres cubos, cada uno con la mitad de lado que el anterior (ejercicio 3.2). La figura del libro no está en
// el texto: aquí cada cubo se apoya centrado sobre el anterior, con A = T(0, 3/4, 0)·S(1/2), y las
// transformaciones se detallan en pasos.h.
// Controles: ratón orbita · Esc termina.
#include "buferes.h"
#include "colores.h"
#include "dibujos.h"
#include "malla.h"
#include "objeto.h"
#include "orbita.h"
#include "pasos.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "ventana.h"

static const glm::vec3 COLOR_CUBO[] = {GRIS, NARANJA, AMARILLO};
static const char *const NOMBRE_CUBO[] = {"M = I", "M = A", "M = A·A"};

static struct {
    GLuint programa;
    Buferes cubo;
    Orbita orbita = {0.55f, 0.35f, 5.6f, {0.15f, 0.38f, 0}};
} estado;

static void inicia() {
    estado.programa = creaProgramaObjeto();
    estado.cubo = creaBuferes(cubo());
    glEnable(GL_DEPTH_TEST);
    ponFondo(FONDO_CLARO);
}

static void dibuja() {
    const glm::mat4 proyeccion = perspectivaVentana(0.5f, 1, 100), camara = camaraOrbita(estado.orbita);
    const glm::mat4 transformacion = proyeccion * camara;
    const std::array<glm::mat4, 3> cubos = tresCubos();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    usaPrograma(estado.programa, camara, proyeccion);
    for (std::size_t i = 0; i < cubos.size(); ++i)
        dibujaObjeto(estado.programa, estado.cubo, cubos[i], COLOR_CUBO[i]);
    trazaEjes(glm::vec3(1.5f), transformacion);
    for (std::size_t i = 0; i < cubos.size(); ++i) // en la arista derecha de la cara de delante
        rotulaPunto(NOMBRE_CUBO[i], cubos[i] * glm::vec4(0.5f, 0.25f, -0.5f, 1), transformacion, OSCURO,
                    Lado::DERECHA);
    rotula("A = T(0, 0.75, 0) · S(0.5)", {0.5f, 0.05f}, OSCURO);
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
