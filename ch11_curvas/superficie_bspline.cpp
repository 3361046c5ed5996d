// La superficie B-Spline (ecuación 11.42): cada 4×4 puntos de control de la red definen un trozo, y los vecinos
// comparten doce. Se unen con C2 sin pasar por los puntos, y mover uno cambia solo los trozos que lo usan, 16 como
// mucho. Con puntos repetidos (§11.8) las derivadas siguen casando, pero con una fila tres veces se anulan en ella,
// y la superficie, que entonces llega a pasar por su curva, tiene ahí una arista.
// Controles: arrastra los puntos (o n y flechas) · d una fila una, dos o tres veces · r red de control ·
// ratón orbita · Esc termina.
#include "ch05_iluminacion/materiales.h"
#include "colores.h"
#include "curvas.h"
#include "editor.h"
#include "lamina.h"
#include "orbita.h"
#include "rotulo.h"
#include "superficies.h"
#include "trazo.h"
#include "ventana.h"
#include <algorithm>
#include <cmath>
#include <string>

static const std::size_t LADO = 6;                           // puntos de control de un lado de la red
static const std::size_t FILA = 2;                           // la que se repite
static const int SEGMENTOS_MAXIMOS_TROZO = 256 / (LADO - 3); // en la superficie entera, los de las demás

static const double TOLERANCIA = TOLERANCIA_LAMINA / 2; // con una fila dos veces, la superficie se dobla más

// Un monte junto a un hoyo.
static std::vector<glm::vec3> redInicial() {
    std::vector<glm::vec3> P;
    for (std::size_t i = 0; i < LADO; ++i)
        for (std::size_t j = 0; j < LADO; ++j) {
            const float x = 0.8f * (float(i) - 2.5f), z = -0.8f * (float(j) - 2.5f);
            const auto monte = [&](float cx, float cz) {
                return std::exp(-1.6f * ((x - cx) * (x - cx) + (z - cz) * (z - cz)));
            };
            P.push_back({x, 2.0f * monte(-0.5f, -0.5f) - 1.5f * monte(0.6f, 0.6f), z});
        }
    return P;
}

static struct {
    std::vector<glm::vec3> P = redInicial();
    int veces = 1; // que está la fila
    bool conRed = true;
    Lamina lamina;
    Editor editor;
} estado;

static glm::mat4 vista() {
    return vistaLamina(estado.lamina);
}

// La red de control, con la fila que se repite tantas veces como está.
static std::vector<glm::vec3> red() {
    std::vector<glm::vec3> P = estado.P;
    const auto fila = estado.P.begin() + FILA * LADO;
    for (int k = 1; k < estado.veces; ++k)
        P.insert(P.begin() + FILA * LADO, fila, fila + LADO);
    return P;
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const std::vector<glm::vec3> P = red();
    const std::size_t filas = P.size() / LADO;
    // los mismos segmentos en todos los trozos, para que casen en los bordes
    Segmentos n = {1, 1};
    const auto trozos = [&](const auto &haz) {
        for (std::size_t i = 0; i + 3 < filas; ++i)
            for (std::size_t j = 0; j + 3 < LADO; ++j)
                haz(geometriaDeRed(P, LADO, i, j), (i + j) % 2 == 0 ? LAMINA_AZUL : LAMINA_NARANJA);
    };
    trozos([&](const Geometria2<float> &G, const Material &) {
        const Segmentos s = segmentosLamina(estado.lamina, redDe(Base::BSPLINE, G), TOLERANCIA);
        n = {std::clamp(s.u, n.u, SEGMENTOS_MAXIMOS_TROZO), std::clamp(s.v, n.v, SEGMENTOS_MAXIMOS_TROZO)};
    });
    trozos([&](const Geometria2<float> &G, const Material &material) {
        dibujaLamina(estado.lamina, mallaSuperficie(Base::BSPLINE, G, n), material);
    });
    if (estado.conRed) {
        trazaSegmentos(redDeControl(estado.P, LADO), vista(), GRIS, 0.6f * GROSOR);
        glDisable(GL_DEPTH_TEST); // los puntos, todos, también por detrás de la superficie
        trazaPuntos(estado.P, vista(), ROJO, 3 * GROSOR);
        if (estado.veces > 1) {
            const auto fila = estado.P.begin() + FILA * LADO;
            trazaPuntos({fila, fila + LADO}, vista(), MORADO, 5 * GROSOR);
            rotulaPunto("fila ×" + std::to_string(estado.veces), *fila, vista(), MORADO, Lado::IZQUIERDA);
        }
        glEnable(GL_DEPTH_TEST);
    }
    if (estado.editor.elegido >= 0) {
        const int k = estado.editor.elegido;
        rotulaPunto("P" + std::to_string(k / LADO) + std::to_string(k % LADO), estado.P[k], vista(), OSCURO);
    }
    ponTitulo("Superficie B-Spline: " + std::to_string(LADO * LADO) + " puntos, " +
              std::to_string((filas - 3) * (LADO - 3)) + " trozos" +
              (estado.veces > 1 ? ", una fila " + std::to_string(estado.veces) + " veces" : ""));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || teclaEditor(estado.editor, tecla))
        return;
    if (tecla == 'd')
        estado.veces = estado.veces % 3 + 1;
    else if (tecla == 'r')
        estado.conRed = !estado.conRed;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Superficie B-Spline", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    estado.lamina = creaLamina({0.55f, 0.6f, 9.4f, {0, -0.1f, 0}});
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.lamina.orbita);
    estado.editor = {&estado.P, vista, true};
    editaConRaton(estado.editor);
    glutMainLoop();
    return 0;
}
