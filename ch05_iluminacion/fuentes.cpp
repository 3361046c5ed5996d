// Los tipos de fuente de luz de §5.2 (figuras 5.4 y 5.5): posicional, que alumbra en todas las direcciones
// desde un punto; direccional, de rayos paralelos; y foco, una posicional que solo alumbra dentro de un cono
// y se concentra alrededor de su eje según un exponente. No hay sombras: son el capítulo 7.
// Controles: 1 posicional · 2 direccional · 3 foco · + - exponente del foco · ratón orbita · Esc termina.
#include "ch03_transformaciones/transformaciones.h"
#include "iluminacion.h"
#include "malla.h"
#include "orbita.h"
#include "ventana.h"
#include <algorithm>
#include <cmath>

static const glm::vec3 La(1), POSICION(-0.9f, 3.3f, 1.1f), APUNTA(0.3f, 0, 0);
static const float DELTA = 0.52f, RECTO = 1.57079633f; // radianes
static const float EXPONENTE_MAXIMO = 64;

static const Material suelo = {{0.13f, 0.14f, 0.16f}, {0.62f, 0.64f, 0.68f}, {0.15f, 0.15f, 0.15f}, 20};
static const Material rojo = {{0.18f, 0.05f, 0.05f}, {0.75f, 0.18f, 0.16f}, {0.60f, 0.60f, 0.60f}, 50};
static const Material verde = {{0.05f, 0.15f, 0.07f}, {0.18f, 0.62f, 0.28f}, {0.50f, 0.50f, 0.50f}, 50};
static const Material azul = {{0.05f, 0.10f, 0.20f}, {0.16f, 0.40f, 0.80f}, {0.60f, 0.60f, 0.60f}, 50};
static const Material naranja = {{0.19f, 0.11f, 0.03f}, {0.80f, 0.46f, 0.10f}, {0.50f, 0.50f, 0.50f}, 50};
static const Material encendido = {{1.00f, 0.93f, 0.60f}, {0, 0, 0}, {0, 0, 0}, 1}; // la propia fuente

static struct {
    GLuint programa;
    Buferes plano, esfera, cono, toro, cubo, cilindro;
    Orbita orbita = {0.35f, 0.5f, 16, {0, 0.75f, 0}};
    int tipo = 1;
    float exponente = 4;
} estado;

static void inicia() {
    estado.programa =
        creaPrograma("ch05_iluminacion/sombreado_phong.vert", "ch05_iluminacion/sombreado_phong.frag");
    const int n = segmentosPara(120, 0.1f);
    estado.plano = creaBuferes(plano(1));
    estado.esfera = creaBuferes(esfera(n));
    estado.cono = creaBuferes(cono(n));
    estado.toro = creaBuferes(toro(0.7f, 0.25f, n, n / 2));
    estado.cubo = creaBuferes(cubo());
    estado.cilindro = creaBuferes(cilindro(n));
    glEnable(GL_DEPTH_TEST);
    glClearColor(0.16f, 0.17f, 0.20f, 1);
}

static void dibujaObjeto(const Buferes &objeto, const glm::mat4 &M, const Material &material) {
    const glm::mat3 N = matrizNormal(camaraOrbita(estado.orbita) * M);
    envia(estado.programa, "M", M);
    envia(estado.programa, "N", N);
    enviaMaterial(estado.programa, material);
    dibuja(objeto);
}

/// Lleva el origen a `punta` y el eje Z a la dirección contraria a S.
static glm::mat4 haciaS(const glm::vec3 &punta, const glm::vec3 &S) {
    const glm::mat3 R = glm::transpose(cambioDeBase(-S)); // su primera columna es -S
    return glm::mat4(glm::vec4(R[1], 0), glm::vec4(R[2], 0), glm::vec4(R[0], 0), glm::vec4(punta, 1));
}

static void dibujaFuente(const glm::vec3 &S) {
    if (estado.tipo == 1)
        dibujaObjeto(estado.esfera, traslacion(POSICION) * escalado(0.22f), encendido);
    if (estado.tipo == 2)
        for (const glm::vec3 &p : {glm::vec3(-0.7f, 0, -0.5f), {0, 0, 0}, {0.7f, 0, 0.5f}}) {
            const glm::mat4 flecha = haciaS(POSICION + p + 0.4f * S, S);
            dibujaObjeto(estado.cono, flecha * escalado({0.16f, 0.16f, -0.4f}) * traslacion({0, 0, -1}),
                         encendido);
            dibujaObjeto(estado.cilindro, flecha * traslacion({0, 0, 0.8f}) * escalado({0.05f, 0.05f, 0.8f}),
                         encendido);
        }
    if (estado.tipo == 3)
        dibujaObjeto(estado.cono,
                     haciaS(POSICION, S) * traslacion({0, 0, -0.15f}) * escalado({0.3f, 0.3f, 0.6f}),
                     encendido);
}

static void dibuja() {
    const glm::vec3 S = glm::normalize(APUNTA - POSICION);
    Luz luz{glm::vec4(POSICION, 1)};
    if (estado.tipo == 2)
        luz.Lp = glm::vec4(-S, 0);
    if (estado.tipo == 3) {
        luz.S = S;
        luz.cosDelta = std::cos(DELTA);
        luz.exponente = estado.exponente;
    }

    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    const glm::mat4 vista = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.35f, 1, 100);
    envia(estado.programa, "vista", vista);
    envia(estado.programa, "proyeccion", proyeccion);
    envia(estado.programa, "La", La);
    enviaLuz(estado.programa, "luz", luz, vista);
    dibujaObjeto(estado.plano, giroX(-RECTO) * escalado(7), suelo);
    dibujaObjeto(estado.esfera, traslacion({0.3f, 0.8f, 0.2f}) * escalado(0.8f), rojo);
    dibujaObjeto(estado.cono, traslacion({2.1f, 0, -1.2f}) * giroX(-RECTO) * escalado({0.8f, 0.8f, 1.9f}),
                 verde);
    dibujaObjeto(estado.cubo, traslacion({-1.7f, 0.6f, -1.1f}) * giroY(0.5f) * escalado(1.2f), azul);
    dibujaObjeto(estado.toro, traslacion({1.5f, 0.25f, 1.9f}) * giroX(-RECTO), naranja);
    dibujaFuente(S);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    switch (tecla) {
    case '1':
    case '2':
    case '3': estado.tipo = tecla - '0'; break;
    case '+': estado.exponente = std::min(2 * estado.exponente, EXPONENTE_MAXIMO); break;
    case '-': estado.exponente = std::max(estado.exponente / 2, 0.5f); break;
    default: return;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Tipos de fuentes de luz", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
