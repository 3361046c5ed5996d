// Sombras proyectivas (ecuación 7.4, figura 7.4): cada objeto se dibuja otra vez, proyectado sobre la mesa desde la
// luz y de un color oscuro: es el objeto sombra. El desplazamiento de polígono evita que sombra y mesa se cosan; la
// plantilla, que la sombra salga de la mesa y que, transparente, oscurezca dos veces donde dos se solapan. Lo que es
// más alto que la luz no da sombra (sombra.h).
// Controles: t transparente · o desplazamiento · p plantilla · arrastrar con el botón derecho mueve la luz ·
// w s la alejan y la acercan · ratón orbita · Esc termina.
#include "baldosas.h"
#include "buferes.h"
#include "ch03_transformaciones/transformaciones.h"
#include "ch05_iluminacion/iluminacion.h"
#include "ch05_iluminacion/materiales.h"
#include "colores.h"
#include "malla.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "reflexion.h"
#include "rotulo.h"
#include "shader.h"
#include "sombra.h"
#include "ventana.h"
#include <algorithm>
#include <glm/gtc/constants.hpp>

static const Plano MESA = {{0, 1, 0}, 0};
static const glm::vec3 TALLA_MESA(6, 0.25f, 4.4f);
static const glm::vec3 VUELO(0.06f, 0, 0.06f); // del tablero: sin él, asomaría la tabla por su canto
static const float UNIDADES_POR_ALTO = 1.8f;   // al arrastrar la luz de abajo arriba de la ventana
static const float RADIO_LUZ = 0.14f;
static const float PASO = 0.2f, FONDO = 2; // de la luz en profundidad: lo que anda y hasta dónde

static Material pintura(const glm::vec3 &color) {
    return {0.35f * color, 0.75f * color, glm::vec3(0.3f), 30};
}

static struct {
    GLuint deObjetos, deSombras;
    Buferes cubo, esfera, toro, cilindro, claras, oscuras;
    glm::vec3 luz = {-1.8f, 3.2f, 0.8f};
    bool transparente = true, desplaza = true, plantilla = true, moviendo = false;
    int x = 0, y = 0; // del ratón
    Orbita orbita = {0.25f, 0.48f, 13, {0.2f, 0.8f, 0}, 0.05f};
} estado;

static void inicia() {
    estado.deObjetos = creaSombreado("phong");
    estado.deSombras = creaPrograma("ch03_transformaciones/objeto.vert", "ch07_realismo/liso.frag");
    estado.cubo = creaBuferes(cubo());
    estado.esfera = creaBuferes(esfera(48));
    estado.toro = creaBuferes(toro(0.7f, 0.22f, 64, 32));
    estado.cilindro = creaBuferes(cilindro(48));
    estado.claras = creaBuferes(baldosas(false));
    estado.oscuras = creaBuferes(baldosas(true));
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_STENCIL_TEST);
    glEnable(GL_CULL_FACE);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    ponFondo(CIELO);
}

// Lo que da sombra. `dibujaPieza(malla, M, color)` lo pinta, o pinta su sombra.
template<class Dibuja>
static void recorreObjetos(Dibuja dibujaPieza) {
    const glm::mat4 dePie = giroX(-glm::half_pi<float>());
    dibujaPieza(estado.toro, traslacion({-0.6f, 1.1f, 0.3f}) * giroY(0.7f), NARANJA);
    dibujaPieza(estado.cilindro, traslacion({-0.6f, 0.1f, 0.3f}) * dePie * escalado({0.35f, 0.35f, 0.2f}),
                OSCURO);
    dibujaPieza(estado.esfera, traslacion({1.4f, 0.5f, 1.1f}) * escalado(0.5f), ROJO);
    dibujaPieza(estado.cubo, traslacion({0.75f, 0.45f, -1.0f}) * giroY(0.5f) * escalado(0.9f), VERDE);
    dibujaPieza(estado.cilindro, traslacion({1.9f, 0.55f, -0.5f}) * dePie * escalado({0.16f, 0.16f, 1.1f}),
                AZUL);
}

static void dibujaSombras(const glm::mat4 &camara, const glm::mat4 &proyeccion) {
    const glm::vec4 L(estado.luz, 1);
    if (alturaLuz(L, MESA) <= 0)
        return; // la luz está en el plano de la mesa o debajo
    const GLuint p = estado.deSombras;
    usaPrograma(p, camara, proyeccion);
    envia(p, "color", estado.transparente ? glm::vec4(0, 0, 0, 0.5f) : glm::vec4(OSCURO, 1));
    if (estado.plantilla) { // solo sobre la mesa (1), y una vez en cada píxel
        glStencilFunc(GL_EQUAL, 1, 0xff);
        glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    }
    if (estado.desplaza) {
        // Medido con llvmpipe en 110 vistas y luces: con (0, −1) aún se cose; con (0, −2) ya no, ni con (−0.25, 0)
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(-0.25f, -2);
    }
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    const glm::mat4 sombra = proyeccionSombra(L, MESA);
    recorreObjetos([&](const Buferes &malla, const glm::mat4 &M, const glm::vec3 &) {
        envia(p, "M", sombra * M);
        dibujaMalla(malla);
    });
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glStencilFunc(GL_ALWAYS, 0, 0xff);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    const glm::mat4 camara = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.45f, 1, 60);
    const GLuint p = estado.deObjetos;
    usaIluminado(p, camara, proyeccion, {glm::vec4(estado.luz, 1)});
    // Lo que se ve del tablero queda a 1 en la plantilla; los objetos que lo tapan lo devuelven a 0
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    glDepthMask(GL_FALSE); // la tabla, debajo de todo: con varias muestras su canto asomaría
    dibujaIluminado(p, estado.cubo,
                    traslacion({0, -TALLA_MESA.y / 2 - 0.01f, 0}) * escalado(TALLA_MESA - VUELO), camara,
                    pintura({0.55f, 0.38f, 0.22f}));
    glDepthMask(GL_TRUE);
    glStencilFunc(GL_ALWAYS, 1, 0xff);
    const glm::mat4 tablero = escalado({TALLA_MESA.x / 8, 1, TALLA_MESA.z / 6});
    dibujaIluminado(p, estado.claras, tablero, camara, pintura({0.88f, 0.80f, 0.66f}));
    dibujaIluminado(p, estado.oscuras, tablero, camara, pintura({0.74f, 0.58f, 0.42f}));
    glStencilFunc(GL_ALWAYS, 0, 0xff);
    recorreObjetos([&](const Buferes &malla, const glm::mat4 &M, const glm::vec3 &color) {
        dibujaIluminado(p, malla, M, camara, pintura(color));
    });

    const Material lampara = {glm::vec3(1, 0.95f, 0.6f), glm::vec3(0), glm::vec3(0), 1};
    dibujaIluminado(p, estado.esfera, traslacion(estado.luz) * escalado(RADIO_LUZ), camara, lampara);
    dibujaSombras(camara, proyeccion);
    rotulaPunto("luz", estado.luz + glm::vec3(0, RADIO_LUZ, 0), proyeccion * camara, OSCURO, Lado::ENCIMA);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    switch (tecla) {
    case 't': estado.transparente = !estado.transparente; break;
    case 'o': estado.desplaza = !estado.desplaza; break;
    case 'p': estado.plantilla = !estado.plantilla; break;
    case 'w':
    case 's': estado.luz.z = std::clamp(estado.luz.z + (tecla == 'w' ? -PASO : PASO), -FONDO, FONDO); break;
    default: return;
    }
    ponTitulo(std::string("Sombra ") + (estado.transparente ? "transparente" : "opaca") +
              (estado.desplaza ? "" : ", sin desplazamiento") + (estado.plantilla ? "" : ", sin plantilla"));
    glutPostRedisplay();
}

static void raton(int boton, int sentido, int x, int y) {
    if (boton == GLUT_RIGHT_BUTTON)
        estado.moviendo = sentido == GLUT_DOWN;
    estado.x = x;
    estado.y = y;
    orbitaBoton(boton, sentido, x, y);
}

static void arrastra(int x, int y) {
    if (estado.moviendo) {
        const float porPixel = UNIDADES_POR_ALTO / altoUtil();
        estado.luz.x = std::clamp(estado.luz.x + porPixel * float(x - estado.x), -3.0f, 3.0f);
        estado.luz.y = std::clamp(estado.luz.y - porPixel * float(y - estado.y), -0.5f, 3.4f);
        estado.x = x;
        estado.y = y;
        glutPostRedisplay();
    }
    orbitaArrastra(x, y);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Sombra transparente",
                GLUT_DOUBLE | GLUT_DEPTH | GLUT_STENCIL | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMouseFunc(raton);
    glutMotionFunc(arrastra);
    glutMainLoop();
    return 0;
}
