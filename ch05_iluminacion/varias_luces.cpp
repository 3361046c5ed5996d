// Varias fuentes de luz, cada una con sus propios coeficientes (ecuación 5.7): un foco rojo, uno verde y uno
// azul sobre objetos blancos. Las luces se suman: rojo y verde dan amarillo, y los tres juntos blanco. La luz
// ambiente se cuenta una sola vez. Una luz se apaga con Ld = Ls = 0.
// Controles: 1 2 3 encienden y apagan cada luz · ratón orbita · Esc termina.
#include "ch03_transformaciones/transformaciones.h"
#include "iluminacion.h"
#include "malla.h"
#include "orbita.h"
#include "ventana.h"
#include <cmath>

static const int LUCES = 3;
static const float DELTA = 0.40f, RECTO = 1.57079633f; // radianes
static const glm::vec3 La(1);
static const glm::vec3 COLORES[LUCES] = {{1.0f, 0.08f, 0.05f}, {0.08f, 1.0f, 0.10f}, {0.06f, 0.12f, 1.0f}};
static const float EXPONENTES[LUCES] = {2, 3, 4};

static const Material blanco = {{0.13f, 0.13f, 0.14f}, {0.80f, 0.80f, 0.80f}, {0, 0, 0}, 1};
static const Material brillante = {{0.12f, 0.12f, 0.13f}, {0.60f, 0.60f, 0.60f}, {0.30f, 0.30f, 0.30f}, 40};

static struct {
    GLuint programa;
    Buferes plano, esfera;
    Orbita orbita = {0, 0.8f, 14, {0, 0.2f, 0}};
    bool encendida[LUCES] = {true, true, true};
} estado;

static void inicia() {
    estado.programa =
        creaPrograma("ch05_iluminacion/sombreado_phong.vert", "ch05_iluminacion/varias_luces.frag");
    estado.plano = creaBuferes(plano(1));
    estado.esfera = creaBuferes(esfera(segmentosPara(130, 0.1f)));
    glEnable(GL_DEPTH_TEST);
    glClearColor(0.10f, 0.11f, 0.13f, 1);
}

/// Los tres focos salen de un círculo y apuntan cerca de su centro, donde se cruzan.
static Luz foco(int i) {
    const float angulo = glm::radians(-150 + 120 * static_cast<float>(i));
    const glm::vec3 hacia(std::cos(angulo), 0, -std::sin(angulo));
    const glm::vec3 posicion = 3.0f * hacia + glm::vec3(0, 5, 0), apunta = 1.1f * hacia;
    Luz luz{glm::vec4(posicion, 1)};
    luz.Ld = luz.Ls = estado.encendida[i] ? COLORES[i] : glm::vec3(0);
    luz.atenuacion = {0.6f, 0.04f, 0.01f};
    luz.S = glm::normalize(apunta - posicion);
    luz.cosDelta = std::cos(DELTA);
    luz.exponente = EXPONENTES[i];
    return luz;
}

static void dibujaObjeto(const Buferes &objeto, const glm::mat4 &M, const Material &material) {
    const glm::mat3 N = matrizNormal(camaraOrbita(estado.orbita) * M);
    envia(estado.programa, "M", M);
    envia(estado.programa, "N", N);
    enviaMaterial(estado.programa, material);
    dibuja(objeto);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    const glm::mat4 vista = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.36f, 1, 100);
    envia(estado.programa, "vista", vista);
    envia(estado.programa, "proyeccion", proyeccion);
    envia(estado.programa, "La", La);
    for (int i = 0; i < LUCES; ++i)
        enviaLuz(estado.programa, "luces[" + std::to_string(i) + "]", foco(i), vista);
    dibujaObjeto(estado.plano, giroX(-RECTO) * escalado(9), blanco);
    dibujaObjeto(estado.esfera, traslacion({0, 0.8f, 0}) * escalado(0.8f), brillante);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla < '1' || tecla > '3')
        return;
    bool &encendida = estado.encendida[tecla - '1'];
    encendida = !encendida;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Varias fuentes de luz", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
