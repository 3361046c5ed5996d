// Giro alrededor de un eje cualquiera por cambio de base (§3.4, ecuaciones 3.9 y 3.10): el eje d (rojo) y los
// vectores e (verde) y f (azul) que completan la base, el objeto girado, el de partida (pálido) y la
// circunferencia que recorre. El giro se recalcula siempre desde el ángulo: multiplicar un giro tras otro
// acumula error (tests/ch03_giro_test.cpp).
// Controles: a d giran · 1 2 3 4 ejes Y, diagonal, oblicuo y casi X · ratón izquierdo mueve el eje · ratón derecho orbita · Esc termina.
#include "malla.h"
#include "orbita.h"
#include "shader.h"
#include "transformaciones.h"
#include "ventana.h"
#include <cmath>

static const float VUELTA = 6.28318530718f;
static const float PASO_GIRO = 0.1f, PASO_CUENTAS = 0.2f; // radianes
static const float RADIANES_POR_PIXEL = 0.01f;
static const glm::vec3 ejes[] = {{0, 1, 0}, {1, 1, 1}, {-0.6f, 0.7f, 0.4f}, {1, 1e-10f, 0}};
static const glm::vec3 sitio(-1.1f, 0.2f, 1.2f); // el centro del avión, sin girar

static const glm::vec3 fondo(0.95f, 0.96f, 0.98f), rojo(0.85f, 0.20f, 0.18f), verde(0.20f, 0.62f, 0.28f),
    azul(0.16f, 0.38f, 0.80f), naranja(0.95f, 0.55f, 0.10f), amarillo(0.98f, 0.78f, 0.15f),
    gris(0.55f, 0.58f, 0.62f), oscuro(0.16f, 0.17f, 0.20f);

static struct {
    GLuint programa;
    Buferes cubo, esfera, cilindro, cono, aro;
    glm::vec3 eje = ejes[0]; // sin normalizar
    float angulo = 2;        // radianes
    bool moviendoEje = false;
    int xAnterior = 0, yAnterior = 0;
    Orbita orbita = {-0.5f, 0.4f, 7};
} estado;

static void inicia() {
    estado.programa = creaPrograma("ch03_transformaciones/objeto.vert", "ch03_transformaciones/objeto.frag");
    estado.cubo = creaBuferes(cubo());
    estado.esfera = creaBuferes(esfera(16));
    estado.cilindro = creaBuferes(cilindro(16));
    estado.cono = creaBuferes(cono(24));
    estado.aro = creaBuferes(toro(1, 0.018f, 96, 12));
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE); // las caras de detrás nunca se ven: los sólidos son cerrados
    glClearColor(fondo.r, fondo.g, fondo.b, 1);
}

static void dibujaMalla(const Buferes &malla, const glm::mat4 &M, const glm::vec3 &color) {
    const glm::mat3 N = matrizNormal(M);
    envia(estado.programa, "M", M);
    envia(estado.programa, "N", N);
    envia(estado.programa, "colorObjeto", color);
    dibuja(malla);
}

static void dibujaFlecha(const glm::vec3 &direccion, float largo, const glm::vec3 &color) {
    const float punta = 0.25f, grueso = 0.045f;
    const glm::mat4 base = haciaDireccion(direccion);
    dibujaMalla(estado.cilindro, base * escalado({grueso, grueso, largo - punta}) * traslacion({0, 0, 0.5f}),
                color);
    dibujaMalla(estado.cono,
                base * traslacion({0, 0, largo - punta}) * escalado({2.5f * grueso, 2.5f * grueso, punta}),
                color);
}

// `viveza` 0 lo deja del color del fondo.
static void dibujaAvion(const glm::mat4 &M, float viveza) {
    const struct {
        glm::vec3 centro, lados, color;
    } piezas[] = {{{0, 0, 0}, {1.1f, 0.22f, 0.22f}, naranja},
                  {{0.1f, 0, 0}, {0.32f, 0.08f, 1.3f}, amarillo},
                  {{-0.45f, 0, 0}, {0.18f, 0.06f, 0.5f}, amarillo},
                  {{-0.42f, 0.22f, 0}, {0.2f, 0.34f, 0.07f}, rojo}};
    for (const auto &p : piezas)
        dibujaMalla(estado.cubo, M * traslacion(p.centro) * escalado(p.lados),
                    glm::mix(fondo, p.color, viveza));
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    const glm::mat4 camara = perspectivaVentana(0.6f, 1, 30) * camaraOrbita(estado.orbita);
    envia(estado.programa, "camara", camara);

    const glm::vec3 d = unitario(estado.eje);
    const glm::mat3 base = glm::transpose(cambioDeBase(d)); // d, e y f, que eran filas, son columnas
    dibujaMalla(estado.cilindro, haciaDireccion(d) * escalado({0.03f, 0.03f, 3.9f}), oscuro);
    dibujaFlecha(base[0], 1.5f, rojo);
    dibujaFlecha(base[1], 0.9f, verde);
    dibujaFlecha(base[2], 0.9f, azul);

    dibujaAvion(traslacion(sitio), 0.3f);
    dibujaAvion(giroEje(d, estado.angulo) * traslacion(sitio), 1);

    // El sitio gira en un plano perpendicular a d que corta al eje en `centro`.
    const glm::vec3 centro = glm::dot(sitio, d) * d;
    dibujaMalla(estado.aro, traslacion(centro) * haciaDireccion(d) * escalado(glm::distance(sitio, centro)),
                gris);
    for (float a = 0; a < std::fabs(estado.angulo); a += PASO_CUENTAS) {
        const glm::mat4 giro = giroEje(d, std::copysign(a, estado.angulo));
        dibujaMalla(estado.esfera, giro * traslacion(sitio) * escalado(0.06f), oscuro);
    }
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    if (tecla == 'a' || tecla == 'd') // dentro de una vuelta: un ángulo grande no tiene decimales
        estado.angulo = std::remainder(estado.angulo + (tecla == 'a' ? PASO_GIRO : -PASO_GIRO), VUELTA);
    else if (tecla >= '1' && tecla <= '4')
        estado.eje = ejes[tecla - '1'];
    else
        return;
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
    const glm::vec2 angulos = RADIANES_POR_PIXEL * glm::vec2(x - estado.xAnterior, y - estado.yAnterior);
    estado.eje =
        glm::mat3(giroEje(pantalla[0], angulos.y) * giroEje(pantalla[1], angulos.x)) * unitario(estado.eje);
    estado.xAnterior = x;
    estado.yAnterior = y;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Giro alrededor de un eje", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMouseFunc(boton);
    glutMotionFunc(arrastra);
    glutMainLoop();
    return 0;
}
