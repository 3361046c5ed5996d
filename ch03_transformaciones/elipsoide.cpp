// La esfera de radio 1, escalada con (0.5, 0.5, 3), acaba con un extremo en el origen y el otro en la recta
// x = y = z, dibujada en negro (ejercicio 3.4), transformación a transformación (ejercicios.h). En líneas, de
// dónde sale y adónde va; el título de la ventana dice la matriz.
// Controles: t aplica la transformación siguiente, y tras la última empieza · ratón orbita · Esc termina.
#include "ejercicios.h"
#include "malla.h"
#include "orbita.h"
#include "shader.h"
#include "ventana.h"
#include <algorithm>
#include <string>

static const float RADIO_PX = 450; // el semieje mayor, donde más cerca está, en una pantalla de 1080 líneas
static const glm::vec3 colorEsfera(0.95f, 0.55f, 0.10f), colorLineas(0.55f, 0.58f, 0.62f),
    colorRecta(0.16f, 0.17f, 0.20f);
static const glm::vec3 colorEje[3] = {{0.85f, 0.20f, 0.18f}, {0.20f, 0.62f, 0.28f}, {0.16f, 0.38f, 0.80f}};

static struct {
    GLuint programa;
    Buferes esfera, esferaDeLineas, cilindro;
    std::size_t aplicados = 0;
    Orbita orbita = {-0.5f, 0.35f, 16, {1.6f, 1.1f, 1.6f}};
} estado;

static void inicia() {
    estado.programa = creaPrograma("ch03_transformaciones/objeto.vert", "ch03_transformaciones/objeto.frag");
    // una esfera se hunde a lo largo y a lo ancho: a cada uno, la mitad del medio píxel
    estado.esfera = creaBuferes(esfera(segmentosPara(RADIO_PX, 0.25f)));
    estado.esferaDeLineas = creaBuferes(esfera(12));
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

// El cilindro unidad, llevado a la recta x = y = z con los dos giros del elipsoide.
static glm::mat4 rectaXYZ() {
    const std::vector<Paso> pasos = pasosElipsoide();
    return pasos[3].M * pasos[2].M * escalado({0.05f, 0.05f, 16});
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    const glm::mat4 camara = perspectivaVentana(0.5f, 1, 100) * camaraOrbita(estado.orbita);
    envia(estado.programa, "camara", camara);
    for (int eje = 0; eje < 3; ++eje)
        dibujaObjeto(estado.cilindro, ejeCoordenado(eje, 4, 0.07f), colorEje[eje]);
    dibujaObjeto(estado.cilindro, rectaXYZ(), colorRecta);
    const std::vector<Paso> pasos = pasosElipsoide();
    dibujaObjeto(estado.esfera, concatena(pasos, estado.aplicados), colorEsfera);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glLineWidth(static_cast<float>(std::max(glutGet(GLUT_WINDOW_HEIGHT) / 300, 1)));
    for (std::size_t extremo : {std::size_t(0), pasos.size()})
        if (extremo != estado.aplicados) // donde está la esfera no hacen falta líneas
            dibujaObjeto(estado.esferaDeLineas, concatena(pasos, extremo), colorLineas);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla != 't')
        return;
    const std::vector<Paso> pasos = pasosElipsoide();
    estado.aplicados = (estado.aplicados + 1) % (pasos.size() + 1);
    std::string producto;
    for (std::size_t i = 0; i < estado.aplicados; ++i) // la última aplicada, a la izquierda
        producto = pasos[i].nombre + (i ? " · " + producto : "");
    glutSetWindowTitle(("Elipsoide: M = " + (producto.empty() ? "I" : producto)).c_str());
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
