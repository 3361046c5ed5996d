// La matriz del modelo cambia con el tiempo (§12.1), y con ella la posición, el tamaño o la orientación del objeto: la
// malla y el shader son siempre los mismos. Pálido, el objeto en instantes anteriores; en morado, el camino del morro y
// las columnas de la matriz que no son de la identidad.
// Controles: 1 posición · 2 tamaño · 3 orientación · espacio pausa · s adelanta medio segundo · d una décima ·
// h diez horas · ratón orbita · Esc termina.
#include "animacion.h"
#include "buferes.h"
#include "ch03_transformaciones/avion.h"
#include "ch03_transformaciones/dibujos.h"
#include "ch03_transformaciones/objeto.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "malla.h"
#include "matriz.h"
#include "modos.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "reloj.h"
#include "rotulo.h"
#include "shader.h"
#include "texto.h"
#include "trazo.h"
#include "ventana.h"
#include <glm/gtc/constants.hpp>

static const double PERIODO = 6, ENTRE_ESTELAS = 0.35; // segundos
static const int ESTELAS = 3;
static const glm::vec4 PUNTA(MORRO, 0.11f, 0, 1); // arriba: su camino no se confunde con un eje
static const struct {
    const char *nombre, *matriz;
    glm::mat4 (*M)(float a); // a: de 0 a 2π en un periodo
    float angulo;            // el de la vista: el avión que no se va del centro se ve más grande
} MODOS[] = {
    {"posición", "T(cos a, 0, −sen a) =",
     [](float a) { return traslacion(glm::vec3(std::cos(a), 0, -std::sin(a))); }, 0.5f},
    {"tamaño", "S(1 + 0.5 sen a) =", [](float a) { return escalado(1 + 0.5f * std::sin(a)); }, 0.41f},
    {"orientación", "Ry(a) =", giroY, 0.41f},
};
static struct {
    GLuint programa;
    Buferes cubo;
    int elegido = 0;
    Orbita orbita = {0.35f, 0.5f, 5.7f, {0, -0.2f, 0}};
    Reloj reloj;
} estado;

static void inicia() {
    estado.programa = creaProgramaObjeto();
    estado.cubo = creaBuferes(cubo());
    glEnable(GL_DEPTH_TEST);
    ponFondo(FONDO_CLARO);
}

static glm::mat4 matrizEn(double t) {
    return MODOS[estado.elegido].M(glm::two_pi<float>() * fase(t, PERIODO));
}

static void dibuja() {
    const auto &modo = MODOS[estado.elegido];
    const double t = tiempo(estado.reloj);
    const glm::mat4 camara = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(modo.angulo, 1, 50);
    const glm::mat4 transformacion = proyeccion * camara;
    glClear(GL_COLOR_BUFFER_BIT);
    usaPrograma(estado.programa, camara, proyeccion);
    for (int k = ESTELAS; k >= 0; --k) { // cuanto más antiguo, más pálido, y siempre detrás
        glClear(GL_DEPTH_BUFFER_BIT);
        const glm::mat4 M = matrizEn(t - k * ENTRE_ESTELAS);
        for (const PiezaAvion &pieza : piezasAvion())
            dibujaObjeto(estado.programa, estado.cubo, M * pieza.M,
                         glm::mix(pieza.color, FONDO_CLARO, k ? 0.5f + 0.12f * float(k) : 0));
    }

    std::vector<glm::vec3> camino;
    for (int i = 0; i < 90; ++i)
        camino.push_back(matrizEn(PERIODO * i / 90) * PUNTA);
    trazaPolilinea(camino, transformacion, MORADO, GROSOR, true);
    trazaPuntos({matrizEn(t) * PUNTA}, transformacion, MORADO);
    trazaEjes(glm::vec3(0.8f), transformacion);
    const std::string a = formatea("a = %.0f°\n", 360 * fase(t, PERIODO));
    rotula(a + modo.matriz, {0.43f, 0.2f}, OSCURO, Lado::IZQUIERDA, 0.027f);
    rotulaMatriz(matrizEn(t), {0.43f, 0.15f});
    rotulaTiempo(estado.reloj, OSCURO);
    tituloAnimado(estado.reloj, std::string("Matriz del modelo: ") + modo.nombre);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (!teclaAnimacion(estado.reloj, tecla))
        eligeModo(estado.elegido, 3, tecla);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Matriz del modelo", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    orbitaConRaton(estado.orbita);
    animaConReloj(estado.reloj);
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
