// Los tipos de fuente de luz de §5.2 (figuras 5.4 y 5.5): posicional, que alumbra en todas las direcciones desde un
// punto; direccional, de rayos paralelos; y foco, una posicional que solo alumbra dentro de un cono, de eje S y ángulo
// δ, y se concentra alrededor de su eje según un exponente. No hay sombras: son el capítulo 7.
// Controles: 1 posicional · 2 direccional · 3 foco · + - exponente del foco · , . ángulo de su cono ·
// ratón orbita · Esc termina.
#include "buferes.h"
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
#include "texto.h"
#include "trazo.h"
#include "ventana.h"
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

enum Tipo { POSICIONAL, DIRECCIONAL, FOCO };

static const glm::vec3 POSICION(-0.9f, 3.3f, 1.1f), APUNTA(0.3f, 0, 0);
static const glm::vec3 S = glm::normalize(APUNTA - POSICION);
static const float EXPONENTE_MINIMO = 0.5f, EXPONENTE_MAXIMO = 64;
static const int DELTA_MAXIMO = 90, PASO_DELTA = 5; // grados
static const float GENERATRIZ = 1.4f;               // lo que se dibuja del cono

static const Material SUELO_GRIS = {{0.20f, 0.21f, 0.23f}, {0.62f, 0.64f, 0.68f}, {0.15f, 0.15f, 0.15f}, 20};
static const Material ROJA = {{0.18f, 0.05f, 0.05f}, {0.75f, 0.18f, 0.16f}, {0.60f, 0.60f, 0.60f}, 50};
static const Material VERDOSO = {{0.05f, 0.15f, 0.07f}, {0.18f, 0.62f, 0.28f}, {0.50f, 0.50f, 0.50f}, 50};
static const Material AZULADO = {{0.05f, 0.10f, 0.20f}, {0.16f, 0.40f, 0.80f}, {0.60f, 0.60f, 0.60f}, 50};
static const Material ANARANJADO = {{0.19f, 0.11f, 0.03f}, {0.80f, 0.46f, 0.10f}, {0.50f, 0.50f, 0.50f}, 50};

static struct {
    GLuint programa;
    Buferes plano, esfera, cono, toro, cubo;
    Orbita orbita = {0.35f, 0.5f, 19, {0, 0.75f, 0}, 0.05f};
    int elegido = POSICIONAL;
    float exponente = 4;
    int delta = 30; // grados, para que el paso sea exacto
} estado;

static float delta() {
    return glm::radians(float(estado.delta));
}

static void inicia() {
    estado.programa = creaSombreado("phong");
    estado.plano = creaBuferes(plano(1));
    estado.esfera = creaBuferes(esfera(segmentosEsfera(100)));
    estado.cono = creaBuferes(cono(segmentosEsfera(100)));
    estado.toro = creaBuferes(toro(0.7f, 0.25f, segmentosEsfera(400), segmentosEsfera(100)));
    estado.cubo = creaBuferes(cubo());
    glEnable(GL_DEPTH_TEST);
    ponFondo(FONDO_OSCURO);
}

// La figura 5.5: el eje S y el cono, de generatriz fija para que quepa con cualquier ángulo.
static void dibujaCono(const glm::mat4 &vista) {
    const glm::mat3 base = glm::transpose(cambioDeBase(S)); // su primera columna es S
    std::vector<glm::vec3> borde, generatrices;
    for (int i = 0; i < 32; ++i) {
        const float a = glm::two_pi<float>() * float(i) / 32;
        borde.push_back(POSICION +
                        GENERATRIZ * (base * glm::vec3(std::cos(delta()), std::sin(delta()) * std::cos(a),
                                                       std::sin(delta()) * std::sin(a))));
        if (i % 4 == 0)
            generatrices.insert(generatrices.end(), {POSICION, borde.back()});
    }
    trazaFlecha(POSICION, POSICION + 1.3f * GENERATRIZ * S, vista, BLANCO);
    trazaPolilinea(borde, vista, AMARILLO, GROSOR / 2, true);
    trazaSegmentos(generatrices, vista, AMARILLO, GROSOR / 2);
    rotulaPunto("S", POSICION + 1.3f * GENERATRIZ * S, vista, BLANCO, Lado::DERECHA);
    rotulaPunto("δ = " + std::to_string(estado.delta) + "°", POSICION, vista, BLANCO, Lado::IZQUIERDA);
}

static void dibujaFuente(const glm::mat4 &vista) {
    if (estado.elegido == DIRECCIONAL)
        for (const glm::vec3 &p : {glm::vec3(-0.8f, 0, -0.5f), {0, 0, 0}, {0.8f, 0, 0.5f}})
            trazaFlecha(POSICION + p, POSICION + p + GENERATRIZ * S, vista, AMARILLO);
    else
        trazaPuntos({POSICION}, vista, AMARILLO, 4 * GROSOR);
    if (estado.elegido == FOCO)
        dibujaCono(vista);
}

static void dibuja() {
    Luz luz{glm::vec4(POSICION, 1)};
    if (estado.elegido == DIRECCIONAL)
        luz.Lp = glm::vec4(-S, 0);
    if (estado.elegido == FOCO) {
        luz.S = S;
        luz.cosDelta = std::cos(delta());
        luz.exponente = estado.exponente;
    }

    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 camara = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.35f, 1, 100);
    const auto solido = [&](const Buferes &buferes, const glm::mat4 &M, const Material &material) {
        dibujaIluminado(estado.programa, buferes, M, camara, material);
    };
    const glm::mat4 tumbado = giroX(-glm::half_pi<float>());
    usaIluminado(estado.programa, camara, proyeccion, luz);
    solido(estado.plano, tumbado * escalado(6), SUELO_GRIS);
    solido(estado.esfera, traslacion({0.3f, 0.8f, 0.2f}) * escalado(0.8f), ROJA);
    solido(estado.cono, traslacion({2.0f, 0, -1.2f}) * tumbado * escalado({0.8f, 0.8f, 1.9f}), VERDOSO);
    solido(estado.cubo, traslacion({-1.7f, 0.6f, -1.1f}) * giroY(0.5f) * escalado(1.2f), AZULADO);
    solido(estado.toro, traslacion({1.5f, 0.25f, 1.9f}) * tumbado, ANARANJADO);
    dibujaFuente(proyeccion * camara);

    const std::string nombres[] = {"posicional", "direccional",
                                   formatea("foco, exponente %g", estado.exponente)};
    rotula(nombres[estado.elegido], {1, 0.95f}, BLANCO, Lado::IZQUIERDA);
    ponTitulo("Fuente de luz: " + nombres[estado.elegido]);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || eligeModo(estado.elegido, 3, tecla))
        return;
    switch (tecla) {
    case '+': estado.exponente = std::min(2 * estado.exponente, EXPONENTE_MAXIMO); break;
    case '-': estado.exponente = std::max(estado.exponente / 2, EXPONENTE_MINIMO); break;
    case ',': estado.delta = std::max(estado.delta - PASO_DELTA, 0); break;
    case '.': estado.delta = std::min(estado.delta + PASO_DELTA, DELTA_MAXIMO); break;
    default: return;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Fuentes de luz", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
