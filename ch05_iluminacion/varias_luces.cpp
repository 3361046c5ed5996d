// Varias fuentes de luz, cada una con sus propios coeficientes (ecuación 5.7): un foco rojo, uno verde y uno azul sobre
// objetos blancos. Las luces se suman: rojo y verde dan amarillo, y los tres juntos blanco. La luz ambiente se cuenta
// una sola vez. Una luz se apaga con Ld = Ls = 0.
// Controles: 1 2 3 encienden y apagan cada luz · ratón orbita · Esc termina.
#include "buferes.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "iluminacion.h"
#include "malla.h"
#include "materiales.h"
#include "modos.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "trazo.h"
#include "ventana.h"
#include <cmath>
#include <glm/gtc/constants.hpp>

static const int LUCES = 3;
static const float DELTA = 0.40f; // radianes
static const struct {
    const char *nombre;
    glm::vec3 color;
    float exponente;
} FOCOS[LUCES] = {
    {"roja", {0.92f, 0.06f, 0.06f}, 2}, {"verde", {0.06f, 0.95f, 0.06f}, 3}, {"azul", {0.06f, 0.06f, 1}, 4}};

static const Material MATE = {{0.20f, 0.20f, 0.22f}, {0.80f, 0.80f, 0.80f}, {0, 0, 0}, 1};
static const Material BRILLANTE = {{0.20f, 0.20f, 0.22f}, {0.60f, 0.60f, 0.60f}, {0.30f, 0.30f, 0.30f}, 40};

static struct {
    GLuint programa;
    Buferes disco, esfera;
    Orbita orbita = {0, 0.85f, 18.2f, {0, -0.25f, 0}, 0.05f};
    bool encendida[LUCES] = {true, true, true};
} estado;

static void inicia() {
    estado.programa =
        creaPrograma("ch05_iluminacion/sombreado_phong.vert", "ch05_iluminacion/varias_luces.frag");
    estado.disco = creaBuferes(cilindro(segmentosEsfera(430)));
    estado.esfera = creaBuferes(esfera(segmentosEsfera(100)));
    glEnable(GL_DEPTH_TEST);
    ponFondo(FONDO_OSCURO);
}

// Los tres focos salen de un círculo: hacia dónde, desde su centro.
static glm::vec3 haciaFoco(int i) {
    const float angulo = glm::radians(-150 + 120 * float(i));
    return {std::cos(angulo), 0, -std::sin(angulo)};
}

// Apuntan cerca del centro, donde se cruzan.
static Luz foco(int i) {
    const glm::vec3 posicion = 3.0f * haciaFoco(i) + glm::vec3(0, 5, 0), apunta = 1.1f * haciaFoco(i);
    Luz luz{glm::vec4(posicion, 1)};
    luz.Ld = luz.Ls = estado.encendida[i] ? FOCOS[i].color : glm::vec3(0);
    luz.atenuacion = {0.6f, 0.04f, 0.01f};
    luz.S = glm::normalize(apunta - posicion);
    luz.cosDelta = std::cos(DELTA);
    luz.exponente = FOCOS[i].exponente;
    return luz;
}

// El borde del círculo que ilumina un foco en el suelo, esté encendido o no.
static std::vector<glm::vec3> bordeEnSuelo(const Luz &luz) {
    const glm::vec3 lado = glm::normalize(glm::cross(luz.S, glm::vec3(0, 0, 1)));
    std::vector<glm::vec3> borde = circunferencia(std::tan(DELTA));
    for (glm::vec3 &p : borde) {
        const glm::vec3 rayo = luz.S + p.x * lado + p.y * glm::cross(luz.S, lado);
        p = glm::vec3(luz.Lp) - luz.Lp.y / rayo.y * rayo;
    }
    return borde;
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 camara = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.36f, 1, 100);
    usaPrograma(estado.programa, camara, proyeccion);
    envia(estado.programa, "La", glm::vec3(1));
    for (int i = 0; i < LUCES; ++i)
        enviaLuz(estado.programa, "luces[" + std::to_string(i) + "]", foco(i), camara);
    dibujaIluminado(estado.programa, estado.disco,
                    traslacion({0, -0.1f, 0}) * giroX(-glm::half_pi<float>()) * escalado({3.7f, 3.7f, 0.2f}),
                    camara, MATE);
    dibujaIluminado(estado.programa, estado.esfera, traslacion({0, 0.65f, -1}) * escalado(0.65f), camara,
                    BRILLANTE);
    std::string titulo;
    for (int i = 0; i < LUCES; ++i) {
        const std::string nombre = FOCOS[i].nombre;
        trazaPolilinea(bordeEnSuelo(foco(i)), proyeccion * camara, FOCOS[i].color, 0.5f * GROSOR, true);
        rotulaPunto(std::to_string(i + 1) + (estado.encendida[i] ? " " + nombre : " apagada"),
                    3.2f * haciaFoco(i), proyeccion * camara, estado.encendida[i] ? BLANCO : GRIS,
                    Lado::CENTRO);
        if (estado.encendida[i])
            titulo += (titulo.empty() ? "" : " + ") + nombre;
    }
    ponTitulo("Varias fuentes de luz: " + (titulo.empty() ? "todas apagadas" : titulo));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (int i; !teclaComun(tecla) && eligeModo(i, 3, tecla))
        estado.encendida[i] = !estado.encendida[i];
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Varias fuentes de luz", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
