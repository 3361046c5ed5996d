// La atenuación de la luz con la distancia d a la fuente, 1/(a + b·d + c·d²) (ecuación 5.3): constante (a), lineal (b)
// y cuadrática (c). Sobre cada esfera, a distancia 1, 2… de la fuente, se alza la parte de luz que le llega; la curva
// las une. Con estos coeficientes la lineal y la cuadrática se cruzan a distancia 3, donde valen ½.
// Controles: 1 constante · 2 lineal · 3 cuadrática · ratón orbita · Esc termina.
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
#include <glm/gtc/constants.hpp>

static const int ESFERAS = 6;
static const float RADIO = 0.42f, D_MAXIMA = ESFERAS + 0.6f;
static const float PIE = 0.75f, ALTO = 2.7f; // el eje vertical de la curva
static const struct {
    const char *nombre, *formula;
    glm::vec3 abc;
} MODOS[] = {{"constante", "1", {1, 0, 0}},
             {"lineal", "1/(1 + d/3)", {1, 1 / 3.0f, 0}},
             {"cuadrática", "1/(1 + d²/9)", {1, 0, 1 / 9.0f}}};

static const Material PISO = {{0.05f, 0.05f, 0.06f}, {0.55f, 0.57f, 0.60f}, {0, 0, 0}, 1};
static const Material BOLA = {{0.26f, 0.15f, 0.04f}, {0.84f, 0.50f, 0.12f}, {0.30f, 0.30f, 0.30f}, 20};
static const Material ENCENDIDA = {{1.00f, 0.93f, 0.60f}, {0, 0, 0}, {0, 0, 0}, 1}; // la propia fuente

static struct {
    GLuint programa;
    Buferes plano, esfera;
    // de frente y de lejos: los ejes son horizontales y verticales
    Orbita orbita = {0, 0.012f, 150, {3.1f, 1.6f, 0}, 0.01f};
    int elegido = 0;
} estado;

static void inicia() {
    estado.programa = creaSombreado("phong");
    estado.plano = creaBuferes(plano(1));
    estado.esfera = creaBuferes(esfera(segmentosEsfera(90)));
    glEnable(GL_DEPTH_TEST);
    ponFondo(FONDO_OSCURO);
}

static float atenuacion(int modo, float d) {
    const glm::vec3 &abc = MODOS[modo].abc;
    return 1 / (abc.x + d * (abc.y + d * abc.z));
}

// El punto de la curva del modo a distancia d: en el plano de la fila, sobre ella.
static glm::vec3 enCurva(int modo, float d) {
    return {d, PIE + ALTO * atenuacion(modo, d), 0};
}

static void dibujaCurvas(const glm::mat4 &vista) {
    trazaFlecha({0, PIE, 0}, {0, PIE + 1.2f * ALTO, 0}, vista, BLANCO);
    trazaFlecha({0, PIE, 0}, {D_MAXIMA + 0.2f, PIE, 0}, vista, BLANCO);
    rotulaPunto("1", {0, PIE + ALTO, 0}, vista, BLANCO, Lado::IZQUIERDA);
    rotulaPunto("d", {D_MAXIMA + 0.2f, PIE, 0}, vista, BLANCO, Lado::ENCIMA);
    for (int modo = 0; modo < 3; ++modo) {
        const bool elegido = modo == estado.elegido;
        std::vector<glm::vec3> curva;
        for (int i = 0; i <= 60; ++i)
            curva.push_back(enCurva(modo, D_MAXIMA * float(i) / 60));
        trazaPolilinea(curva, vista, elegido ? AMARILLO : GRIS, elegido ? GROSOR : GROSOR / 2);
    }
    for (int d = 1; d <= ESFERAS; ++d) {
        const glm::vec3 valor = enCurva(estado.elegido, float(d));
        trazaSegmentos({{valor.x, PIE, 0}, valor}, vista, AMARILLO, GROSOR / 2);
        trazaPuntos({valor}, vista, AMARILLO);
        rotulaPunto(formatea("%.2f", atenuacion(estado.elegido, float(d))), valor, vista, AMARILLO,
                    Lado::ENCIMA, 0.03f);
        rotulaPunto(std::to_string(d), {valor.x, -RADIO - 0.1f, 0}, vista, BLANCO, Lado::DEBAJO);
    }
    rotulaPunto(std::string(MODOS[estado.elegido].nombre) + ": " + MODOS[estado.elegido].formula,
                {3, PIE + 1.28f * ALTO, 0}, vista, AMARILLO);
}

static void dibuja() {
    Luz luz{{0, 0, 0, 1}}; // la fuente, en el origen
    luz.atenuacion = MODOS[estado.elegido].abc;

    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 camara = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.0385f, 50, 400);
    const auto solido = [&](const Buferes &buferes, const glm::mat4 &M, const Material &material) {
        dibujaIluminado(estado.programa, buferes, M, camara, material);
    };
    usaIluminado(estado.programa, camara, proyeccion, luz);
    solido(estado.plano,
           traslacion({D_MAXIMA / 2 - 0.3f, -RADIO, 0}) * giroX(-glm::half_pi<float>()) *
               escalado({D_MAXIMA + 0.6f, 2, 1}),
           PISO);
    solido(estado.esfera, escalado(0.2f), ENCENDIDA);
    for (int d = 1; d <= ESFERAS; ++d)
        solido(estado.esfera, traslacion({d, 0, 0}) * escalado(RADIO), BOLA);
    dibujaCurvas(proyeccion * camara);
    ponTitulo(std::string("Atenuación con la distancia: ") + MODOS[estado.elegido].nombre);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (!teclaComun(tecla))
        eligeModo(estado.elegido, 3, tecla);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Atenuación con la distancia", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
