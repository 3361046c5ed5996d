// Giro alrededor de un eje cualquiera por cambio de base (§3.4, ecuaciones 3.9 y 3.10): el eje d (rojo) y los
// vectores e (verde) y f (azul) que completan la base, el objeto girado, el de partida (pálido) y la
// circunferencia que recorre. El giro se recalcula siempre desde el ángulo: multiplicar un giro tras otro
// acumula error (tests/capitulos/ch03_giro_test.cpp).
// Controles: a d giran · 1 2 3 4 ejes Y, diagonal, oblicuo y casi X · ratón izquierdo mueve el eje
// · ratón derecho orbita · Esc termina.
#include "colores.h"
#include "objeto.h"
#include "orbita.h"
#include "rotulo.h"
#include "trazo.h"
#include "ventana.h"
#include <cmath>
#include <cstdio>
#include <glm/gtc/constants.hpp>

static const float PASO_GIRO = 0.1f;         // radianes
static const float RADIANES_POR_ALTO = 1.8f; // arrastrando de abajo arriba de la ventana
static const glm::vec3 EJES[] = {{0, 1, 0}, {1, 1, 1}, {-0.6f, 0.7f, 0.4f}, {1, 1e-10f, 0}};
static const glm::vec3 SITIO(-1.1f, 0.2f, 1.2f); // el centro del avión, sin girar
static const int PUNTOS_ARO = 96;

static struct {
    GLuint programa;
    Buferes cubo;
    glm::vec3 eje = EJES[0]; // sin normalizar
    float angulo = 2;        // radianes
    bool moviendoEje = false;
    int xAnterior = 0, yAnterior = 0;
    Orbita orbita = {-0.5f, 0.4f, 8};
} estado;

static void inicia() {
    estado.programa = creaProgramaObjeto();
    estado.cubo = creaBuferes(cubo());
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE); // las caras de detrás nunca se ven: los sólidos son cerrados
    glClearColor(FONDO_CLARO.r, FONDO_CLARO.g, FONDO_CLARO.b, 1);
}

// `viveza` 0 lo deja del color del fondo.
static void dibujaAvion(const glm::mat4 &M, float viveza) {
    const struct {
        glm::vec3 centro, lados, color;
    } piezas[] = {{{0, 0, 0}, {1.1f, 0.22f, 0.22f}, NARANJA},
                  {{0.1f, 0, 0}, {0.32f, 0.08f, 1.3f}, AMARILLO},
                  {{-0.45f, 0, 0}, {0.18f, 0.06f, 0.5f}, AMARILLO},
                  {{-0.42f, 0.22f, 0}, {0.2f, 0.34f, 0.07f}, ROJO}};
    for (const auto &p : piezas)
        dibujaObjeto(estado.programa, estado.cubo, M * traslacion(p.centro) * escalado(p.lados),
                     glm::mix(FONDO_CLARO, p.color, viveza));
}

static std::string describeGiro() {
    char texto[80];
    const glm::dvec3 d(estado.eje);
    std::snprintf(texto, sizeof texto, "%.0f° alrededor de (%.3g, %.3g, %.3g)",
                  glm::degrees(static_cast<double>(estado.angulo)), d.x, d.y, d.z);
    return texto;
}

// Los puntos por los que pasa el sitio del avión al girar hasta `angulo`.
static std::vector<glm::vec3> arco(const glm::vec3 &d, float angulo) {
    std::vector<glm::vec3> puntos;
    for (int i = 0; i <= PUNTOS_ARO; ++i)
        puntos.push_back(giroEje(d, angulo * static_cast<float>(i) / PUNTOS_ARO) * glm::vec4(SITIO, 1));
    return puntos;
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 camara = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.6f, 1, 30);
    const glm::mat4 alPanel = proyeccion * camara;
    glUseProgram(estado.programa);
    envia(estado.programa, "proyeccion", proyeccion);
    envia(estado.programa, "camara", camara);

    const glm::vec3 d = unitario(estado.eje);
    dibujaAvion(traslacion(SITIO), 0.3f);
    dibujaAvion(giroEje(d, estado.angulo) * traslacion(SITIO), 1);

    const glm::mat3 base = glm::transpose(cambioDeBase(d)); // d, e y f, que eran filas, son columnas
    const char *const nombres[] = {"d", "e", "f"};
    trazaSegmentos({-1.95f * d, 1.95f * d}, alPanel, OSCURO, 4);
    for (int i = 0; i < 3; ++i) {
        const glm::vec3 punta = (i == 0 ? 1.5f : 0.9f) * base[i];
        trazaFlecha(glm::vec3(0), punta, alPanel, COLOR_EJE[i], 8);
        rotulaPunto(nombres[i], punta, alPanel, COLOR_EJE[i], Lado::DERECHA);
    }
    trazaPolilinea(arco(d, glm::two_pi<float>()), alPanel, GRIS, 3);
    trazaPolilinea(arco(d, estado.angulo), alPanel, OSCURO, 8);
    rotula(describeGiro(), {0.5f, 0.05f}, OSCURO);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    if (tecla == 'a' || tecla == 'd') // dentro de una vuelta: un ángulo grande no tiene decimales
        estado.angulo =
            std::remainder(estado.angulo + (tecla == 'a' ? PASO_GIRO : -PASO_GIRO), glm::two_pi<float>());
    else if (tecla >= '1' && tecla <= '4')
        estado.eje = EJES[tecla - '1'];
    else
        return;
    ponTitulo("Giro de " + describeGiro());
    glutPostRedisplay();
}

static void boton(int cual, int pulsado, int x, int y) {
    estado.moviendoEje = cual == GLUT_LEFT_BUTTON && pulsado == GLUT_DOWN;
    estado.xAnterior = x;
    estado.yAnterior = y;
    if (cual == GLUT_RIGHT_BUTTON)
        orbitaBoton(GLUT_LEFT_BUTTON, pulsado, x, y);
}

// El eje gira con el ratón alrededor de la vertical y de la horizontal de la pantalla, que en el mundo son
// las dos primeras filas de la vista.
static void arrastra(int x, int y) {
    if (!estado.moviendoEje)
        return orbitaArrastra(x, y);
    const glm::mat3 pantalla = glm::transpose(glm::mat3(camaraOrbita(estado.orbita)));
    const glm::vec2 angulos =
        RADIANES_POR_ALTO / altoUtil() * glm::vec2(x - estado.xAnterior, y - estado.yAnterior);
    estado.eje =
        glm::mat3(giroEje(pantalla[0], angulos.y) * giroEje(pantalla[1], angulos.x)) * unitario(estado.eje);
    estado.xAnterior = x;
    estado.yAnterior = y;
    ponTitulo("Giro de " + describeGiro());
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Giro de 115° alrededor de (0, 1, 0)",
                GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMouseFunc(boton);
    glutMotionFunc(arrastra);
    glutMainLoop();
    return 0;
}
