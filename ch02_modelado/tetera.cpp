// La tetera de Utah (figuras 2.1 y 2.2): 32 parches de Bézier triangulados con la normal exacta en cada
// vértice. El error de cuerda no pasa de la tolerancia que se pide (bezier.h). Los cuadriláteros de la figura
// 2.1 se dibujan como líneas, porque OpenGL 3.1 no tiene esa primitiva.
// Controles: m malla de triángulos · c malla de cuadriláteros · + - tolerancia · ratón orbita · Esc termina.
#include "bezier.h"
#include "malla.h"
#include "orbita.h"
#include "shader.h"
#include "ventana.h"
#include <algorithm>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>

static const float ANGULO = 0.55f; // de la perspectiva, en radianes
// Con esta tolerancia el mayor error de cuerda, proyectado, es menos de medio píxel en 960×720 (la prueba
// ch02_bezier lo mide): en esta superficie el error es como mucho la mitad de lo que garantiza la cota.
static const double TOLERANCIA = 0.0075, TOLERANCIA_MINIMA = 5e-4, TOLERANCIA_MAXIMA = 1;
static const glm::vec3 cobalto(0.13f, 0.33f, 0.74f), porcelana(0.93f, 0.90f, 0.84f),
    tinta(0.14f, 0.20f, 0.38f);

enum Lineas { NINGUNA, TRIANGULOS, CUADRILATEROS };

static struct {
    GLuint programa, programaLineas;
    std::vector<Parche> parches;
    double tolerancia = TOLERANCIA;
    Lineas lineas = NINGUNA;
    Buferes tetera = {}; // índices: los triángulos, los lados de los cuadriláteros y las diagonales
    GLsizei nTriangulos, nLados, nDiagonales;
    Orbita orbita = {0.22f, 0.38f, 9.9f, {0.26f, 1.50f, 0}};
} estado;

static void construye() {
    Teselacion t = teselaParches(estado.parches, estado.tolerancia);
    std::vector<GLuint> &indices = t.malla.indices;
    estado.nTriangulos = static_cast<GLsizei>(indices.size());
    estado.nLados = static_cast<GLsizei>(t.lados.size());
    estado.nDiagonales = static_cast<GLsizei>(t.diagonales.size());
    indices.insert(indices.end(), t.lados.begin(), t.lados.end());
    indices.insert(indices.end(), t.diagonales.begin(), t.diagonales.end());

    glDeleteVertexArrays(1, &estado.tetera.vao); // la primera vez son 0, que se ignora
    glDeleteBuffers(1, &estado.tetera.vertices);
    glDeleteBuffers(1, &estado.tetera.indices);
    estado.tetera = creaBuferes(t.malla);

    char titulo[100];
    std::snprintf(titulo, sizeof titulo, "Tetera: tolerancia %.2g, %d triángulos", estado.tolerancia,
                  estado.nTriangulos / 3);
    glutSetWindowTitle(titulo);
}

static void inicia() {
    estado.programa = creaPrograma("ch02_modelado/tetera.vert", "ch02_modelado/tetera.frag");
    estado.programaLineas = creaPrograma("ch02_modelado/caras.vert", "ch02_modelado/lineas.frag");
    estado.parches = leeParches("assets/tetera.txt");
    construye();
    glEnable(GL_DEPTH_TEST);
    glPolygonOffset(1, 1);
    glClearColor(0.95f, 0.96f, 0.98f, 1);
}

static void dibuja() {
    // En los datos la vertical es Z, y en la cámara Y.
    const glm::mat4 M = glm::rotate(glm::mat4(1), glm::radians(-90.0f), glm::vec3(1, 0, 0));
    const glm::mat4 camara = perspectivaVentana(ANGULO, 0.5f, 50) * camaraOrbita(estado.orbita);
    const glm::vec3 ojo = posicionCamara(estado.orbita);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

    if (estado.lineas == NINGUNA)
        glDisable(GL_POLYGON_OFFSET_FILL);
    else
        glEnable(GL_POLYGON_OFFSET_FILL); // las caras un poco más lejos: no tapan las líneas
    const glm::vec3 &color = estado.lineas == NINGUNA ? cobalto : porcelana;
    glUseProgram(estado.programa);
    envia(estado.programa, "M", M);
    envia(estado.programa, "camara", camara);
    envia(estado.programa, "ojo", ojo);
    envia(estado.programa, "colorObjeto", color);
    glDrawElements(GL_TRIANGLES, estado.nTriangulos, GL_UNSIGNED_INT, nullptr);

    if (estado.lineas != NINGUNA) {
        const glm::mat4 camaraModelo = camara * M;
        glLineWidth(std::max(1.0f, static_cast<float>(glutGet(GLUT_WINDOW_HEIGHT)) / 360));
        glUseProgram(estado.programaLineas);
        envia(estado.programaLineas, "camara", camaraModelo);
        envia(estado.programaLineas, "color", tinta);
        const GLsizei n = estado.nLados + (estado.lineas == TRIANGULOS ? estado.nDiagonales : 0);
        glDrawElements(
            GL_LINES, n, GL_UNSIGNED_INT,
            reinterpret_cast<const void *>(static_cast<std::size_t>(estado.nTriangulos) * sizeof(GLuint)));
    }
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    switch (tecla) {
    case 'm': estado.lineas = estado.lineas == TRIANGULOS ? NINGUNA : TRIANGULOS; break;
    case 'c': estado.lineas = estado.lineas == CUADRILATEROS ? NINGUNA : CUADRILATEROS; break;
    case '+':
    case '-':
        estado.tolerancia =
            std::clamp(estado.tolerancia * (tecla == '+' ? 2 : 0.5), TOLERANCIA_MINIMA, TOLERANCIA_MAXIMA);
        construye();
        break;
    default: return;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Tetera", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
