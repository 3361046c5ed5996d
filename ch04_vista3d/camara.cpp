// La transformación de la cámara (ecuación 4.1, figura 4.1): en un panel, la cámara desde fuera, con su posición p, su
// punto de interés i, su vector de inclinación UP (en gris, el de partida) y los ejes S, U y F que salen de ellos; en
// el otro, lo que ve. El libro no dice qué pasa si UP es paralelo a F: aquí siempre hay base (vista.h), y la cuarta
// vista, con UP a 1e-7 de F, sale bien.
// Controles: 1 2 3 vistas · 4 UP casi paralelo · i o inclinan · ratón orbita por fuera · Esc termina.
#include "aspecto.h"
#include "buferes.h"
#include "camara_fotos.h"
#include "ch03_transformaciones/objeto.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "malla.h"
#include "modos.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "trazo.h"
#include "ventana.h"
#include "vista.h"
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

static const float PASO = 0.1f;    // radianes
static const double ANGULO = 1.05; // de la cámara, en radianes
static const double CERCA = 0.5, LEJOS = 60, LARGO_PIRAMIDE = 2, LARGO_UP = 2.8, LARGO_EJE = 1.7;
static const glm::dvec3 INTERES(0, 1.7, 0);

static const struct {
    glm::dvec3 p, UP;
} VISTAS[] = {{{2.8, 4.1, 1.4}, {0, 1, 0}},
              {{-2.1, 3.7, 1.5}, {0, 1, 0}},
              {{-1.6, 5.6, 1.2}, {1, 0, 0}},
              {{2.6, 4.9, -0.4}, {-2.6, -3.2 + 1e-7, 0.4}}};

static struct {
    GLuint programa;
    Buferes cubo, cilindro, cono, esfera;
    int elegido = 0;
    double inclinacion = 0; // radianes alrededor de F
    Orbita orbita = {0.35f, 0.55f, 15.8f, {0.3f, 2.7f, 0}, 0.02f};
} estado;

static void inicia() {
    estado.programa = creaProgramaObjeto();
    estado.cubo = creaBuferes(cubo());
    estado.cilindro = creaBuferes(cilindro(24));
    estado.cono = creaBuferes(cono(32));
    estado.esfera = creaBuferes(esfera(32));
    glEnable(GL_DEPTH_TEST);
}

static void dibujaEscena(const glm::mat4 &proyeccion, const glm::mat4 &camara) {
    const auto pon = [](const Buferes &solido, const glm::mat4 &M, const glm::vec3 &color) {
        dibujaObjeto(estado.programa, solido, M, color);
    };
    envia(estado.programa, "proyeccion", proyeccion);
    envia(estado.programa, "camara", camara);
    pon(estado.cubo, traslacion({0, -0.1f, 0}) * escalado({6, 0.2f, 6}), SUELO);
    pon(estado.cubo, traslacion({0, 0.75f, 0}) * escalado({0.3f, 1.5f, 0.3f}), GRIS);
    pon(estado.esfera, traslacion(INTERES) * escalado(0.35f), AMARILLO);
    pon(estado.cubo, traslacion({-2, 0.9f, -1.2f}) * escalado(1.8f), ROJO);
    pon(estado.cono, traslacion({1.9f, 0, -1}) * giroX(-glm::half_pi<float>()) * escalado({1, 1, 2.8f}),
        VERDE);
    pon(estado.cubo, traslacion({0.9f, 0.4f, 2}) * giroY(0.5f) * escalado({1.6f, 0.8f, 0.8f}), AZUL);
}

// La cámara con sus datos (p, i, UP) y sus ejes, y el comienzo de su pirámide de visión.
static void dibujaCamara(const glm::mat4 &aRecortado, const glm::dvec3 &p, const glm::dvec3 &UP, double theta,
                         double aspecto) {
    const glm::mat4 alMundo(glm::inverse(transformacionCamara(p, INTERES, UP)));
    for (const PiezaCamara &pieza : piezasCamara())
        dibujaObjeto(estado.programa, pieza.esRedonda ? estado.cilindro : estado.cubo,
                     alMundo * escalado(1.3f) * pieza.M, pieza.color);
    const glm::vec3 ojo(p), interes(INTERES);
    const double y = LARGO_PIRAMIDE * std::tan(theta / 2);
    const double x = aspecto * y;
    std::vector<glm::vec3> marco, lados;
    for (const glm::dvec2 &e : {glm::dvec2(x, y), {-x, y}, {-x, -y}, {x, -y}}) {
        marco.push_back(alMundo * glm::vec4(e.x, e.y, -LARGO_PIRAMIDE, 1));
        lados.insert(lados.end(), {ojo, marco.back()});
    }
    trazaSegmentos(lados, aRecortado, GRIS, 3);
    trazaPolilinea(marco, aRecortado, GRIS, 4, true);
    trazaSegmentos({ojo, interes}, aRecortado, OSCURO, 3);

    glDisable(GL_DEPTH_TEST); // las flechas y los rótulos, aunque algo los tape
    const auto [S, U, F] = baseCamara(p, INTERES, UP);
    const auto flecha = [&](const glm::dvec3 &v, const glm::vec3 &color, const char *nombre,
                            float grosor = 8) {
        trazaFlecha(ojo, glm::vec3(p + v), aRecortado, color, grosor);
        rotulaPunto(nombre, glm::vec3(p + 1.3 * v), aRecortado, color, Lado::CENTRO);
    };
    if (estado.inclinacion != 0) // de dónde viene
        trazaFlecha(ojo, glm::vec3(p + LARGO_UP * glm::normalize(VISTAS[estado.elegido].UP)), aRecortado,
                    GRIS, 6);
    flecha(LARGO_UP * glm::normalize(UP), NARANJA, "UP", 16); // la que asoma si van juntas
    flecha(LARGO_EJE * S, ROJO, "S");
    flecha(LARGO_EJE * U, VERDE, "U");
    flecha(LARGO_EJE * F, AZUL, "F");
    trazaPuntos({ojo, interes}, aRecortado, OSCURO);
    rotulaPunto("p", ojo, aRecortado, OSCURO, Lado::DEBAJO);
    rotulaPunto("i", interes, aRecortado, OSCURO, Lado::DEBAJO);
    glEnable(GL_DEPTH_TEST);
}

static void dibuja() {
    abreRecuadro(ventanaEntera());
    ponFondo(GRIS);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(estado.programa);
    const std::vector<Recuadro> paneles = reparte(2);
    const float aspectoPanel = aspecto(paneles[1]);
    const double theta = anguloVertical(ANGULO, aspectoPanel);
    const auto &v = VISTAS[estado.elegido];
    const glm::dvec3 F = baseCamara(v.p, INTERES, v.UP).F;
    const glm::dvec3 UP(glm::rotate(glm::dmat4(1), estado.inclinacion, F) * glm::dvec4(v.UP, 0));

    abreRecuadro(paneles[0]);
    ponFondo(FONDO_CLARO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 proyeccion = perspectivaVentana(0.57f, 1, 100, aspecto(paneles[0]), 1),
                    camara = camaraOrbita(estado.orbita);
    dibujaEscena(proyeccion, camara);
    dibujaCamara(proyeccion * camara, v.p, UP, theta, aspectoPanel);

    abreRecuadro(paneles[1]);
    ponFondo(CIELO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    dibujaEscena(glm::mat4(proyeccionPerspectiva(theta, aspectoPanel, CERCA, LEJOS)),
                 glm::mat4(transformacionCamara(v.p, INTERES, UP)));
    rotula("lo que ve", {0.5f, 0.96f}, OSCURO);
    ponTitulo("La cámara: vista " + std::to_string(estado.elegido + 1));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    if (eligeModo(estado.elegido, 4, tecla))
        estado.inclinacion = 0;
    else if (tecla == 'i')
        estado.inclinacion -= PASO;
    else if (tecla == 'o')
        estado.inclinacion += PASO;
    else
        return;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "La cámara", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
