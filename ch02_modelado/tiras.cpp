// Una malla v/f como tiras de triángulos (ejercicio 2.2), cada una de un color; la línea oscura une sus
// vértices en el orden en que se envían. Informa de cuántos índices ahorran frente a los triángulos sueltos.
// Sin dar fichero, la malla del ejercicio 2.1, con las caras 5 y 6 ya invertidas: una tira gira toda en un
// sentido.
// Controles: 1 a 9 resaltan una tira · 0 todas · ratón orbita · Esc termina.
#include "tiras.h"
#include "encuadre.h"
#include "error.h"
#include "malla.h"
#include "orbita.h"
#include "rutas.h"
#include "shader.h"
#include "topologia.h"
#include "ventana.h"
#include <algorithm>
#include <cstdio>
#include <string>

static const glm::vec3 PALETA[] = {{0.95f, 0.55f, 0.10f}, {0.20f, 0.42f, 0.84f}, {0.20f, 0.62f, 0.28f},
                                   {0.85f, 0.20f, 0.18f}, {0.98f, 0.78f, 0.15f}, {0.55f, 0.25f, 0.70f},
                                   {0.10f, 0.65f, 0.70f}, {0.90f, 0.45f, 0.65f}};
static const glm::vec3 oscuro(0.16f, 0.17f, 0.20f), apagado(0.70f, 0.73f, 0.78f);
static const float ANGULO = 0.6f; // de la perspectiva, en radianes

static struct {
    GLuint programaCaras, programaLineas;
    std::vector<Tira> tiras;
    std::size_t resaltada = 0;         // desde 1; 0: todas
    Orbita orbita = {0.45f, 0.98f, 1}; // la distancia la pone el encuadre
} estado;

static void informa(std::size_t nTriangulos) {
    std::size_t nIndices = 0;
    for (std::size_t i = 0; i < estado.tiras.size(); ++i) {
        nIndices += estado.tiras[i].size();
        std::printf("Tira %zu:", i + 1);
        for (GLuint v : estado.tiras[i])
            std::printf(" %u", v + 1);
        std::printf("\n");
    }
    std::printf("Triángulos: %zu\nTiras: %zu\nÍndices con tiras: %zu\nÍndices con triángulos sueltos: %zu\n",
                nTriangulos, estado.tiras.size(), nIndices, 3 * nTriangulos);
    std::fflush(stdout);
}

static void inicia(const std::string &fichero) {
    estado.programaCaras = creaPrograma("ch02_modelado/caras.vert", "ch02_modelado/caras.frag");
    estado.programaLineas = creaPrograma("ch02_modelado/caras.vert", "ch02_modelado/lineas.frag");
    const MallaVf malla = leeVf(fichero);
    const std::vector<Triangulo> triangulos = triangula(concuerda(malla, analizaTopologia(malla)));
    estado.tiras = hazTiras(triangulos);
    informa(triangulos.size());

    const std::vector<glm::vec3> vertices = encuadra(malla.vertices);
    estado.orbita.distancia = distanciaQueEncuadra(vertices, estado.orbita, ANGULO, relacionAspecto());
    std::vector<GLuint> indices; // todas las tiras, una tras otra
    for (const Tira &tira : estado.tiras)
        indices.insert(indices.end(), tira.begin(), tira.end());

    GLuint vao, buffers[2];
    glGenVertexArrays(1, &vao);
    glBindVertexArray(vao);
    glGenBuffers(2, buffers);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(glm::vec3)),
                 vertices.data(), GL_STATIC_DRAW);
    glVertexAttribPointer(ATRIBUTO_POSICION, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(ATRIBUTO_POSICION);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(GLuint)),
                 indices.data(), GL_STATIC_DRAW);

    glEnable(GL_DEPTH_TEST);
    glEnable(GL_POLYGON_OFFSET_FILL); // las caras un poco más lejos: no tapan las líneas
    glPolygonOffset(1, 1);
    glClearColor(0.95f, 0.96f, 0.98f, 1);
}

// Los mismos índices sirven de tira de triángulos y, como línea, enseñan su recorrido. Al resaltar una tira,
// de las demás queda la línea, que no la tapa.
static void dibujaTira(std::size_t i, std::size_t primero) {
    const auto n = static_cast<GLsizei>(estado.tiras[i].size());
    const void *desde = reinterpret_cast<const void *>(primero * sizeof(GLuint));
    const bool encendida = estado.resaltada == 0 || estado.resaltada == i + 1;
    if (encendida) {
        const glm::vec3 color = PALETA[i % (sizeof PALETA / sizeof PALETA[0])], reverso = 0.8f * color;
        glUseProgram(estado.programaCaras);
        envia(estado.programaCaras, "colorAnverso", color);
        envia(estado.programaCaras, "colorReverso", reverso);
        glDrawElements(GL_TRIANGLE_STRIP, n, GL_UNSIGNED_INT, desde);
    }
    glUseProgram(estado.programaLineas);
    envia(estado.programaLineas, "color", encendida ? oscuro : apagado);
    glDrawElements(GL_LINE_STRIP, n, GL_UNSIGNED_INT, desde);
}

static void dibuja() {
    const glm::mat4 camara = perspectivaVentana(ANGULO, 0.1f, 100) * camaraOrbita(estado.orbita);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (GLuint programa : {estado.programaCaras, estado.programaLineas}) {
        glUseProgram(programa);
        envia(programa, "camara", camara);
    }
    glLineWidth(std::max(2.0f, static_cast<float>(glutGet(GLUT_WINDOW_HEIGHT)) / 120));
    std::size_t primero = 0;
    for (std::size_t i = 0; i < estado.tiras.size(); ++i) {
        dibujaTira(i, primero);
        primero += estado.tiras[i].size();
    }
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla < '0' || tecla > '9')
        return;
    const std::size_t n = tecla - static_cast<std::size_t>('0');
    if (n <= estado.tiras.size())
        estado.resaltada = n;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Tiras de triángulos", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE, "[FICHERO]");
    if (argc > 2)
        falla("solo se puede dar un fichero; sobra «" + std::string(argv[2]) + "»", 2);
    inicia(argc > 1 ? argv[1] : recurso("assets/ejercicio_2_1.vf"));
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
