// Giro alrededor de un eje cualquiera por cambio de base (§3.4, ecuaciones 3.9 y 3.10): el eje d y los vectores e y f
// que completan la base, el objeto girado un ángulo φ, el de partida (pálido) y lo que recorre. El giro se calcula
// siempre desde el ángulo: multiplicar un giro tras otro acumula error (dificil_transformaciones_test.cpp). Con t, los
// tres pasos: el cambio de base R, que lleva d al eje X; el giro alrededor de X; y deshacer el cambio.
// Controles: a d giran · 1 2 3 4 ejes Y, diagonal, oblicuo y casi X · t pasos · botón izquierdo mueve el eje,
// derecho orbita · rueda acerca · Esc termina.
#include "avion.h"
#include "buferes.h"
#include "colores.h"
#include "malla.h"
#include "modos.h"
#include "objeto.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "texto.h"
#include "transformaciones.h"
#include "trazo.h"
#include "ventana.h"
#include <glm/gtc/constants.hpp>

static const float PASO_GIRO = 0.1f;         // radianes
static const float RADIANES_POR_ALTO = 1.8f; // arrastrando de abajo arriba de la ventana
static const glm::vec3 EJES[] = {{0, 1, 0}, {1, 1, 1}, {-0.6f, 0.7f, 0.4f}, {1, 1e-10f, 0}};
static const glm::vec3 SITIO(-1.1f, 0.2f, 1.2f); // el centro del avión, sin girar

static const char *const PASOS[] = {"Sin girar", "R: d, al eje X", "Rx(φ)·R", "R⁻¹·Rx(φ)·R"};
enum { SIN_GIRAR, CAMBIADO, GIRADO, DESHECHO, N_PASOS };

static struct {
    GLuint programa;
    Buferes cubo;
    glm::vec3 eje = EJES[0]; // sin normalizar
    float angulo = 2;        // φ, radianes
    int paso = DESHECHO;
    bool moviendoEje = false;
    int xPulsado = 0, yPulsado = 0;
    glm::vec3 ejePulsado; // el que había al pulsar
    Orbita orbita = {-0.5f, 0.4f, 7.4f};
} estado;

static void inicia() {
    estado.programa = creaProgramaObjeto();
    estado.cubo = creaBuferes(cubo());
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE); // las caras de detrás nunca se ven: los sólidos son cerrados
    ponFondo(FONDO_CLARO);
}

// `viveza` 0 lo deja del color del fondo.
static void dibujaAvion(const glm::mat4 &M, float viveza) {
    for (const PiezaAvion &pieza : piezasAvion())
        dibujaObjeto(estado.programa, estado.cubo, M * pieza.M, glm::mix(FONDO_CLARO, pieza.color, viveza));
}

// Por dónde pasa el centro del avión mientras el ángulo va de uno a otro.
static std::vector<glm::vec3> recorrido(const glm::vec3 &d, float desde, float hasta) {
    const int TRAMOS = 64;
    std::vector<glm::vec3> puntos;
    for (int i = 0; i <= TRAMOS; ++i)
        puntos.push_back(giroEje(d, glm::mix(desde, hasta, float(i) / TRAMOS)) * glm::vec4(SITIO, 1));
    return puntos;
}

// Con el rótulo en la punta o, si es de más de una letra, a ese lado de un punto de la flecha: en la punta de d, en el
// eje X, taparía el avión.
static void trazaVector(const char *nombre, const glm::vec3 &v, float largo, const glm::mat4 &transformacion,
                        const glm::vec3 &color, float punto, Lado lado) {
    trazaFlecha(glm::vec3(0), largo * v, transformacion, color, 2 * GROSOR);
    const bool enPunta = nombre[1] == '\0';
    rotulaPunto(nombre, (enPunta ? largo + 0.15f : punto) * v, transformacion, color,
                enPunta ? Lado::CENTRO : lado);
}

// Lo que se lleva hecho de la ecuación 3.10.
static glm::mat4 hastaElPaso(const glm::vec3 &d) {
    const glm::mat4 R(cambioDeBase(d));
    const glm::mat4 pasos[N_PASOS] = {glm::mat4(1), R, giroX(estado.angulo) * R, giroEje(d, estado.angulo)};
    return pasos[estado.paso];
}

static std::string describe(const glm::vec3 &d) {
    // lo que no llega a error de redondeo está puesto a propósito, y se escribe
    const auto escrita = [](float x) { return std::fabs(x) < 1e-9f ? x + 0.0 : aCentesimas(x); };
    return formatea("φ = %.0f°, d = (%.2g, %.2g, %.2g)", glm::degrees(estado.angulo), escrita(d.x),
                    escrita(d.y), escrita(d.z));
}

static void dibuja() {
    const glm::mat4 proyeccion = perspectivaVentana(0.6f, 0.1f, 30), camara = camaraOrbita(estado.orbita);
    const glm::mat4 transformacion = proyeccion * camara;
    const glm::vec3 d = unitario(estado.eje);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    usaPrograma(estado.programa, camara, proyeccion);
    dibujaAvion(traslacion(SITIO), 0.3f);
    dibujaAvion(hastaElPaso(d) * traslacion(SITIO), 1);

    // lo que se traza, donde lo deja el cambio de base mientras está hecho
    const glm::mat3 R = cambioDeBase(d);
    const bool cambiado = estado.paso == CAMBIADO || estado.paso == GIRADO;
    const glm::mat4 enBase = cambiado ? transformacion * glm::mat4(R) : transformacion;
    const std::vector<glm::vec3> arco = recorrido(d, 0, estado.angulo);
    if (estado.paso >= GIRADO) {
        const float vuelta = std::copysign(glm::two_pi<float>(), estado.angulo);
        trazaPolilinea(recorrido(d, estado.angulo, vuelta), enBase, GRIS);
        trazaPolilinea(arco, enBase, MORADO, 1.5f * GROSOR);
    }
    trazaPolilinea({-1.6f * d, glm::vec3(0)}, enBase, OSCURO, 1.5f * GROSOR);
    const glm::mat3 base = glm::transpose(R); // d, e y f, que eran filas, son columnas
    trazaVector(cambiado ? "e=Y" : "e", base[1], 0.9f, enBase, VERDE, 0.9f, Lado::ENCIMA);
    trazaVector(cambiado ? "f=Z" : "f", base[2], 0.9f, enBase, AZUL, 0.85f, Lado::DEBAJO);
    trazaVector(cambiado ? "d=X" : "d", base[0], 1.6f, enBase, ROJO, 0.7f, Lado::ENCIMA);
    const glm::vec3 medio = arco[2 * arco.size() / 5];
    const glm::vec3 haciaFuera = unitario(medio - glm::dot(medio, d) * d);
    if (estado.paso >= GIRADO)
        rotulaPunto("φ", medio + 0.25f * haciaFuera, enBase, MORADO, Lado::CENTRO);
    rotula(describe(d), {0.5f, 0.05f}, OSCURO);
    rotula(PASOS[estado.paso], {0.03f, 0.95f}, OSCURO, Lado::DERECHA);
    ponTitulo("Giro alrededor de un eje: " + describe(d));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    if (tecla == 'a' || tecla == 'd') // dentro de una vuelta: un ángulo grande no tiene decimales
        estado.angulo =
            std::remainder(estado.angulo + (tecla == 'a' ? PASO_GIRO : -PASO_GIRO), glm::two_pi<float>());
    else if (tecla == 't')
        estado.paso = (estado.paso + 1) % N_PASOS;
    else if (int i; eligeModo(i, 4, tecla))
        estado.eje = EJES[i];
    else
        return;
    glutPostRedisplay();
}

static void boton(int cual, int pulsado, int x, int y) {
    if (cual == GLUT_RIGHT_BUTTON)
        orbitaBoton(GLUT_LEFT_BUTTON, pulsado, x, y);
    if (cual != GLUT_LEFT_BUTTON)
        return;
    estado.moviendoEje = pulsado == GLUT_DOWN;
    estado.xPulsado = x;
    estado.yPulsado = y;
    estado.ejePulsado = unitario(estado.eje);
}

// El eje gira con el ratón alrededor de la vertical y de la horizontal de la pantalla, que en el mundo son
// las dos primeras filas de la cámara, lo mismo en un paso que en varios.
static void arrastra(int x, int y) {
    if (!estado.moviendoEje)
        return orbitaArrastra(x, y);
    const glm::mat3 pantalla = glm::transpose(glm::mat3(camaraOrbita(estado.orbita)));
    const glm::vec2 angulos =
        RADIANES_POR_ALTO / altoUtil() * glm::vec2(x - estado.xPulsado, y - estado.yPulsado);
    estado.eje =
        glm::mat3(giroEje(pantalla[0], angulos.y) * giroEje(pantalla[1], angulos.x)) * estado.ejePulsado;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Giro alrededor de un eje", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMouseFunc(boton);
    glutMotionFunc(arrastra);
    glutMainLoop();
    return 0;
}
