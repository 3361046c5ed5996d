// La curva B-Spline uniforme (ecuaciones 11.23 a 11.27), abierta o cerrada: no pasa por sus puntos de control y es C2 en los
// nudos, que son los puntos donde acaba un tramo y empieza otro. El control es local: mover un punto cambia como mucho los
// cuatro tramos que lo usan, en rojo (ejercicio 11.7); la curva de antes queda en gris.
// Controles: arrastra los puntos (o n y flechas) · c abierta o cerrada · Esc termina.
#include "colores.h"
#include "curvas.h"
#include "editor.h"
#include "rotulo.h"
#include "trazo.h"

static const std::vector<glm::vec3> INICIALES = {
    {-1.05f, -0.05f, 0}, {-0.88f, 0.68f, 0}, {-0.28f, 0.40f, 0}, {0.12f, 0.76f, 0},  {0.86f, 0.66f, 0},
    {1.06f, -0.10f, 0},  {0.50f, -0.70f, 0}, {0.02f, -0.30f, 0}, {-0.62f, -0.72f, 0}};

// Donde no tapa la curva.
static const Lado LADOS[] = {Lado::IZQUIERDA, Lado::ENCIMA, Lado::DEBAJO, Lado::ENCIMA, Lado::ENCIMA,
                             Lado::DERECHA,   Lado::DEBAJO, Lado::ENCIMA, Lado::DEBAJO};

static struct {
    std::vector<glm::vec3> P = INICIALES;
    bool cerrada = false;
} estado;

static glm::mat4 vista() {
    return paralelaVentana(1);
}

static std::vector<glm::vec3> tramo(const std::vector<glm::vec3> &P, std::size_t i) {
    return polilineaCubica(Base::BSPLINE, geometriaBSpline(P, i), 0.2 / static_cast<double>(altoUtil()));
}

/// Si el tramo i usa el punto elegido: es uno de los cuatro desde el i.
static bool usaElegido(std::size_t i) {
    const std::size_t n = estado.P.size();
    return editor.elegido >= 0 && (static_cast<std::size_t>(editor.elegido) + n - i) % n < 4;
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT);
    const std::size_t tramos = tramosBSpline(estado.P.size(), estado.cerrada);
    trazaPolilinea(estado.P, vista(), glm::mix(GRIS, BLANCO, 0.4f), 0.6f * GROSOR, estado.cerrada);
    std::vector<glm::vec3> nudos;
    for (std::size_t i = 0; i < tramos; ++i)
        trazaPolilinea(tramo(INICIALES, i), vista(), GRIS, GROSOR);
    for (std::size_t i = 0; i < tramos; ++i) {
        const std::vector<glm::vec3> puntos = tramo(estado.P, i);
        trazaPolilinea(puntos, vista(), usaElegido(i) ? ROJO : AZUL, 1.7f * GROSOR);
        nudos.push_back(puntos.front());
        nudos.push_back(puntos.back());
    }
    trazaPuntos(nudos, vista(), NARANJA, 3 * GROSOR);
    trazaPuntos(estado.P, vista(), OSCURO, 4 * GROSOR);
    for (std::size_t i = 0; i < estado.P.size(); ++i) {
        const bool elegido = static_cast<int>(i) == editor.elegido;
        rotulaPunto("P" + std::to_string(i), estado.P[i], vista(), elegido ? ROJO : OSCURO, LADOS[i]);
    }
    ponTitulo("Curva B-Spline " + std::string(estado.cerrada ? "cerrada" : "abierta") + ": " +
              std::to_string(estado.P.size()) + " puntos, " + std::to_string(tramos) + " tramos");
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || teclaEditor(tecla) || tecla != 'c')
        return;
    estado.cerrada = !estado.cerrada;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Curva B-Spline", GLUT_DOUBLE | GLUT_MULTISAMPLE);
    glClearColor(FONDO_CLARO.r, FONDO_CLARO.g, FONDO_CLARO.b, 1);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    editaConRaton({&estado.P, vista});
    glutMainLoop();
    return 0;
}
