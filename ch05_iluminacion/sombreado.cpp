// Los tres modelos de sombreado (§5.3, listados 5.2 y 5.3, figura 5.6) sobre la misma malla y con el mismo modelo de
// iluminación (listado 5.1): plano, una vez por polígono; Gouraud, una vez por vértice; Phong, una vez por fragmento.
// Con pocos polígonos se ve qué hace cada uno; con muchos, se parecen. Se aparta de los listados en que phong recibe el
// material, la luz y el punto, y calcula ella L y V (phong.glsl, que en vez de normalize usa unitario, que admite el
// vector nulo), y en que los colores son vec3: el sombreado no toca la opacidad.
// Controles: 1 plano · 2 Gouraud · 3 Phong · v los tres a la vez · + - más o menos subdivisión ·
// ratón orbita · Esc termina.
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
#include "ventana.h"
#include <algorithm>

enum Sombreado { PLANO, GOURAUD, PHONG, MODELOS };

static const char *const NOMBRES[MODELOS] = {"Plano", "Gouraud", "Phong"};
static const int SUBDIVISION_MINIMA = 6, SUBDIVISION_MAXIMA = 192;
static const Luz LUZ{{-3, 4, 6, 1}};
static const Material TURQUESA = {{0.05f, 0.14f, 0.14f}, {0.12f, 0.50f, 0.50f}, {0.75f, 0.75f, 0.75f}, 16};
static const Material CORAL = {{0.20f, 0.08f, 0.05f}, {0.62f, 0.26f, 0.17f}, {0.70f, 0.70f, 0.70f}, 16};

static struct {
    GLuint programas[MODELOS];
    Buferes esfera, toro, esferaPlana, toroPlano; // las planas, con la normal de cada triángulo
    Orbita orbita = {0, 0, 12, {0, 0, 0}};
    int subdivision = 12;
    Modos modos{MODELOS};
} estado;

// La misma malla con la normal de cada triángulo en sus tres vértices. Empieza en el segundo para que el último, el
// que da el color en el sombreado plano, sea el que comparten los dos triángulos de cada cuadrilátero.
static Malla facetas(const Malla &malla) {
    Malla plana;
    for (std::size_t i = 0; i < malla.indices.size(); i += 3) {
        const Vertice &p = malla.vertices[malla.indices[i]], &q = malla.vertices[malla.indices[i + 1]],
                      &r = malla.vertices[malla.indices[i + 2]];
        const glm::vec3 normal = glm::normalize(glm::cross(q.posicion - p.posicion, r.posicion - p.posicion));
        for (const Vertice &v : {q, r, p}) {
            plana.indices.push_back(unsigned(plana.vertices.size()));
            plana.vertices.push_back({v.posicion, normal, v.coordTextura});
        }
    }
    return plana;
}

static void cambiaBuferes(Buferes &buferes, const Malla &malla) {
    borraBuferes(buferes);
    buferes = creaBuferes(malla);
}

static void construye() {
    const int n = estado.subdivision;
    const Malla laEsfera = esfera(n), elToro = toro(0.68f, 0.30f, n, std::max(n / 2, 3));
    cambiaBuferes(estado.esfera, laEsfera);
    cambiaBuferes(estado.esferaPlana, facetas(laEsfera));
    cambiaBuferes(estado.toro, elToro);
    cambiaBuferes(estado.toroPlano, facetas(elToro));
}

static void inicia() {
    int i = 0;
    for (const char *modelo : {"plano", "gouraud", "phong"})
        estado.programas[i++] = creaSombreado(modelo);
    construye();
    glEnable(GL_DEPTH_TEST);
}

// En un panel ancho, la esfera al lado del toro; en uno alto, encima.
static void dibujaPanel(const Recuadro &panel, int modelo) {
    const bool alto = aspecto(panel) < 0.65f, plano = modelo == PLANO;
    const GLuint programa = estado.programas[modelo];
    const glm::mat4 camara = camaraOrbita(estado.orbita),
                    proyeccion = alto ? perspectivaVentana(0.42f, 1, 100, aspecto(panel), 4.0 / 9)
                                      : perspectivaVentana(0.27f, 1, 100, aspecto(panel));
    abreRecuadro(panel);
    ponFondo(FONDO_OSCURO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    usaIluminado(programa, camara, proyeccion, LUZ);
    dibujaIluminado(programa, plano ? estado.esferaPlana : estado.esfera,
                    traslacion(alto ? glm::vec3(0, 0.8f, 0) : glm::vec3(-0.95f, 0.25f, 0)) * giroX(-1.2f),
                    camara, TURQUESA);
    dibujaIluminado(programa, plano ? estado.toroPlano : estado.toro,
                    traslacion(alto ? glm::vec3(0, -0.95f, 0.5f) : glm::vec3(0.98f, -0.35f, 0.5f)) *
                        giroX(-0.7f),
                    camara, CORAL);
    rotula(NOMBRES[modelo], {0.5f, 0}, BLANCO, Lado::ENCIMA);
}

static void dibuja() {
    abreRecuadro(ventanaEntera());
    ponFondo(GRIS);
    glClear(GL_COLOR_BUFFER_BIT);
    if (estado.modos.todos) {
        const std::vector<Recuadro> paneles =
            relacionAspecto() > 0.7f ? rejilla(MODELOS, 1) : rejilla(1, MODELOS);
        for (int modelo = 0; modelo < MODELOS; ++modelo)
            dibujaPanel(paneles[modelo], modelo);
    } else
        dibujaPanel(ventanaEntera(), estado.modos.elegido);
    ponTitulo("Modelos de sombreado: " +
              std::string(estado.modos.todos ? "los tres" : NOMBRES[estado.modos.elegido]) + ", " +
              std::to_string(estado.subdivision) + " segmentos");
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || teclaModos(estado.modos, tecla))
        return;
    if (tecla == '+')
        estado.subdivision = std::min(2 * estado.subdivision, SUBDIVISION_MAXIMA);
    else if (tecla == '-')
        estado.subdivision = std::max(estado.subdivision / 2, SUBDIVISION_MINIMA);
    else
        return;
    construye();
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Modelos de sombreado", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
