// Cuánta profundidad cabe en el buffer (§4.4 y §4.5): doce carteles entre 12 y 800 m, cada uno con un cuadro
// amarillo 5 cm por delante. Con lejos a 1 km, acercar el plano cerca reparte casi todos los valores del buffer
// junto a la cámara, y de lejos dos superficies reciben la misma profundidad: lo azul asoma por lo amarillo.
// GLUT_DEPTH no dice de cuántos bits es el buffer (24 o 32 según la ventana): se dibuja en uno propio de 24.
// Controles: 1 2 3 lejos/cerca 100, 10 000 y 1 000 000 · ratón orbita · Esc termina.
#include "profundidad.h"
#include "buferes.h"
#include "captura.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "imagen.h"
#include "malla.h"
#include "modos.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "ventana.h"
#include <cstdio>

static const int COLUMNAS = 4, FILAS = 3;
static const float PRIMERO = 12, ULTIMO = 800, SEPARACION = 0.05f, LEJOS = 1000; // metros
static const float CERCA[] = {10, 0.1f, 0.001f};
static const char *const RAZON[] = {"100", "10 000", "1 000 000"};
static const float GIRO = 0.06f;                                    // radianes
static const float TALLA = 0.185f, PASO_X = 0.27f, PASO_Y = 0.245f; // de los carteles, a distancia 1

static struct {
    GLuint programa, framebuffer, color, profundidad;
    Buferes plano;
    int elegido = 0;
    bool informa = true;
    Orbita orbita = {0, 0, 15, {0, 0, -15}}; // la cámara, en el origen
} estado;

static void inicia() {
    estado.programa = creaPrograma("ch04_vista3d/profundidad.vert", "common/liso.frag");
    estado.plano = creaBuferes(plano(16));
    glGenFramebuffers(1, &estado.framebuffer);
    glGenRenderbuffers(1, &estado.color);
    glGenRenderbuffers(1, &estado.profundidad);
    ponFondo(CIELO);
}

static void cambiaTamano(int ancho, int alto) {
    ancho = std::max(ancho, 1);
    alto = std::max(alto, 1);
    glViewport(0, 0, ancho, alto);
    glBindFramebuffer(GL_FRAMEBUFFER, estado.framebuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, estado.color);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, ancho, alto);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, estado.color);
    glBindRenderbuffer(GL_RENDERBUFFER, estado.profundidad);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, ancho, alto);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, estado.profundidad);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

static void dibujaPlano(const glm::mat4 &M, const glm::vec3 &color) {
    envia(estado.programa, "M", M);
    envia(estado.programa, "color", color);
    dibujaMalla(estado.plano);
}

static float distanciaCartel(int i) {
    return PRIMERO * std::pow(ULTIMO / PRIMERO, float(i) / (COLUMNAS * FILAS - 1));
}

// A distancia 1: de izquierda a derecha y de arriba abajo.
static glm::vec3 centroCartel(int i) {
    return {PASO_X * (float(i % COLUMNAS) - 0.5f * (COLUMNAS - 1)),
            PASO_Y * (0.5f * (FILAS - 1) - float(i / COLUMNAS)) + 0.055f, -1};
}

static glm::mat4 proyeccion() {
    return perspectivaVentana(0.8f, CERCA[estado.elegido], LEJOS);
}

// Los carteles crecen con la distancia y se ven todos iguales; inclinados, cada uno abarca muchas profundidades.
// El cuadro se pinta después: donde las dos profundidades son iguales, el test (<) deja lo azul.
static void dibujaCarteles() {
    envia(estado.programa, "proyeccion", proyeccion());
    envia(estado.programa, "camara", camaraOrbita(estado.orbita));
    for (int i = 0; i < COLUMNAS * FILAS; ++i) {
        const float d = distanciaCartel(i);
        const glm::mat4 inclinado = giroY(0.5f) * giroX(-0.5f) * escalado(TALLA * d);
        dibujaPlano(traslacion(d * centroCartel(i)) * inclinado, AZUL);
        dibujaPlano(traslacion(d * centroCartel(i) + glm::vec3(0, 0, SEPARACION)) * inclinado *
                        escalado(0.8f),
                    AMARILLO);
    }
}

static void rotulaDistancias() {
    const glm::mat4 aRecortado = proyeccion() * camaraOrbita(estado.orbita);
    for (int i = 0; i < COLUMNAS * FILAS; ++i) {
        const float d = distanciaCartel(i);
        rotulaPunto(std::to_string(std::lround(d)) + " m", d * (centroCartel(i) - glm::vec3(0, 0.107f, 0)),
                    aRecortado, OSCURO, Lado::DEBAJO, 0.033f);
    }
}

static void copiaEnVentana() {
    const int ancho = glutGet(GLUT_WINDOW_WIDTH), alto = glutGet(GLUT_WINDOW_HEIGHT);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, ancho, alto, 0, 0, ancho, alto, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, estado.framebuffer);
}

static int cuentaAmarillos() {
    copiaEnVentana();
    const Imagen ventana = leeVentana();
    int n = 0;
    for (std::size_t i = 0; i < ventana.rgb.size(); i += 3)
        n += ventana.rgb[i] > ventana.rgb[i + 2];
    return n;
}

// Dos maneras de contar pares: los píxeles de los cuadros, y el cálculo de profundidad.h para superficies
// separadas una cienmilésima de su distancia. `amarillos`: los píxeles en que el cuadro debería verse.
static void informa(int amarillos) {
    const double cerca = CERCA[estado.elegido], lejos = LEJOS;
    GLint bits = 0;
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_DEPTH_SIZE, &bits);
    const double mal = amarillos > 0 ? 1 - double(cuentaAmarillos()) / amarillos : 0;
    std::printf("cerca %g m, lejos %g m, %d bits\n", cerca, lejos, bits);
    std::printf("  carteles: %.1f %% de %d píxeles con lo azul delante\n", 100 * mal, amarillos);
    std::printf(
        "  de cada cien pares a una cienmilésima de su distancia, %.1f reciben la misma profundidad\n",
        100 * cuentaPares<double>(cerca, lejos, 1e-5, bits).iguales);
    std::fflush(stdout);
}

static void dibuja() {
    glBindFramebuffer(GL_FRAMEBUFFER, estado.framebuffer);
    glUseProgram(estado.programa);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    int amarillos = 0;
    if (estado.informa) { // sin test, el cuadro, que va después, queda entero encima
        dibujaCarteles();
        amarillos = cuentaAmarillos();
        glClear(GL_COLOR_BUFFER_BIT);
    }
    glEnable(GL_DEPTH_TEST);
    dibujaCarteles();
    glDisable(GL_DEPTH_TEST);
    if (estado.informa)
        informa(amarillos);
    estado.informa = false;
    copiaEnVentana();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    rotulaDistancias();
    const std::string razon = std::string("lejos/cerca = ") + RAZON[estado.elegido];
    rotula(razon, {0.5f, 0.035f}, OSCURO, Lado::CENTRO, 0.04f);
    ponTitulo("Precisión de la profundidad: " + razon);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || !eligeModo(estado.elegido, 3, tecla))
        return;
    estado.informa = true;
}

// Poco, para que no se salga ningún cartel: el que gira es el camino entero.
static void arrastra(int x, int y) {
    orbitaArrastra(x, y);
    estado.orbita.azimut = glm::clamp(estado.orbita.azimut, -GIRO, GIRO);
    estado.orbita.elevacion = glm::clamp(estado.orbita.elevacion, -GIRO, GIRO);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Precisión de la profundidad", GLUT_DOUBLE | GLUT_DEPTH);
    inicia();
    glutDisplayFunc(dibuja);
    glutReshapeFunc(cambiaTamano);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMotionFunc(arrastra);
    glutMainLoop();
    return 0;
}
