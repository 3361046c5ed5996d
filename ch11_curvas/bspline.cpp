// La curva B-Spline uniforme (ecuaciones 11.23 a 11.27), abierta o cerrada: no pasa por sus puntos de control y es C2
// en los nudos, que son los puntos donde acaba un tramo y empieza otro. El control es local: mover un punto cambia como
// mucho los cuatro tramos que lo usan, en rojo (ejercicio 11.7); la curva de antes queda en gris.
// Controles: arrastra los puntos (o n y flechas) · c abierta o cerrada · k peine de curvatura · Esc termina.
#include "colores.h"
#include "curvas.h"
#include "editor.h"
#include "escenas_curvas.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "trazo.h"
#include "ventana.h"

// Donde no tapa la curva.
static const Lado LADOS[] = {Lado::IZQUIERDA, Lado::ENCIMA, Lado::DEBAJO,    Lado::ENCIMA, Lado::ENCIMA,
                             Lado::DERECHA,   Lado::DEBAJO, Lado::IZQUIERDA, Lado::DEBAJO};

static const int PUAS = 20; // en cada tramo

static struct {
    std::vector<glm::vec3> P = PUNTOS_BSPLINE;
    bool cerrada = false, peine = false;
    Editor editor;
} estado;

static glm::mat4 vista() {
    return paralelaVentana(1);
}

static std::vector<glm::vec3> tramo(const std::vector<glm::vec3> &P, std::size_t i) {
    return polilineaCubica(Base::BSPLINE, geometriaBSpline(P, i), 0.2 / altoUtil());
}

// El peine de curvatura: púas hacia fuera de la curva, tan largas como ella se curva. Donde se unen dos tramos no
// salta, porque la curva es C2, pero cambia de dirección, porque no es C3.
static void dibujaPeine(std::size_t i) {
    const Geometria<float> G = geometriaBSpline(estado.P, i);
    std::vector<glm::vec3> puas, puntas;
    for (int k = 0; k <= PUAS; ++k) {
        const float u = float(k) / PUAS;
        puas.push_back(cubica(Base::BSPLINE, G, u));
        puas.push_back(puas.back() - LARGO_PUAS * curvatura(cubica(Base::BSPLINE, G, u, 1),
                                                            cubica(Base::BSPLINE, G, u, 2)));
        puntas.push_back(puas.back());
    }
    trazaSegmentos(puas, vista(), VERDE, 0.4f * GROSOR);
    trazaPolilinea(puntas, vista(), VERDE, 0.8f * GROSOR);
}

// Si el tramo i usa el punto elegido.
static bool usaElegido(std::size_t i) {
    // E11.7: si el punto estado.editor.elegido, que es −1 cuando no hay ninguno, es de los del tramo i
    const std::size_t n = estado.P.size();
    // los cuatro desde el i
    return estado.editor.elegido >= 0 && (estado.editor.elegido + n - i) % n < 4;
    // de partida: return estado.editor.elegido == int(i);
    // fin de E11.7
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT);
    const std::size_t tramos = tramosBSpline(estado.P.size(), estado.cerrada);
    trazaPolilinea(estado.P, vista(), glm::mix(GRIS, BLANCO, 0.4f), 0.6f * GROSOR, estado.cerrada);
    std::vector<glm::vec3> nudos;
    for (std::size_t i = 0; i < tramos; ++i)
        trazaPolilinea(tramo(PUNTOS_BSPLINE, i), vista(), GRIS, GROSOR);
    for (std::size_t i = 0; estado.peine && i < tramos; ++i)
        dibujaPeine(i);
    for (std::size_t i = 0; i < tramos; ++i) {
        trazaPolilinea(tramo(estado.P, i), vista(), usaElegido(i) ? ROJO : AZUL, 1.7f * GROSOR);
        for (const float u : {0.0f, 1.0f}) // ecuación 11.25
            nudos.push_back(potencias(u) * M_BS * enFilas(geometriaBSpline(estado.P, i)));
    }
    trazaPuntos(nudos, vista(), NARANJA, 3 * GROSOR);
    trazaPuntos(estado.P, vista(), OSCURO, 4 * GROSOR);
    for (std::size_t i = 0; i < estado.P.size(); ++i)
        rotulaPunto("P" + std::to_string(i), estado.P[i], vista(), colorNombre(estado.editor, i), LADOS[i]);
    rotulaPunto("   M_BS = 1/6\n" + filasDe("", 6.0f * M_BS, 3), {0.48f, 0.28f, 0}, vista(), OSCURO,
                Lado::CENTRO, 0.9f * TALLA_MATRIZ);
    ponTitulo("Curva B-Spline " + std::string(estado.cerrada ? "cerrada" : "abierta") + ": " +
              std::to_string(estado.P.size()) + " puntos, " + std::to_string(tramos) + " tramos");
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || teclaEditor(estado.editor, tecla))
        return;
    if (tecla == 'c')
        estado.cerrada = !estado.cerrada;
    else if (tecla == 'k')
        estado.peine = !estado.peine;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Curva B-Spline", GLUT_DOUBLE | GLUT_MULTISAMPLE);
    ponFondo(FONDO_CLARO);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    estado.editor = {&estado.P, vista};
    editaConRaton(estado.editor);
    glutMainLoop();
    return 0;
}
