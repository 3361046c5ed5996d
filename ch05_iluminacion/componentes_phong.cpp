// Los tres componentes del modelo de Phong (figura 5.1): solo luz ambiente (ecuación 5.1), más reflexión difusa (5.2)
// y más reflexión especular (5.4). Un componente se quita apagando su luz, Ld o Ls. Con n, su geometría (figura 5.2)
// en un punto: N, L, R (ecuación 5.5), V y los ángulos θ y Φ; a la derecha, vista de lado, en el plano de N y L.
// Controles: 1 ambiente · 2 más difusa · 3 más especular · n vectores y ángulos · clic elige el punto ·
// ratón orbita · Esc termina.
#include "aspecto.h"
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
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

static const Material CERAMICA = {{0.08f, 0.20f, 0.38f}, {0.14f, 0.36f, 0.62f}, {0.75f, 0.75f, 0.75f}, 30};
static const Material LATON = {{0.42f, 0.23f, 0.05f}, {0.58f, 0.36f, 0.08f}, {0.60f, 0.55f, 0.45f}, 30};
static const glm::vec3 LA(1), POSICION(-3.5f, 4, 6);
static const std::string TITULOS[] = {"solo luz ambiente", "ambiente y difusa",
                                      "ambiente, difusa y especular"};
static const char *const NOMBRES[] = {"ambiente", "ambiente\n+ difusa", "ambiente\n+ difusa\n+ especular"};
static const float LARGO = 1.2f; // de los vectores, que son unitarios

static struct {
    GLuint programa;
    Buferes esfera, anillo;
    Orbita orbita = {0.0f, 0.0f, 10, {0, 0, 0}};
    int elegido = 2;
    bool vectores = false;
    glm::vec3 P = glm::normalize(glm::vec3(-0.16f, 0.18f, 0.97f)); // en la esfera: también es su normal
    glm::ivec2 pulsado;
} estado;

static void inicia() {
    estado.programa = creaSombreado("phong");
    estado.esfera = creaBuferes(esfera(segmentosEsfera(230)));
    estado.anillo = creaBuferes(toro(1.55f, 0.22f, segmentosEsfera(400), segmentosEsfera(60)));
    glEnable(GL_DEPTH_TEST);
}

static Recuadro panelEscena() {
    return estado.vectores ? reparte(2)[0] : ventanaEntera();
}

static glm::mat4 proyeccionEscena() {
    return perspectivaVentana(0.31f, 1, 100, aspecto(panelEscena()));
}

// Deja el programa en uso con esa vista y las luces de los componentes elegidos, 0 si solo la luz ambiente.
static void preparaVista(const glm::mat4 &proyeccion, const glm::mat4 &camara, int componentes) {
    Luz luz{glm::vec4(POSICION, 1)};
    luz.Ld = glm::vec3(componentes >= 1 ? 1 : 0);
    luz.Ls = glm::vec3(componentes >= 2 ? 1 : 0);
    usaPrograma(estado.programa, camara, proyeccion);
    envia(estado.programa, "La", LA);
    enviaLuz(estado.programa, "luz", luz, camara);
}

static void trazaVector(const char *nombre, const glm::vec3 &v, const glm::vec3 &color,
                        const glm::mat4 &vista) {
    const glm::vec3 punta = estado.P + LARGO * v;
    trazaFlecha(estado.P, punta, vista, color);
    rotulaPunto(nombre, punta, vista, color);
}

// El arco de `a` a `b`, unitarios, con su nombre; devuelve el nombre y los grados.
static std::string trazaAngulo(const std::string &nombre, const glm::vec3 &a, const glm::vec3 &b, float radio,
                               const glm::vec3 &color, const glm::mat4 &vista) {
    std::vector<glm::vec3> arco;
    for (int i = 0; i <= 16; ++i)
        arco.push_back(estado.P + radio * unitario(glm::mix(a, b, float(i) / 16)));
    trazaPolilinea(arco, vista, color);
    rotulaPunto(nombre, glm::mix(estado.P, arco[8], 1.25f), vista, color, Lado::CENTRO);
    const float angulo = std::acos(glm::clamp(glm::dot(a, b), -1.0f, 1.0f));
    return nombre + " = " + std::to_string(std::lround(glm::degrees(angulo))) + "°";
}

// La figura 5.2 en el punto elegido. De espaldas a la luz (θ > 90°) no hay reflexión, ni R.
static void dibujaVectores(const Recuadro &panel, const glm::mat4 &vistaEscena) {
    const glm::vec3 &P = estado.P;
    const glm::vec3 &N = P, L = glm::normalize(POSICION - P),
                    V = glm::normalize(posicionCamara(estado.orbita) - P);
    const glm::vec3 R = 2.0f * N * glm::dot(N, L) - L;
    const bool refleja = glm::dot(N, L) > 0;
    trazaPuntos({P}, vistaEscena, OSCURO);
    rotulaPunto("P", P, vistaEscena, OSCURO, Lado::DERECHA);

    abreRecuadro(panel);
    ponFondo(FONDO_OSCURO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::vec3 deLado = unitario(glm::cross(N, L)), centro = P - 0.25f * N;
    // caben la esfera entera y los vectores, con sus nombres: 3.9 de alto por 2.2 de ancho
    const float semialto = std::max(1.95f / float(ampliacionVertical(aspecto(panel))), 1.1f * 3 / 4);
    const glm::mat4 camara = glm::lookAt(centro + 5.0f * deLado, centro, N),
                    proyeccion = paralelaVentana(semialto, 1, 10, aspecto(panel));
    const glm::mat4 vista = proyeccion * camara;
    preparaVista(proyeccion, camara, 0);
    dibujaIluminado(estado.programa, estado.esfera, glm::mat4(1), camara, CERAMICA);
    trazaVector("N", N, BLANCO, vista);
    trazaVector("L", L, AMARILLO, vista);
    trazaVector("V", V, VERDE, vista);
    std::string angulos = trazaAngulo("θ", L, N, 0.45f, AMARILLO, vista);
    if (refleja) {
        trazaVector("R", R, ROJO, vista);
        angulos += "\n" + trazaAngulo("Φ", R, V, 0.7f, ROJO, vista);
    }
    rotulaPunto(angulos, 0.6f * P, vista, BLANCO, Lado::DEBAJO);
}

static void dibuja() {
    abreRecuadro(ventanaEntera());
    ponFondo(GRIS);
    glClear(GL_COLOR_BUFFER_BIT);
    const Recuadro panel = panelEscena();
    abreRecuadro(panel);
    ponFondo(FONDO_OSCURO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 camara = camaraOrbita(estado.orbita), proyeccion = proyeccionEscena();
    preparaVista(proyeccion, camara, estado.elegido);
    dibujaIluminado(estado.programa, estado.esfera, glm::mat4(1), camara, CERAMICA);
    dibujaIluminado(estado.programa, estado.anillo, giroZ(0.35f) * giroX(-1.15f), camara, LATON);
    rotula(NOMBRES[estado.elegido], {0.2f, 1}, BLANCO, Lado::DEBAJO);
    if (estado.vectores)
        dibujaVectores(reparte(2)[1], proyeccion * camara);
    ponTitulo("Modelo de Phong: " + TITULOS[estado.elegido]);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || eligeModo(estado.elegido, 3, tecla))
        return;
    if (tecla == 'n')
        estado.vectores = !estado.vectores;
    glutPostRedisplay();
}

// El punto de la esfera que se ve en (x, y), si hay alguno: el rayo cámara + t·d entra en ella con la menor t.
static void eligePunto(int x, int y) {
    const Recuadro panel = panelEscena();
    const glm::vec2 enPanel((float(x - panel.x) + 0.5f) / float(panel.ancho),
                            (float(glutGet(GLUT_WINDOW_HEIGHT) - y - panel.y) - 0.5f) / float(panel.alto));
    const glm::vec4 q = glm::inverse(proyeccionEscena() * camaraOrbita(estado.orbita)) *
                        glm::vec4(2.0f * enPanel - 1.0f, 1, 1);
    const glm::vec3 ojo = posicionCamara(estado.orbita);
    const glm::vec3 d = glm::normalize(glm::vec3(q) / q.w - ojo);
    const float b = glm::dot(ojo, d);
    const float discriminante = b * b - glm::dot(ojo, ojo) + 1;
    if (enPanel.x < 0 || enPanel.x > 1 || enPanel.y < 0 || enPanel.y > 1 || discriminante < 0)
        return;
    estado.P = glm::normalize(ojo + (-b - std::sqrt(discriminante)) * d);
    glutPostRedisplay();
}

static void boton(int cual, int accion, int x, int y) {
    orbitaBoton(cual, accion, x, y);
    if (cual != GLUT_LEFT_BUTTON)
        return;
    if (accion == GLUT_DOWN)
        estado.pulsado = {x, y};
    else if (estado.vectores && estado.pulsado == glm::ivec2(x, y)) // si no, ha arrastrado
        eligePunto(x, y);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Modelo de Phong", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMouseFunc(boton);
    glutMainLoop();
    return 0;
}
