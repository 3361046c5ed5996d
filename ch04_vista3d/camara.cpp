// La transformación de la cámara (ecuación 4.1, figura 4.1): a la izquierda, la cámara vista desde fuera, con su
// posición, su punto de interés (amarillo), su vector de inclinación UP (naranja) y los ejes S (rojo), U (verde) y
// F (azul) que salen de ellos; a la derecha, lo que ve. El libro no dice qué pasa si UP es paralelo a F: aquí
// siempre hay base (vista.h), y la cuarta vista, con UP a 1e-7 de F, sale como las demás.
// Controles: 1 2 3 vistas · 4 UP casi paralelo · i o inclinan · ratón orbita por fuera · Esc termina.
#include "malla.h"
#include "orbita.h"
#include "piezas.h"
#include "shader.h"
#include "ventana.h"
#include <glm/gtc/matrix_transform.hpp>

static const float PASO = 0.1f;    // radianes
static const double ANGULO = 0.85; // de la cámara, en radianes
static const double CERCA = 0.5, LEJOS = 60;
static const glm::dvec3 interes(0, 1.7, 0);

static const struct {
    glm::dvec3 p, UP;
} vistas[] = {{{5.2, 4.8, 0.2}, {0, 1, 0}},
              {{-4.3, 1.4, 2.6}, {0, 1, 0}},
              {{0.4, 7.2, 0.8}, {0, 0, -1}},
              {{2.4, 5.4, 2.0}, {-2.4, -3.7, -2.0 + 1e-7}}};

static const glm::vec3 rojo(0.85f, 0.20f, 0.18f), verde(0.20f, 0.62f, 0.28f), azul(0.16f, 0.38f, 0.80f),
    naranja(0.95f, 0.55f, 0.10f), amarillo(0.98f, 0.78f, 0.15f), gris(0.55f, 0.58f, 0.62f),
    oscuro(0.16f, 0.17f, 0.20f), suelo(0.80f, 0.86f, 0.78f);

static struct {
    GLuint programa;
    Buferes cubo, cilindro, cono, esfera;
    int vista = 0;
    double inclinacion = 0; // radianes alrededor de F
    Orbita orbita = {-0.70f, 0.32f, 18, {0, 2.7f, 0}};
} estado;

static void inicia() {
    estado.programa = creaPrograma("ch03_transformaciones/objeto.vert", "ch03_transformaciones/objeto.frag");
    estado.cubo = creaBuferes(cubo());
    estado.cilindro = creaBuferes(cilindro(24));
    estado.cono = creaBuferes(cono(32));
    estado.esfera = creaBuferes(esfera(32));
    glEnable(GL_DEPTH_TEST);
}

static void dibujaMalla(const Buferes &malla, const glm::mat4 &M, const glm::vec3 &color) {
    const glm::mat3 N = matrizNormal(M);
    envia(estado.programa, "M", M);
    envia(estado.programa, "N", N);
    envia(estado.programa, "colorObjeto", color);
    dibuja(malla);
}

static void dibujaFlecha(const glm::vec3 &a, const glm::vec3 &b, const glm::vec3 &color) {
    dibujaMalla(estado.cilindro, segmento(a, b - 0.3f * unitario(b - a), 0.09f), color);
    dibujaMalla(estado.cono, punta(a, b, 0.25f), color);
}

static void dibujaEscena() {
    dibujaMalla(estado.cubo, traslacion({0, -0.1f, 0}) * escalado({8, 0.2f, 8}), suelo);
    dibujaMalla(estado.cubo, traslacion({0, 0.75f, 0}) * escalado({0.3f, 1.5f, 0.3f}), gris);
    dibujaMalla(estado.esfera, traslacion(interes) * escalado(0.35f), amarillo);
    dibujaMalla(estado.cubo, traslacion({-2, 0.9f, -1.2f}) * escalado(1.8f), rojo);
    dibujaMalla(estado.cono, traslacion({2.2f, 0, -1}) * giroX(-1.5708f) * escalado({1, 1, 2.8f}), verde);
    dibujaMalla(estado.cubo, traslacion({0.9f, 0.4f, 2}) * giroY(0.5f) * escalado({1.6f, 0.8f, 0.8f}), azul);
}

// La cámara con sus datos (p, i, UP) y sus ejes, y el comienzo de su pirámide de visión.
static void dibujaCamara(const glm::dvec3 &p, const glm::dvec3 &UP, double theta, double aspecto) {
    const glm::mat4 alMundo(glm::inverse(transformacionCamara(p, interes, UP)));
    for (const PiezaCamara &pieza : piezasCamara())
        dibujaMalla(pieza.esRedonda ? estado.cilindro : estado.cubo, alMundo * escalado(1.4f) * pieza.M,
                    pieza.color);
    const glm::vec3 ojo(p);
    const auto [S, U, F] = baseCamara(p, interes, UP);
    dibujaFlecha(ojo, ojo + 2.0f * glm::vec3(S), rojo);
    dibujaFlecha(ojo, ojo + 2.0f * glm::vec3(U), verde);
    dibujaFlecha(ojo, ojo + 2.0f * glm::vec3(F), azul);
    dibujaFlecha(ojo, ojo + 3.0f * glm::vec3(glm::normalize(UP)), naranja);
    dibujaMalla(estado.cilindro, segmento(ojo, interes, 0.045f), oscuro);
    const double y = 3 * std::tan(theta / 2), x = aspecto * y;
    const glm::dvec3 esquinas[] = {{x, y, -3}, {-x, y, -3}, {-x, -y, -3}, {x, -y, -3}};
    for (int k = 0; k < 4; ++k) {
        const glm::vec3 a = alMundo * glm::dvec4(esquinas[k], 1),
                        b = alMundo * glm::dvec4(esquinas[(k + 1) % 4], 1);
        dibujaMalla(estado.cilindro, segmento(ojo, a, 0.03f), gris);
        dibujaMalla(estado.cilindro, segmento(a, b, 0.05f), oscuro);
    }
}

static void abrePanel(int x, int ancho, int alto, const glm::vec3 &fondo, const glm::mat4 &camara) {
    glViewport(x, 0, ancho, alto);
    glScissor(x, 0, ancho, alto);
    glClearColor(fondo.r, fondo.g, fondo.b, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    envia(estado.programa, "camara", camara);
}

static void dibuja() {
    const int ancho = glutGet(GLUT_WINDOW_WIDTH), alto = glutGet(GLUT_WINDOW_HEIGHT), izquierda = ancho / 2,
              derecha = ancho - izquierda;
    const double aspecto = std::max(derecha, 1) / static_cast<double>(std::max(alto, 1));
    const double theta = anguloEnY(ANGULO, aspecto);
    const auto &v = vistas[estado.vista];
    const glm::dvec3 F = baseCamara(v.p, interes, v.UP).F;
    const glm::dvec3 UP(glm::rotate(glm::dmat4(1), estado.inclinacion, F) * glm::dvec4(v.UP, 0));

    glUseProgram(estado.programa);
    glEnable(GL_SCISSOR_TEST);
    abrePanel(0, izquierda, alto, {0.95f, 0.96f, 0.98f},
              perspectivaVentana(0.54f, 1, 100, static_cast<float>(aspecto)) * camaraOrbita(estado.orbita));
    dibujaEscena();
    dibujaCamara(v.p, UP, theta, aspecto);
    abrePanel(izquierda, derecha, alto, {0.72f, 0.85f, 0.95f},
              proyeccionPerspectiva(theta, aspecto, CERCA, LEJOS) * transformacionCamara(v.p, interes, UP));
    dibujaEscena();
    glDisable(GL_SCISSOR_TEST);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    switch (tecla) {
    case '1':
    case '2':
    case '3':
    case '4':
        estado.vista = tecla - '1';
        estado.inclinacion = 0;
        break;
    case 'i': estado.inclinacion -= PASO; break;
    case 'o': estado.inclinacion += PASO; break;
    default: return;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Transformación de la cámara", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
