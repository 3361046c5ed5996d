// La continuidad en la unión de dos tramos (§11.1.2, ejercicio 11.5): un coche los recorre con el parámetro u
// proporcional al tiempo. Debajo, el módulo de su velocidad, |Q'|, y el de su aceleración, |Q''|: con C0 salta hasta la
// dirección; con G1, el módulo de la velocidad; con C1, la aceleración; con C2, nada.
// Controles: 1 C0 · 2 G1 · 3 C1 · 4 C2 · v los cuatro · t o espacio anda o para · Esc termina.
#include "continuidad.h"
#include "colores.h"
#include "recuadro.h"
#include "rotulo.h"
#include "trazo.h"
#include "ventana.h"

static const char *const NOMBRES[CONTINUIDADES] = {"C0", "G1", "C1", "C2"};
static const int CADA = 16;     // milisegundos de una imagen a la siguiente
static const int MUESTRAS = 48; // de cada tramo, para las gráficas

static struct {
    int elegido = C0;
    bool compara = true, anda = false;
    int recorridos = AL_EMPEZAR, desde = 0; // milisegundos andados y reloj al arrancar
} estado;

static float parametro() {
    const int t = estado.recorridos + (estado.anda ? glutGet(GLUT_ELAPSED_TIME) - estado.desde : 0);
    return 2 * float(t % PERIODO) / float(PERIODO);
}

/// El módulo de la derivada a lo largo de cada tramo: el salto de la unión queda entre los dos.
static void dibujaGrafica(Continuidad c, int derivada, float maxima, const glm::vec3 &color,
                          const glm::mat4 &vista) {
    glm::vec3 junto[2];
    for (int tramo = 0; tramo < 2; ++tramo) {
        const Geometria<float> G = tramo == 0 ? PRIMER_TRAMO : segundoTramo(c);
        const auto altura = [&](float u) {
            return glm::vec3(1.1f * (u + float(tramo) - 1),
                             -0.95f + 0.5f * glm::length(cubica(Base::HERMITE, G, u, derivada)) / maxima, 0);
        };
        trazaPolilinea(polilinea(altura, MUESTRAS), vista, color, GROSOR);
        junto[tramo] = altura(tramo == 0 ? 1.0f : 0.0f);
    }
    if (glm::distance(junto[0], junto[1]) > 0.005f)
        trazaPuntos({junto[0], junto[1]}, vista, color, 3 * GROSOR);
}

static void dibujaPanel(const Recuadro &panel, Continuidad c) {
    abreRecuadro(panel, FONDO_CLARO);
    const glm::mat4 vista = paralelaVentana(1.05f, -1, 1, aspecto(panel));
    const float u = parametro();
    trazaPolilinea({{-1.1f, -0.38f, 0}, {-1.1f, -0.95f, 0}, {1.1f, -0.95f, 0}}, vista, OSCURO, 0.6f * GROSOR);
    trazaSegmentos({{1.1f * (u - 1), -0.95f, 0}, {1.1f * (u - 1), -0.4f, 0}}, vista, GRIS, 0.6f * GROSOR);
    dibujaGrafica(c, 2, ACELERACION_MAXIMA, ROJO, vista);
    dibujaGrafica(c, 1, RAPIDEZ_MAXIMA, VERDE, vista);
    const double tolerancia = 0.4 / std::max(panel.alto, 1);
    trazaPolilinea(polilineaCubica(Base::HERMITE, PRIMER_TRAMO, tolerancia), vista, AZUL, 1.7f * GROSOR);
    trazaPolilinea(polilineaCubica(Base::HERMITE, segundoTramo(c), tolerancia), vista, MORADO, 1.7f * GROSOR);
    trazaPuntos({PRIMER_TRAMO[1]}, vista, OSCURO, 3 * GROSOR);

    const glm::vec3 Q = recorrido(c, u), velocidad = recorrido(c, u, 1), F = glm::normalize(velocidad),
                    L(-F.y, F.x, 0);
    trazaFlecha(Q, Q + VELOCIDAD * velocidad, vista, VERDE);
    trazaPoligono({Q + 0.10f * F, Q - 0.08f * F + 0.07f * L, Q - 0.08f * F - 0.07f * L}, vista, NARANJA);
    rotulaPunto(NOMBRES[c], {-1.1f, 0.85f, 0}, vista, OSCURO, Lado::CENTRO, 1.3f * TALLA_ROTULO);
    rotulaPunto("|Q'|", {-0.88f, -0.25f, 0}, vista, VERDE, Lado::CENTRO);
    rotulaPunto("|Q''|", {-0.18f, -0.25f, 0}, vista, ROJO, Lado::CENTRO);
}

static void dibuja() {
    abreRecuadro(ventanaEntera(), GRIS);
    if (estado.compara) {
        const std::vector<Recuadro> paneles = reparte(CONTINUIDADES, 4.0f / 3);
        for (int c = 0; c < CONTINUIDADES; ++c)
            dibujaPanel(paneles[c], Continuidad(c));
    } else
        dibujaPanel(ventanaEntera(), Continuidad(estado.elegido));
    char titulo[60];
    std::snprintf(titulo, sizeof titulo, "Continuidad: %s, u = %.2f",
                  estado.compara ? "las cuatro" : NOMBRES[estado.elegido], parametro());
    ponTitulo(titulo);
    glutSwapBuffers();
}

static void avanza(int) {
    if (estado.anda)
        glutPostRedisplay();
    glutTimerFunc(CADA, avanza, 0);
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    if (tecla >= '1' && tecla <= '4') {
        estado.elegido = tecla - '1';
        estado.compara = false;
    } else if (tecla == 'v')
        estado.compara = !estado.compara;
    else if (tecla == 't' || tecla == ' ') {
        const int ahora = glutGet(GLUT_ELAPSED_TIME);
        if (estado.anda)
            estado.recorridos = (estado.recorridos + ahora - estado.desde) % PERIODO;
        estado.desde = ahora;
        estado.anda = !estado.anda;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Continuidad", GLUT_DOUBLE | GLUT_MULTISAMPLE);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutTimerFunc(CADA, avanza, 0);
    glutMainLoop();
    return 0;
}
