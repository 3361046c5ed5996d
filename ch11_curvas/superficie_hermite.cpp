// La superficie de Hermite (ecuaciones 11.33 a 11.39): las esquinas, sus tangentes en u y en v y sus torsiones. Con un segundo
// trozo unido por u = 1 con continuidad G1 (ejercicio 11.8): comparten el borde, y las tangentes que lo cruzan son
// paralelas.
// Controles: arrastra las esquinas (o n y flechas) · u segundo trozo · + - su tangente · ratón orbita ·
// Esc termina.
#include "hermite_trozos.h"
#include "lamina.h"
#include "rotulo.h"
#include "trazo.h"

static const float LARGO_FLECHA = 1 / 3.0f; // de una tangente: así acaba en el punto de control de Bézier
static const float FACTOR_K = 1.25f, K_MINIMA = 0.2f, K_MAXIMA = 3;

static struct {
    std::vector<glm::vec3> esquinas = ESQUINAS_INICIALES;
    float k = 0.7f;
    bool segundo = false;
} estado;

/// La superficie, y en las esquinas de sus filas desde `fila` las tangentes en u y en v.
static void dibujaTrozo(const Geometria2<float> &G, const Material &material, const Segmentos &n,
                        std::size_t fila) {
    dibujaLamina(mallaSuperficie(Base::HERMITE, G, n), material);
    for (std::size_t i = fila; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j) {
            trazaFlecha(G[i][j], G[i][j] + LARGO_FLECHA * G[i + 2][j], vistaLamina(), VERDE, 0.9f * GROSOR);
            trazaFlecha(G[i][j], G[i][j] + LARGO_FLECHA * G[i][j + 2], vistaLamina(), NARANJA, 0.9f * GROSOR);
            trazaPuntos({G[i][j]}, vistaLamina(), OSCURO);
        }
}

static void dibuja() {
    static const char *const NOMBRES[] = {"g11", "g12", "g21", "g22"};
    orbitaLamina.centro = {estado.segundo ? 1.25f : 0.0f, 0, 0};
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const Geometria2<float> G = primerTrozo(estado.esquinas), G2 = segundoTrozo(estado.esquinas, estado.k);
    Segmentos n = segmentosSuperficie(Base::HERMITE, G, 0.5 * pixelLamina());
    const Segmentos n2 = segmentosSuperficie(Base::HERMITE, G2, 0.5 * pixelLamina());
    n = {std::max(n.u, n2.u), std::max(n.v, n2.v)}; // los mismos, para que casen en la unión
    dibujaTrozo(G, LAMINA_AZUL, n, 0);
    if (estado.segundo) {
        dibujaTrozo(G2, LAMINA_NARANJA, n, 1);
        trazaPolilinea(polilineaCubica(Base::HERMITE, G[1], 0.2 * pixelLamina()), vistaLamina(), ROJO);
    }
    for (std::size_t i = 0; i < 4; ++i)
        rotulaPunto(NOMBRES[i], estado.esquinas[i], vistaLamina(), OSCURO,
                    i % 2 ? Lado::ENCIMA : Lado::DEBAJO);
    char titulo[80] = "Superficie de Hermite";
    if (estado.segundo)
        std::snprintf(titulo, sizeof titulo, "Superficie de Hermite: dos trozos G1, k = %.2f",
                      static_cast<double>(estado.k));
    ponTitulo(titulo);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || teclaEditor(tecla))
        return;
    if (tecla == 'u') {
        estado.segundo = !estado.segundo;
        orbitaLamina.distancia *= estado.segundo ? 1.45f : 1 / 1.45f;
    } else if (tecla == '+' || tecla == '-')
        estado.k = glm::clamp(estado.k * (tecla == '+' ? FACTOR_K : 1 / FACTOR_K), K_MINIMA, K_MAXIMA);
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Superficie de Hermite", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    iniciaLamina();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    editaConRaton({&estado.esquinas, vistaLamina}, &orbitaLamina);
    glutMainLoop();
    return 0;
}
