// Los tres modelos de sombreado (§5.3, listados 5.2 y 5.3, figura 5.6) sobre la misma malla y con el mismo
// modelo de iluminación (listado 5.1): plano, una vez por polígono; Gouraud, una vez por vértice; Phong, una
// vez por fragmento. Con pocos polígonos se ve qué hace cada uno; con muchos, se parecen.
// Controles: 1 plano · 2 Gouraud · 3 Phong · + - más o menos subdivisión · ratón orbita · Esc termina.
#include "ch03_transformaciones/transformaciones.h"
#include "iluminacion.h"
#include "malla.h"
#include "orbita.h"
#include "ventana.h"
#include <algorithm>

enum Sombreado { PLANO, GOURAUD, PHONG };

static const int SUBDIVISION_MINIMA = 6, SUBDIVISION_MAXIMA = 192;
static const glm::vec3 La(1);
static const Luz luz{{-3, 4, 6, 1}};
static const Material turquesa = {{0.05f, 0.14f, 0.14f}, {0.12f, 0.50f, 0.50f}, {0.75f, 0.75f, 0.75f}, 16};
static const Material coral = {{0.20f, 0.08f, 0.05f}, {0.62f, 0.26f, 0.17f}, {0.70f, 0.70f, 0.70f}, 16};

static struct {
    GLuint programas[3];
    Buferes esfera, toro;
    Orbita orbita = {0, 0, 12, {0, 0, 0}};
    int subdivision = 12;
    Sombreado sombreado = PLANO;
} estado;

/// La misma malla con la normal de cada triángulo en sus tres vértices. Empieza en el segundo para que el
/// último, el que da el color en el sombreado plano, sea el que comparten los dos triángulos de cada
/// cuadrilátero.
static Malla facetas(const Malla &malla) {
    Malla plana;
    for (std::size_t i = 0; i < malla.indices.size(); i += 3) {
        const Vertice &p = malla.vertices[malla.indices[i]], &q = malla.vertices[malla.indices[i + 1]],
                      &r = malla.vertices[malla.indices[i + 2]];
        const glm::vec3 normal = glm::normalize(glm::cross(q.posicion - p.posicion, r.posicion - p.posicion));
        for (const Vertice &v : {q, r, p}) {
            plana.indices.push_back(static_cast<GLuint>(plana.vertices.size()));
            plana.vertices.push_back({v.posicion, normal, v.coordTextura});
        }
    }
    return plana;
}

static void cambiaBuferes(Buferes &buferes, const Malla &malla) {
    glDeleteVertexArrays(1, &buferes.vao);
    glDeleteBuffers(1, &buferes.vertices);
    glDeleteBuffers(1, &buferes.indices);
    buferes = creaBuferes(estado.sombreado == PLANO ? facetas(malla) : malla);
}

static void construye() {
    const int n = estado.subdivision;
    cambiaBuferes(estado.esfera, esfera(n));
    cambiaBuferes(estado.toro, toro(0.68f, 0.30f, n, std::max(n / 2, 3)));
}

static void inicia() {
    int i = 0;
    for (const std::string nombre : {"plano", "gouraud", "phong"})
        estado.programas[i++] = creaPrograma("ch05_iluminacion/sombreado_" + nombre + ".vert",
                                             "ch05_iluminacion/sombreado_" + nombre + ".frag");
    construye();
    glEnable(GL_DEPTH_TEST);
    glClearColor(0.16f, 0.17f, 0.20f, 1);
}

static void dibujaObjeto(const Buferes &objeto, const glm::mat4 &M, const Material &material) {
    const GLuint programa = estado.programas[estado.sombreado];
    const glm::mat3 N = matrizNormal(camaraOrbita(estado.orbita) * M);
    envia(programa, "M", M);
    envia(programa, "N", N);
    enviaMaterial(programa, material);
    dibuja(objeto);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const GLuint programa = estado.programas[estado.sombreado];
    glUseProgram(programa);
    const glm::mat4 vista = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.26f, 1, 100);
    envia(programa, "vista", vista);
    envia(programa, "proyeccion", proyeccion);
    envia(programa, "La", La);
    enviaLuz(programa, "luz", luz, vista);
    dibujaObjeto(estado.esfera, traslacion({-0.95f, 0.25f, 0}) * giroX(-1.2f), turquesa);
    dibujaObjeto(estado.toro, traslacion({0.98f, -0.35f, 0.5f}) * giroX(-0.7f), coral);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    switch (tecla) {
    case '1': estado.sombreado = PLANO; break;
    case '2': estado.sombreado = GOURAUD; break;
    case '3': estado.sombreado = PHONG; break;
    case '+': estado.subdivision = std::min(2 * estado.subdivision, SUBDIVISION_MAXIMA); break;
    case '-': estado.subdivision = std::max(estado.subdivision / 2, SUBDIVISION_MINIMA); break;
    default: return;
    }
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
