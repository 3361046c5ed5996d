// La superficie B-Spline (ecuación 11.42): cada 4×4 puntos de control de la red definen un trozo, y los vecinos
// comparten doce. Se unen con C2 sin pasar por los puntos, y mover uno cambia solo los trozos que lo usan, 16 como
// mucho.
// Controles: arrastra los puntos (o n y flechas) · r red de control · ratón orbita · Esc termina.
#include "lamina.h"
#include "rotulo.h"
#include "trazo.h"
#include <algorithm>
#include <cmath>
#include <string>

static const std::size_t LADO = 6;                           // puntos de control de un lado de la red
static const int SEGMENTOS_MAXIMOS_TROZO = 256 / (LADO - 3); // en la superficie entera, los de las demás

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
    bool red = true;
    Lamina lamina;
    Editor editor;
} estado;

static glm::mat4 vista() {
    return vistaLamina(estado.lamina);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    // los mismos segmentos en todos los trozos, para que casen en los bordes
    Segmentos n = {1, 1};
    const auto trozos = [&](const auto &haz) {
        for (std::size_t i = 0; i + 3 < LADO; ++i)
            for (std::size_t j = 0; j + 3 < LADO; ++j)
                haz(geometriaDeRed(estado.P, LADO, i, j), (i + j) % 2 == 0 ? LAMINA_AZUL : LAMINA_NARANJA);
    };
    trozos([&](const Geometria2<float> &G, const Material &) {
        const Segmentos s = segmentosLamina(estado.lamina, redDe(Base::BSPLINE, G), TOLERANCIA_LAMINA);
        n = {std::clamp(s.u, n.u, SEGMENTOS_MAXIMOS_TROZO), std::clamp(s.v, n.v, SEGMENTOS_MAXIMOS_TROZO)};
    });
    trozos([&](const Geometria2<float> &G, const Material &material) {
        dibujaLamina(estado.lamina, mallaSuperficie(Base::BSPLINE, G, n), material);
    });
    if (estado.red) {
        trazaSegmentos(redDeControl(estado.P, LADO), vista(), GRIS, 0.6f * GROSOR);
        glDisable(GL_DEPTH_TEST); // los puntos, todos, también por detrás de la superficie
        trazaPuntos(estado.P, vista(), ROJO, 3 * GROSOR);
        glEnable(GL_DEPTH_TEST);
    }
    if (estado.editor.elegido >= 0) {
        const int k = estado.editor.elegido;
        rotulaPunto("P" + std::to_string(k / LADO) + std::to_string(k % LADO), estado.P[k], vista(), OSCURO);
    }
    ponTitulo("Superficie B-Spline: " + std::to_string(LADO * LADO) + " puntos, " +
              std::to_string((LADO - 3) * (LADO - 3)) + " trozos");
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || teclaEditor(estado.editor, tecla) || tecla != 'r')
        return;
    estado.red = !estado.red;
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
