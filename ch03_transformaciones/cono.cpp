// Del cono de radio y altura 1 al de altura 3 en su sitio (ejercicio 3.3), transformación a transformación
// (ejercicios.h). La figura del libro no está en el texto: aquí acaba tumbado en el eje X con el vértice en
// el origen. En líneas, de dónde sale y adónde va; el título de la ventana dice la matriz.
// Controles: t aplica la transformación siguiente, y tras la última empieza · ratón orbita · Esc termina.
#include "ejercicios.h"
#include "malla.h"
#include "orbita.h"
#include "shader.h"
#include "ventana.h"
#include <algorithm>
#include <string>

static const float RADIO_PX = 300; // la base en una pantalla de 1080 líneas
static const glm::vec3 colorCono(0.95f, 0.55f, 0.10f), colorLineas(0.55f, 0.58f, 0.62f);
static const glm::vec3 colorEje[3] = {{0.85f, 0.20f, 0.18f}, {0.20f, 0.62f, 0.28f}, {0.16f, 0.38f, 0.80f}};

static struct {
    GLuint programa;
    Buferes cono, conoDeLineas, cilindro;
    std::size_t aplicados = 0;
    Orbita orbita = {0.6f, 0.35f, 9, {1.15f, 0.1f, 0}};
} estado;

static void inicia() {
    estado.programa = creaPrograma("ch03_transformaciones/objeto.vert", "ch03_transformaciones/objeto.frag");
    estado.cono = creaBuferes(cono(segmentosPara(RADIO_PX)));
    estado.conoDeLineas = creaBuferes(cono(12));
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
    for (int eje = 0; eje < 3; ++eje)
        dibujaObjeto(estado.cilindro, ejeCoordenado(eje, eje == 0 ? 3.8f : 2, 0.04f), colorEje[eje]);
    const std::vector<Paso> pasos = pasosCono();
    dibujaObjeto(estado.cono, concatena(pasos, estado.aplicados), colorCono);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glLineWidth(static_cast<float>(std::max(glutGet(GLUT_WINDOW_HEIGHT) / 300, 1)));
    for (std::size_t extremo : {std::size_t(0), pasos.size()})
        if (extremo != estado.aplicados) // donde está el cono no hacen falta líneas
            dibujaObjeto(estado.conoDeLineas, concatena(pasos, extremo), colorLineas);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla != 't')
        return;
    const std::vector<Paso> pasos = pasosCono();
    estado.aplicados = (estado.aplicados + 1) % (pasos.size() + 1);
    std::string producto;
    for (std::size_t i = 0; i < estado.aplicados; ++i) // la última aplicada, a la izquierda
        producto = pasos[i].nombre + (i ? " · " + producto : "");
    glutSetWindowTitle(("Cono: M = " + (producto.empty() ? "I" : producto)).c_str());
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
