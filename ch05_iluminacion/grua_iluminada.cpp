// La grúa de obra con una fuente de luz y materiales (ejercicio 5.1). Con el sombreado de Gouraud las caras grandes,
// que solo tienen cuatro vértices, pierden los brillos y lo que la luz cambia dentro de ellas; con el de Phong, no.
// Controles: g Gouraud o Phong · v los dos a la vez · a d giran · q e desplazan la carga ·
// w s la suben y bajan · ratón orbita · Esc termina.
#include "aspecto.h"
#include "buferes.h"
#include "ch03_transformaciones/grua.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "iluminacion.h"
#include "malla.h"
#include "materiales.h"
#include "modos.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "trazo.h"
#include "ventana.h"
#include <glm/gtc/constants.hpp>

static const Luz LUZ{{3.5f, 8.5f, 5.5f, 1}};
static const float LADO_SUELO = 8, CASILLA = 2;
static const double ASPECTO_DE_DOS = 1.1; // de lo que barre la grúa: en un panel alto lo llena a lo ancho
static const char *const NOMBRES[] = {"Gouraud", "Phong"};

static const Material PINTURA = {{0.25f, 0.18f, 0.03f}, {0.68f, 0.50f, 0.08f}, {0.60f, 0.60f, 0.60f}, 15};
static const Material HORMIGON = {{0.12f, 0.13f, 0.14f}, {0.45f, 0.47f, 0.50f}, {0.05f, 0.05f, 0.05f}, 5};
static const Material ACERO = {{0.06f, 0.06f, 0.07f}, {0.20f, 0.21f, 0.24f}, {0.70f, 0.70f, 0.70f}, 80};
static const Material CHAPA = {{0.22f, 0.05f, 0.05f}, {0.68f, 0.14f, 0.12f}, {0.60f, 0.60f, 0.60f}, 30};
static const Material TERRENO = {{0.13f, 0.17f, 0.12f}, {0.46f, 0.58f, 0.42f}, {0.25f, 0.25f, 0.25f}, 12};
static const Material MATERIALES[] = {PINTURA, PINTURA, HORMIGON, ACERO, CHAPA}; // como piezasGrua

static struct {
    GLuint programas[2];
    Buferes cubo;
    PosturaGrua postura;
    Orbita orbita = {0.5f, 0.25f, 34, {0.3f, 4.7f, 0}, 0.02f};
    Modos modos = {2};
} estado;

static void inicia() {
    // E5.1: el programa de cada modelo de sombreado
    estado.programas[0] = creaSombreado("gouraud");
    estado.programas[1] = creaSombreado("phong");
    // de partida: estado.programas[0] = estado.programas[1] = creaSombreado("plano");
    // fin de E5.1
    estado.cubo = creaBuferes(cubo());
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
}

static void dibujaPanel(int modelo, const Recuadro &panel) {
    const GLuint programa = estado.programas[modelo];
    const glm::mat4 camara = camaraOrbita(estado.orbita),
                    proyeccion = perspectivaVentana(ANGULO_GRUA, 1, 200, aspecto(panel),
                                                    estado.modos.todos ? ASPECTO_DE_DOS : ASPECTO_COMPUESTO);
    const auto caja = [&](const glm::mat4 &M, const Material &material) {
        dibujaIluminado(programa, estado.cubo, M, camara, material);
    };
    abreRecuadro(panel);
    ponFondo(CIELO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    usaIluminado(programa, camara, proyeccion, LUZ);
    caja(traslacion({0, -0.1f, 0}) * escalado({LADO_SUELO, 0.2f, LADO_SUELO}), TERRENO);
    caja(traslacion({0, 0.2f, 0}) * escalado({2.4f, 0.4f, 2.4f}), HORMIGON); // la zapata
    // La caseta y su tejado, un cubo girado y después aplastado: a sus normales les hace falta la inversa traspuesta.
    const glm::mat4 caseta = traslacion({-2.4f, 0, 2.4f}) * giroY(0.4f);
    caja(caseta * traslacion({0, 0.6f, 0}) * escalado({1.6f, 1.2f, 1.8f}), HORMIGON);
    caja(caseta * traslacion({0, 1.2f, 0}) * escalado({1.4f, 0.9f, 1.78f}) * giroZ(glm::quarter_pi<float>()),
         CHAPA);
    int i = 0;
    for (const Pieza &pieza : piezasGrua(estado.postura))
        caja(pieza.M, MATERIALES[i++]);
    // por encima del suelo lo justo para que se vea
    const glm::mat4 enSuelo = traslacion({0, 0.02f, 0}) * giroX(glm::half_pi<float>());
    trazaSegmentos(cuadricula(LADO_SUELO, CASILLA), proyeccion * camara * enSuelo, OSCURO, GROSOR / 3);
    rotula(NOMBRES[modelo], {0, 0.96f}, OSCURO, Lado::DERECHA);
}

static void dibuja() {
    dibujaModos(estado.modos, dibujaPanel);
    ponTitulo(std::string("Grúa iluminada: ") +
              (estado.modos.todos ? "Gouraud y Phong" : NOMBRES[estado.modos.elegido]));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    if (tecla == 'g') {
        estado.modos.elegido = 1 - estado.modos.elegido;
        estado.modos.todos = false;
    } else if (tecla == 'v')
        estado.modos.todos = !estado.modos.todos;
    else if (!mueve(estado.postura, tecla))
        return;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Grúa iluminada", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
