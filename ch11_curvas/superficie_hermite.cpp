// La superficie de Hermite (ecuaciones 11.33 a 11.39): las esquinas, sus tangentes en u (amarillo) y en v (rojo) y sus
// torsiones (morado), que son los 16 elementos de la matriz de geometría. Con un segundo trozo unido por u = 1 con
// continuidad G1 (ejercicio 11.8): comparten el borde, y las tangentes que lo cruzan son paralelas, torsiones
// incluidas.
// Controles: arrastra las esquinas y las puntas de flecha (o n y flechas) · u segundo trozo · + - su tangente ·
// ratón orbita · Esc termina.
#include "colores.h"
#include "curvas.h"
#include "editor.h"
#include "hermite_trozos.h"
#include "lamina.h"
#include "orbita.h"
#include "rotulo.h"
#include "superficies.h"
#include "texto.h"
#include "trazo.h"
#include "ventana.h"
#include <algorithm>
#include <string>

static const float FACTOR_K = 1.25f, K_MINIMA = 0.2f, K_MAXIMA = 3, ANGULO_DE_DOS = 0.65f;

static const std::vector<glm::vec3> PUNTAS = puntas(ELEMENTOS_INICIALES);

static struct {
    std::vector<glm::vec3> puntas{PUNTAS.begin(), PUNTAS.begin() + DEL_PRIMERO}; // lo que se arrastra
    float k = 0.7f;
    bool segundo = false;
    Lamina lamina;
    Editor editor;
} estado;

// La matriz de geometría en sus cuatro bloques, del color de lo que se dibuja.
static const struct {
    const char *texto;
    glm::vec3 color;
    glm::vec2 lugar;
} BLOQUES[] = {{"esquinas\ng11 g12\ng21 g22", OSCURO, {0.02f, 0.23f}},
               {"en v\ng13 g14\ng23 g24", ROJO, {0.2f, 0.23f}},
               {"en u\ng31 g32\ng41 g42", AMARILLO, {0.02f, 0.08f}},
               {"torsión\ng33 g34\ng43 g44", MORADO, {0.2f, 0.08f}}};

static glm::mat4 vista() {
    return vistaLamina(estado.lamina);
}

// Los elementos de las matrices de geometría: esquinas, tangentes y torsiones. Los nombres, los de las esquinas y el
// del elegido.
static void dibujaElementos() {
    static const Lado LADOS[] = {Lado::IZQUIERDA, Lado::IZQUIERDA, Lado::IZQUIERDA, Lado::IZQUIERDA};
    glDisable(GL_DEPTH_TEST); // las flechas y los puntos, enteros, también por detrás de la superficie
    std::vector<glm::vec3> esquinas;
    for (std::size_t k = 0; k < estado.puntas.size(); ++k) {
        const std::size_t fila = k < DEL_PRIMERO ? k / 4 : k / 4 % 2 * 2 + 1;
        const glm::vec3 &esquina = estado.puntas[esquinaDe(k)];
        if (esquinaDe(k) == k)
            esquinas.push_back(esquina);
        else if (fila < 2)
            trazaFlecha(esquina, estado.puntas[k], vista(), ROJO);
        else
            trazaFlecha(esquina, estado.puntas[k], vista(), k % 4 < 2 ? AMARILLO : MORADO);
    }
    trazaPuntos(esquinas, vista(), OSCURO);
    if (estado.editor.elegido >= 0)
        trazaPuntos({estado.puntas[estado.editor.elegido]}, vista(), ROJO, 3.5f * GROSOR);
    glEnable(GL_DEPTH_TEST);
    for (std::size_t k = 0; k < DEL_PRIMERO; ++k)
        if (esquinaDe(k) == k || int(k) == estado.editor.elegido)
            rotulaPunto("g" + std::to_string(k / 4 + 1) + std::to_string(k % 4 + 1), estado.puntas[k],
                        vista(), colorNombre(estado.editor, k),
                        esquinaDe(k) == k ? LADOS[k / 4 * 2 + k % 4] : Lado::DERECHA);
}

static void dibuja() {
    estado.lamina.orbita.centro = estado.segundo ? glm::vec3(1.25f, -0.1f, 0) : glm::vec3(0, -0.2f, 0);
    estado.lamina.angulo = estado.segundo ? ANGULO_DE_DOS : ANGULO_LAMINA;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const std::vector<glm::vec3> elementos = elementosDe(estado.puntas);
    const Geometria2<float> G = primerTrozo(elementos);
    const Geometria2<float> G2 = estado.segundo ? segundoTrozo(elementos, estado.k) : G;
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
    } else {
        trazaCambio(estado.lamina, redDe(Base::HERMITE, primerTrozo(elementosDe(PUNTAS))),
                    redDe(Base::HERMITE, G));
    }
    dibujaElementos();
    for (const auto &b : BLOQUES)
        rotula(b.texto, b.lugar, b.color, Lado::DERECHA, 0.03f);
    std::string titulo = "Superficie de Hermite";
    if (estado.segundo) {
        const std::string comoSeUnen = formatea("G1 con k = %.2f", estado.k);
        rotula(comoSeUnen, {0.7f, 0.08f}, OSCURO);
        titulo += ": " + comoSeUnen;
    }
    ponTitulo(titulo);
    glutSwapBuffers();
}

// Con una esquina van las puntas de sus flechas: los vectores no cambian.
static void alMover(std::size_t esquina, const glm::vec3 &cuanto) {
    for (std::size_t k = 0; k < estado.puntas.size(); ++k)
        if (k != esquina && esquinaDe(k) == esquina)
            estado.puntas[k] += cuanto;
}

// Con el segundo trozo hay ocho elementos más que arrastrar.
static void conmutaSegundo() {
    estado.segundo = !estado.segundo;
    estado.puntas.resize(DEL_PRIMERO);
    if (estado.segundo)
        estado.puntas.insert(estado.puntas.end(), PUNTAS.begin() + DEL_PRIMERO, PUNTAS.end());
    estado.editor.elegido = -1; // lo que se arrastraba puede haberse ido
    estado.editor.arrastrando = false;
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
    estado.editor = {&estado.puntas, vista, true, alMover};
    editaConRaton(estado.editor);
    glutMainLoop();
    return 0;
}
