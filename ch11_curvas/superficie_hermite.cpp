// La superficie de Hermite (ecuaciones 11.33 a 11.39): las esquinas, sus tangentes en u y en v y sus torsiones. Con un
// segundo trozo unido por u = 1 con continuidad G1 (ejercicio 11.8): comparten el borde, y las tangentes que lo cruzan
// son paralelas.
// Controles: arrastra las esquinas (o n y flechas) · u segundo trozo · + - su tangente · ratón orbita ·
// Esc termina.
#include "hermite_trozos.h"
#include "lamina.h"
#include "rotulo.h"
#include "trazo.h"
#include <algorithm>
#include <cstdio>
#include <string>

static const float LARGO_FLECHA = 1 / 3.0f; // de una tangente: así acaba en el punto de control de Bézier
static const float FACTOR_K = 1.25f, K_MINIMA = 0.2f, K_MAXIMA = 3;

static const std::vector<glm::vec3> UN_TROZO(ESQUINAS_INICIALES.begin(),
                                             ESQUINAS_INICIALES.begin() + FINAL_0);

static struct {
    std::vector<glm::vec3> esquinas = UN_TROZO;
    float k = 0.7f;
    bool segundo = false;
    Lamina lamina;
    Editor editor;
} estado;

static glm::mat4 vista() {
    return vistaLamina(estado.lamina);
}

/// En las esquinas de las filas desde `fila`, las tangentes en u y en v.
static void dibujaTangentes(const Geometria2<float> &G, std::size_t fila) {
    for (std::size_t i = fila; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j) {
            trazaFlecha(G[i][j], G[i][j] + LARGO_FLECHA * G[i + 2][j], vista(), VERDE);
            trazaFlecha(G[i][j], G[i][j] + LARGO_FLECHA * G[i][j + 2], vista(), ROJO);
            trazaPuntos({G[i][j]}, vista(), OSCURO);
        }
}

static void dibuja() {
    static const char *const NOMBRES[] = {"g11", "g12", "g21", "g22"};
    static const Lado LADOS[] = {Lado::DEBAJO, Lado::IZQUIERDA, Lado::IZQUIERDA, Lado::ENCIMA};
    estado.lamina.orbita.centro = estado.segundo ? glm::vec3(1.25f, 0.1f, 0) : glm::vec3(0, -0.1f, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const Geometria2<float> G = primerTrozo(estado.esquinas),
                            G2 = estado.segundo ? segundoTrozo(estado.esquinas, estado.k) : G;
    Segmentos n = segmentosLamina(estado.lamina, redDe(Base::HERMITE, G), TOLERANCIA_LAMINA);
    if (estado.segundo) { // los mismos en los dos, para que casen en la unión
        const Segmentos n2 = segmentosLamina(estado.lamina, redDe(Base::HERMITE, G2), TOLERANCIA_LAMINA);
        n = {std::max(n.u, n2.u), std::max(n.v, n2.v)};
    }
    dibujaLamina(estado.lamina, mallaSuperficie(Base::HERMITE, G, n), LAMINA_AZUL);
    if (estado.segundo) {
        dibujaLamina(estado.lamina, mallaSuperficie(Base::HERMITE, G2, n), LAMINA_NARANJA);
        trazaPolilinea(polilinea([&](float v) { return cubica(Base::HERMITE, G[1], v); }, n.v), vista(),
                       BLANCO);
    }
    glDisable(GL_DEPTH_TEST); // las flechas y el punto, enteros, también por detrás de la superficie
    dibujaTangentes(G, 0);
    if (estado.segundo)
        dibujaTangentes(G2, 1);
    if (estado.editor.elegido >= 0)
        trazaPuntos({estado.esquinas[estado.editor.elegido]}, vista(), ROJO, 3.5f * GROSOR);
    glEnable(GL_DEPTH_TEST);
    for (std::size_t i = 0; i < 4; ++i)
        rotulaPunto(NOMBRES[i], estado.esquinas[i], vista(), colorNombre(estado.editor, i), LADOS[i]);
    std::string titulo = "Superficie de Hermite";
    if (estado.segundo) {
        char union_[40];
        std::snprintf(union_, sizeof union_, "G1 con k = %.2f", estado.k);
        rotula(union_, {0.5f, 0.08f}, OSCURO);
        titulo += std::string(": ") + union_;
    }
    ponTitulo(titulo);
    glutSwapBuffers();
}

/// Con el segundo trozo hay dos esquinas más que arrastrar.
static void conmutaSegundo() {
    estado.segundo = !estado.segundo;
    estado.esquinas.resize(FINAL_0);
    if (estado.segundo)
        estado.esquinas.insert(estado.esquinas.end(), ESQUINAS_INICIALES.begin() + FINAL_0,
                               ESQUINAS_INICIALES.end());
    estado.editor.elegido = -1; // la que se arrastraba puede haberse ido
    estado.editor.arrastrando = false;
    estado.lamina.orbita.distancia *= estado.segundo ? 1.3f : 1 / 1.3f;
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || teclaEditor(estado.editor, tecla))
        return;
    if (tecla == 'u')
        conmutaSegundo();
    else if (tecla == '+' || tecla == '-')
        estado.k = glm::clamp(estado.k * (tecla == '+' ? FACTOR_K : 1 / FACTOR_K), K_MINIMA, K_MAXIMA);
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Superficie de Hermite", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    estado.lamina = creaLamina({0.45f, 0.6f, 8.4f});
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.lamina.orbita);
    estado.editor = {&estado.esquinas, vista, true};
    glutMouseFunc(
        [](int boton, int pulsado, int x, int y) { botonEditor(estado.editor, boton, pulsado, x, y); });
    glutMotionFunc([](int x, int y) { arrastraEditor(estado.editor, x, y); });
    glutSpecialFunc([](int tecla, int, int) { especialEditor(estado.editor, tecla); });
    glutMainLoop();
    return 0;
}
