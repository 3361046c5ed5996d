// La superficie de Bézier (ecuaciones 11.40 y 11.41) y los (n + 1)×(m + 1) puntos de control que la definen, 16 en la
// figura 11.2. Se ve también en los triángulos que bastan para no separarse de ella más de una tolerancia en píxeles;
// como la familia de curvas Q(u, v) cuyos puntos de control G(v) se mueven con v (§11.5); y unida a otro trozo con C0,
// con G1 y, como el libro dice que basta (§11.7), con los puntos solo alineados.
// Controles: arrastra los puntos (o n y flechas) · m malla · f familia de curvas · u unión con otro trozo ·
// + - grado, finura de la malla o v de la familia · ratón orbita · Esc termina.
#include "bezier_trozos.h"
#include "colores.h"
#include "curvas.h"
#include "editor.h"
#include "lamina.h"
#include "malla.h"
#include "orbita.h"
#include "rotulo.h"
#include "superficies.h"
#include "texto.h"
#include "trazo.h"
#include "ventana.h"
#include <string>

static const int GRADOS_MINIMOS = 2, GRADOS_MAXIMOS = 14; // n + m
static const double TOLERANCIA_MINIMA = 0.5, TOLERANCIA_MAXIMA = 64;
static const int VECES_V = 20, CURVAS = 10, NORMALES = 12; // en que se parte v
static const float FLECHA_CURVAS = 0.001f, LARGO_NORMAL = 0.55f, ANGULO_DE_DOS = 0.68f;
enum Modo { RED, MALLA, FAMILIA, UNION_C0, UNION_G1, UNION_DESIGUAL, MODOS };

static struct {
    int grados = 6; // n + m
    RedBezier<float> red = redInicial(6);
    int modo = RED;
    double tolerancia = 32; // píxeles
    int v = 8;              // de 0 a VECES_V
    Lamina lamina;
    Editor editor;
} estado;

static glm::mat4 vista() {
    return vistaLamina(estado.lamina);
}

// La superficie; devuelve sus triángulos.
static Malla dibujaSuperficie(double tolerancia = TOLERANCIA_LAMINA) {
    const Malla malla = mallaSuperficie(estado.red, segmentosLamina(estado.lamina, estado.red, tolerancia));
    dibujaLamina(estado.lamina, malla, LAMINA_AZUL);
    return malla;
}

// La red de control y el nombre del punto elegido o, si se quiere, también los de las esquinas.
static void dibujaRed(bool conEsquinas) {
    const std::size_t n = estado.red.n, m = estado.red.m;
    trazaSegmentos(redDeControl(estado.red.P, m + 1), vista(), GRIS, 0.7f * GROSOR);
    trazaPuntos(estado.red.P, vista(), ROJO, 3.5f * GROSOR);
    for (std::size_t k = 0; k < estado.red.P.size(); ++k) {
        const std::size_t i = k / (m + 1), j = k % (m + 1);
        if ((conEsquinas && i % n == 0 && j % m == 0) || int(k) == estado.editor.elegido)
            rotulaPunto("P" + std::to_string(i) + std::to_string(j), estado.red.P[k], vista(),
                        colorNombre(estado.editor, k), i % n == 0 && j == 0 ? Lado::DEBAJO : Lado::ENCIMA);
    }
}

// Cada modo dibuja lo suyo y devuelve lo que se rotula. Sin test de profundidad, lo que se ve también por detrás.

static std::string modoRed() {
    dibujaSuperficie();
    trazaCambio(estado.lamina, redInicial(estado.grados), estado.red);
    glDisable(GL_DEPTH_TEST);
    dibujaRed(true);
    return formatea("n = %zu, m = %zu", estado.red.n, estado.red.m);
}

static std::string modoMalla() {
    const Malla malla = dibujaSuperficie(estado.tolerancia);
    std::vector<glm::vec3> lados;
    for (std::size_t i = 0; i < malla.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k)
            for (const std::size_t extremo : {k, (k + 1) % 3})
                lados.push_back(malla.vertices[malla.indices[i + extremo]].posicion);
    trazaSegmentos(lados, vista(), BLANCO, 0.7f * GROSOR);
    return formatea("error ≤ %g px: %zu triángulos", estado.tolerancia, malla.indices.size() / 3);
}

// La curva de la familia que corta la superficie en v.
static std::vector<glm::vec3> curvaEn(float v) {
    return polilineaBezier(geometriaEn(estado.red, v), FLECHA_CURVAS);
}

// G(v), naranja, recorre las curvas de las filas, grises, y Q(u, v), roja, va con él.
static std::string modoFamilia() {
    const float v = float(estado.v) / VECES_V;
    const std::vector<glm::vec3> G = geometriaEn(estado.red, v);
    dibujaSuperficie();
    for (int k = 0; k <= CURVAS; ++k)
        trazaPolilinea(curvaEn(float(k) / CURVAS), vista(), BLANCO, 0.6f * GROSOR);
    glDisable(GL_DEPTH_TEST);
    for (std::size_t i = 0; i <= estado.red.n; ++i)
        trazaPolilinea(polilineaBezier(estado.red.fila(i), FLECHA_CURVAS), vista(), GRIS);
    trazaPolilinea(curvaEn(v), vista(), ROJO, 1.7f * GROSOR);
    trazaPolilinea(G, vista(), NARANJA, 0.8f * GROSOR);
    trazaPuntos(G, vista(), NARANJA, 4 * GROSOR);
    for (std::size_t i = 0; i < G.size(); ++i)
        rotulaPunto("G" + std::to_string(i + 1), G[i], vista(), OSCURO);
    return formatea("Q(u, v), con v = %.2f", v);
}

// Los dos trozos; los puntos de los dos lados del borde, que se alinean, y las normales de cada trozo a lo largo de
// él.
static std::string modoUnion() {
    static const char *const UNIONES[] = {"C0", "G1", "alineados"};
    const int cual = estado.modo - UNION_C0;
    const RedBezier<float> &red = estado.red;
    const RedBezier<float> otra = trozoUnido(red, Union(cual));
    const Segmentos n1 = segmentosLamina(estado.lamina, red, TOLERANCIA_LAMINA),
                    n2 = segmentosLamina(estado.lamina, otra, TOLERANCIA_LAMINA);
    const Segmentos n = {std::max(n1.u, n2.u), std::max(n1.v, n2.v)}; // para que casen en la unión
    dibujaLamina(estado.lamina, mallaSuperficie(otra, n), LAMINA_NARANJA);
    dibujaLamina(estado.lamina, mallaSuperficie(red, n), LAMINA_AZUL);
    glDisable(GL_DEPTH_TEST);
    dibujaRed(false);
    for (std::size_t j = 0; j <= red.m; ++j) {
        trazaPolilinea({red.en(red.n - 1, j), otra.en(0, j), otra.en(1, j)}, vista(), OSCURO);
        trazaPuntos({otra.en(1, j)}, vista(), MORADO, 3.5f * GROSOR);
    }
    float separadas = 0; // lo más que se separan las normales
    for (int k = 0; k <= NORMALES; ++k) {
        const float v = float(k) / NORMALES;
        const glm::vec3 Q = superficie(otra, 0.0f, v), N1 = normalSuperficie(red, 1.0f, v),
                        N2 = normalSuperficie(otra, 0.0f, v);
        trazaFlecha(Q, Q + LARGO_NORMAL * N1, vista(), AZUL, 0.8f * GROSOR);
        trazaFlecha(Q, Q + LARGO_NORMAL * N2, vista(), NARANJA, 0.8f * GROSOR);
        separadas = std::max(separadas, std::atan2(glm::length(glm::cross(N1, N2)), glm::dot(N1, N2)));
    }
    return formatea("%s: normales a %.0f°", UNIONES[cual], glm::degrees(separadas));
}

static void dibuja() {
    static std::string (*const DIBUJA[MODOS])() = {modoRed,   modoMalla, modoFamilia,
                                                   modoUnion, modoUnion, modoUnion};
    const bool dos = estado.modo >= UNION_C0;
    estado.lamina.orbita.centro = dos ? glm::vec3(1.5f, -0.2f, 0) : glm::vec3(0, -0.35f, 0);
    estado.lamina.angulo = dos ? ANGULO_DE_DOS : ANGULO_LAMINA;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const std::string texto = DIBUJA[estado.modo]();
    glEnable(GL_DEPTH_TEST);
    rotula(texto, estado.modo == RED ? glm::vec2(0.2f, 0.06f) : glm::vec2(0.5f, 0.94f), OSCURO);
    ponTitulo("Superficie de Bézier: " + texto);
    glutSwapBuffers();
}

// + y − cambian lo del modo en que se está.
static void cambia(int paso) {
    if (estado.modo == MALLA)
        estado.tolerancia =
            glm::clamp(estado.tolerancia * (paso > 0 ? 0.5 : 2), TOLERANCIA_MINIMA, TOLERANCIA_MAXIMA);
    else if (estado.modo == FAMILIA)
        estado.v = glm::clamp(estado.v + paso, 0, VECES_V);
    else {
        estado.grados = glm::clamp(estado.grados + paso, GRADOS_MINIMOS, GRADOS_MAXIMOS);
        estado.red = redInicial(estado.grados);
        estado.editor.elegido = -1; // el que se arrastraba puede haberse ido
        estado.editor.arrastrando = false;
    }
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || teclaEditor(estado.editor, tecla))
        return;
    if (tecla == 'm')
        estado.modo = estado.modo == MALLA ? RED : MALLA;
    else if (tecla == 'f')
        estado.modo = estado.modo == FAMILIA ? RED : FAMILIA;
    else if (tecla == 'u') // la siguiente unión; tras la última, ninguna
        estado.modo = estado.modo < UNION_C0 ? UNION_C0 : (estado.modo + 1) % MODOS;
    else if (tecla == '+' || tecla == '-')
        cambia(tecla == '+' ? 1 : -1);
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Superficie de Bézier", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    estado.lamina = creaLamina({0.55f, 0.65f, 8});
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.lamina.orbita);
    estado.editor = {&estado.red.P, vista, true};
    editaConRaton(estado.editor);
    glutMainLoop();
    return 0;
}
