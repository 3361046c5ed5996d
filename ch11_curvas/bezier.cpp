// La curva cúbica de Bézier (ecuaciones 11.12 a 11.19): su polígono de control, su casco convexo, de donde no sale, y
// la construcción de de Casteljau, que halla Q(u) partiendo en u los lados del polígono, una y otra vez: el mismo punto
// que U·M_B·G, en el que U·M_B es el peso de cada punto de control.
// Controles: arrastra los puntos (o n y flechas) · u U mueven u · Esc termina.
#include "colores.h"
#include "curvas.h"
#include "editor.h"
#include "escenas_curvas.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "texto.h"
#include "trazo.h"
#include "ventana.h"

static const glm::vec3 COLOR_NIVEL[] = {GRIS, VERDE, NARANJA},
                       COLOR_CASCO = glm::mix(FONDO_CLARO, AZUL, 0.1f);
static const float PASO_U = 0.05f;

static struct {
    std::vector<glm::vec3> P = PUNTOS_BEZIER;
    float u = 0.4f;
    Editor editor;
} estado;

static glm::mat4 vista() {
    return paralelaVentana(1);
}

// Cada punto del casco convexo de unos puntos del plano está en un triángulo de tres de ellos.
static void pintaCasco() {
    for (std::size_t falta = 0; falta < 4; ++falta) {
        std::vector<glm::vec3> tres = estado.P;
        tres.erase(tres.begin() + std::ptrdiff_t(falta));
        trazaPoligono(tres, vista(), COLOR_CASCO);
    }
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT);
    pintaCasco();
    const auto niveles = casteljau(estado.P, estado.u);
    for (std::size_t k = 0; k < 3; ++k)
        trazaPolilinea(niveles[k], vista(), COLOR_NIVEL[k], 0.8f * GROSOR);
    const float pixel = 2 / altoUtil(); // el alto de la vista son dos unidades
    trazaPolilinea(polilineaBezier(estado.P, 0.1 * pixel), vista(), AZUL, 1.7f * GROSOR);
    for (std::size_t k = 1; k < 3; ++k)
        trazaPuntos(niveles[k], vista(), COLOR_NIVEL[k], 2.5f * GROSOR);
    const glm::vec4 UM = potencias(estado.u) * M_B;
    const glm::vec3 Q = UM * enFilas({estado.P[0], estado.P[1], estado.P[2], estado.P[3]}); // ecuación 11.16
    trazaPuntos({Q}, vista(), ROJO, 5 * GROSOR);
    trazaPuntos(estado.P, vista(), OSCURO, 4 * GROSOR);
    for (std::size_t i = 0; i < 4; ++i)
        rotulaPunto("P" + std::to_string(i + 1), estado.P[i], vista(), colorNombre(estado.editor, i),
                    i % 3 == 0 ? Lado::DEBAJO : Lado::ENCIMA);
    // hacia dentro del casco, para no tapar la curva ni los nombres de los extremos
    const glm::vec3 dentro = 0.25f * (estado.P[0] + estado.P[1] + estado.P[2] + estado.P[3]) - Q;
    rotulaPunto(formatea("Q(%.2f)", estado.u), Q + 0.2f * dentro / std::max(glm::length(dentro), 0.01f),
                vista(), ROJO, Lado::CENTRO);
    rotulaPunto(filasDe("M_B = ", M_B, 3), {0.05f, -0.28f, 0}, vista(), OSCURO, Lado::CENTRO, TALLA_MATRIZ);
    rotulaPunto(formatea("U·M_B = %.2f %.2f %.2f %.2f", UM.x, UM.y, UM.z, UM.w), {0.05f, -0.79f, 0}, vista(),
                OSCURO, Lado::CENTRO, TALLA_MATRIZ);
    ponTitulo(formatea("Curva de Bézier: u = %.2f", estado.u));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || teclaEditor(estado.editor, tecla) || (tecla != 'u' && tecla != 'U'))
        return;
    estado.u = glm::clamp(estado.u + (tecla == 'u' ? PASO_U : -PASO_U), 0.0f, 1.0f);
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Curva de Bézier", GLUT_DOUBLE | GLUT_MULTISAMPLE);
    ponFondo(FONDO_CLARO);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    estado.editor = {&estado.P, vista};
    editaConRaton(estado.editor);
    glutMainLoop();
    return 0;
}
