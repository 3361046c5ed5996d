// Sistemas de partículas (§12.3): una fuente, humo y fuego. Toda la animación está en el vertex shader, sin carga para
// la CPU: cada imagen son unos uniforms y una orden de dibujo, lo mismo con una partícula que con un millón. Tampoco
// hay memoria: cada partícula es una función de su número y del instante, y no se desvía por mucho que pase el tiempo.
// Controles: 1 fuente · 2 humo · 3 fuego · + - diez veces más o menos · espacio pausa ·
// s adelanta medio segundo · d una décima · h diez horas · ratón orbita · Esc termina.
#include "animacion.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "modos.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "reloj.h"
#include "shader.h"
#include "trazo.h"
#include "ventana.h"
#include <algorithm>
#include <glm/gtc/constants.hpp>

static const int MAXIMO = 1000000, NORMAL = 10000;
static const struct {
    const char *nombre;
    double vida; // segundos; todo se repite cada vida
    int grupos;  // chorros, bocanadas o lenguas
    float pila;  // radio de la circunferencia del suelo
    GLenum destino;
} MODOS[] = {{"Fuente", 3, 13, 2.1f, GL_ONE},
             {"Humo", 4, 60, 0.5f, GL_ONE_MINUS_SRC_ALPHA},
             {"Fuego", 1.5, 7, 1.15f, GL_ONE}};

static struct {
    GLuint programa, vao;
    int elegido = 0, cuantas = NORMAL;
    Orbita orbita = {0.4f, 0.12f, 12, {0, 1.95f, 0}, 0.02f};
    Reloj reloj;
} estado;

static std::string nombraPartes(int n) { // 1 000 000 partículas
    std::string cifras = std::to_string(n);
    for (std::size_t i = cifras.size(); i > 3; i -= 3)
        cifras.insert(i - 3, " ");
    return cifras + (n == 1 ? " partícula" : " partículas");
}

static void dibuja() {
    const auto &modo = MODOS[estado.elegido];
    const glm::mat4 camara = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.55f, 0.5f, 50);
    const float muchas = float(estado.cuantas) / float(NORMAL);
    glClear(GL_COLOR_BUFFER_BIT);
    trazaPolilinea(circunferencia(modo.pila, 72), proyeccion * camara * giroX(glm::half_pi<float>()), GRIS,
                   GROSOR, true);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, modo.destino); // lo que da luz se suma; el humo tapa
    usaPrograma(estado.programa, camara, proyeccion);
    envia(estado.programa, "elegido", estado.elegido);
    envia(estado.programa, "grupos", modo.grupos);
    envia(estado.programa, "vida", float(modo.vida));
    envia(estado.programa, "tau", fase(tiempo(estado.reloj), modo.vida));
    envia(estado.programa, "talla", 0.5f * proyeccion[1][1] * float(glutGet(GLUT_WINDOW_HEIGHT)));
    // la superficie que cubren entre todas no cambia con su número; si son pocas, que se vean
    envia(estado.programa, "escala", std::min(1 / std::sqrt(muchas), 3.0f));
    glBindVertexArray(estado.vao);
    glDrawArrays(GL_POINTS, 0, estado.cuantas);
    glDisable(GL_BLEND);

    const std::string cuantas = nombraPartes(estado.cuantas);
    rotulaTiempo(estado.reloj, BLANCO, ", " + cuantas);
    tituloAnimado(estado.reloj, std::string(modo.nombre) + ": " + cuantas);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaAnimacion(estado.reloj, tecla) || eligeModo(estado.elegido, 3, tecla))
        return;
    if (tecla == '+')
        estado.cuantas = std::min(estado.cuantas * 10, MAXIMO);
    else if (tecla == '-')
        estado.cuantas = std::max(estado.cuantas / 10, 1);
    else
        return;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Sistemas de partículas", GLUT_DOUBLE | GLUT_MULTISAMPLE);
    estado.programa = creaPrograma("ch12_animacion/particulas.vert", "ch12_animacion/particulas.frag");
    glGenVertexArrays(1, &estado.vao); // sin atributos, pero hace falta uno
    glEnable(GL_PROGRAM_POINT_SIZE);
    ponFondo(FONDO_OSCURO);
    glutDisplayFunc(dibuja);
    orbitaConRaton(estado.orbita);
    animaConReloj(estado.reloj);
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
