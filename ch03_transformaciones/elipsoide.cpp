// La esfera de radio 1, escalada con (0.5, 0.5, 3), acaba con un extremo en el origen y el otro en la recta
// x = y = z, dibujada en oscuro (ejercicio 3.4), transformación a transformación (pasos.h). En líneas, de
// dónde sale y adónde va.
// Controles: t aplica la transformación siguiente, y tras la última empieza · ratón orbita · Esc termina.
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
#include "trazo.h"
#include "ventana.h"

static const float RADIO_PX = 525; // el semieje mayor, donde más cerca está, en una pantalla de 1080 líneas

static struct {
    GLuint programa;
    Buferes esfera;
    std::vector<Paso> pasos = pasosElipsoide();
    std::size_t aplicados = 0;
    Orbita orbita = {-0.5f, 0.35f, 15.5f, {0.9f, 1.3f, 0.8f}};
} estado;

static void inicia() {
    estado.programa = creaProgramaObjeto();
    // una esfera se hunde a lo largo y a lo ancho: a cada uno, la mitad del medio píxel
    estado.esfera = creaBuferes(esfera(segmentosPara(RADIO_PX, 0.25f)));
    glEnable(GL_DEPTH_TEST);
    ponFondo(FONDO_CLARO);
}

static void dibuja() {
    const glm::mat4 proyeccion = perspectivaVentana(0.5f, 1, 100), camara = camaraOrbita(estado.orbita);
    const glm::mat4 transformacion = proyeccion * camara;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    usaPrograma(estado.programa, camara, proyeccion);
    dibujaObjeto(estado.programa, estado.esfera, concatena(estado.pasos, estado.aplicados), NARANJA);
    for (std::size_t extremo : {std::size_t(0), estado.pasos.size()})
        if (extremo != estado.aplicados) // donde está la esfera no hacen falta líneas
            trazaEsfera(transformacion * concatena(estado.pasos, extremo), GRIS);
    const glm::vec3 enLaRecta(4);
    trazaPolilinea({-0.3f * enLaRecta, enLaRecta}, transformacion, OSCURO);
    rotulaPunto("x=y=z", enLaRecta, transformacion, OSCURO, Lado::ENCIMA);
    trazaEjes({4, 2.6f, 4}, transformacion);
    rotulaPasos(estado.pasos, estado.aplicados, {0.02f, 0.67f});
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla != 't')
        return;
    estado.aplicados = (estado.aplicados + 1) % (estado.pasos.size() + 1);
    ponTitulo("Elipsoide: " + producto(estado.pasos, estado.aplicados));
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Elipsoide: M = I", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
