// Del cono de radio y altura 1 al de altura 3 en su sitio (ejercicio 3.3), transformación a transformación
// (pasos.h). La figura del libro no está en el texto: aquí acaba tumbado en el eje X con el vértice en el
// origen. En líneas, de dónde sale y adónde va.
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
#include "shader.h"
#include "trazo.h"
#include "ventana.h"

static const float RADIO_PX = 300; // la base en una pantalla de 1080 líneas

static struct {
    GLuint programa;
    Buferes cono;
    std::vector<Paso> pasos = pasosCono();
    std::size_t aplicados = 0;
    Orbita orbita = {0.6f, 0.35f, 9, {1.15f, -0.1f, 0}};
} estado;

static void inicia() {
    estado.programa = creaProgramaObjeto();
    estado.cono = creaBuferes(cono(segmentosPara(RADIO_PX)));
    glEnable(GL_DEPTH_TEST);
    ponFondo(FONDO_CLARO);
}

static void trazaCono(const glm::mat4 &transformacion) {
    const std::vector<glm::vec3> base = circunferencia(1);
    trazaPolilinea(base, transformacion, GRIS, 0.7f * GROSOR, true);
    for (std::size_t i = 0; i < base.size(); i += 8)
        trazaPolilinea({base[i], {0, 0, 1}}, transformacion, GRIS, 0.7f * GROSOR);
}

static void dibuja() {
    const glm::mat4 proyeccion = perspectivaVentana(0.5f, 1, 100), camara = camaraOrbita(estado.orbita);
    const glm::mat4 transformacion = proyeccion * camara;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    usaPrograma(estado.programa, camara, proyeccion);
    dibujaObjeto(estado.programa, estado.cono, concatena(estado.pasos, estado.aplicados), NARANJA);
    for (std::size_t extremo : {std::size_t(0), estado.pasos.size()})
        if (extremo != estado.aplicados) // donde está el cono no hacen falta líneas
            trazaCono(transformacion * concatena(estado.pasos, extremo));
    trazaEjes({3.7f, 1.5f, 1.8f}, transformacion);
    rotulaPasos(estado.pasos, estado.aplicados, {0.02f, 0.06f});
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla != 't')
        return;
    estado.aplicados = (estado.aplicados + 1) % (estado.pasos.size() + 1);
    ponTitulo("Cono: " + producto(estado.pasos, estado.aplicados));
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Cono: M = I", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
