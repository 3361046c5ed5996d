// Una malla v/f como tiras de triángulos (ejercicio 2.2), cada una de un color que se oscurece en el orden en que se
// envían sus vértices; la línea los une y el punto es el primero. Informa de cuántos índices ahorran frente a los
// triángulos sueltos. Sin dar fichero, la malla del ejercicio 2.1, con las caras 5 y 6 ya invertidas: una tira gira
// toda en un sentido.
// Controles: 1 a 9 resaltan una tira · 0 todas · u la caja en una sola, de dos maneras · ratón orbita · Esc termina.
#include "tiras.h"
#include "buferes.h"
#include "colores.h"
#include "encuadre_malla.h"
#include "error.h"
#include "malla.h"
#include "modos.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "rutas.h"
#include "shader.h"
#include "topologia.h"
#include "trazo.h"
#include "ventana.h"
#include <algorithm>
#include <cstdio>
#include <string>

static const glm::vec3 PALETA[] = {NARANJA, AZUL, VERDE, ROJO, MORADO, AMARILLO, GRIS};
static const float ANGULO = 0.6f; // de la perspectiva, en radianes
static const std::size_t MAXIMO_ESCRITO = 3,
                         POR_RENGLON = 7; // tiras cuyos índices caben en la ventana, y cómo
static const float ALTO_RENGLON = 0.065f; // en partes del de la ventana

static struct {
    GLuint programa;
    bool esLaCaja;
    int unica = 0; // de TIRAS_UNICAS, la que se dibuja, desde 1; 0 si son las de hazTiras
    std::vector<glm::vec3> vertices;
    std::vector<Triangulo> triangulos; // los de la malla
    std::vector<Tira> tiras;
    int elegido = TODOS;
    Orbita orbita = {0.66f, 0.80f, 1}; // la distancia la pone el encuadre
} estado;

static glm::vec3 colorTira(std::size_t i) {
    return PALETA[i % (sizeof PALETA / sizeof PALETA[0])];
}

// El color aclarado (0), tal cual (½) y oscurecido (1).
static glm::vec3 deClaroAOscuro(const glm::vec3 &color, float t) {
    return t < 0.5f ? glm::mix(glm::mix(BLANCO, color, 0.25f), color, 2 * t)
                    : glm::mix(color, 0.35f * color, 2 * t - 1);
}

static std::string indicesEscritos(const Tira &tira, std::size_t porRenglon = std::string::npos) {
    std::string texto;
    for (std::size_t k = 0; k < tira.size(); ++k) {
        if (k > 0)
            texto += k % porRenglon ? " " : "\n";
        texto += std::to_string(tira[k] + 1);
    }
    return texto;
}

static void informa() {
    std::size_t nIndices = 0;
    for (std::size_t i = 0; i < estado.tiras.size(); ++i) {
        nIndices += estado.tiras[i].size();
        std::printf("Tira %zu: %s\n", i + 1, indicesEscritos(estado.tiras[i]).c_str());
    }
    std::printf("Triángulos: %zu\nTiras: %zu\nÍndices con tiras: %zu\nÍndices con triángulos sueltos: %zu\n",
                estado.triangulos.size(), estado.tiras.size(), nIndices, 3 * estado.triangulos.size());
    std::fflush(stdout);
    ponTitulo("Tiras: " + std::to_string(estado.tiras.size()) + ", con " + std::to_string(nIndices) +
              " índices");
}

// Los vértices de todas las tiras, una tras otra: repetidos, con el color que cada uno tiene en su tira, y sin índices.
static void construye() {
    estado.tiras =
        estado.unica ? std::vector<Tira>{TIRAS_UNICAS[estado.unica - 1]} : hazTiras(estado.triangulos);
    estado.elegido = TODOS;
    std::vector<VerticeColor> enOrden;
    for (std::size_t i = 0; i < estado.tiras.size(); ++i) {
        const Tira &tira = estado.tiras[i];
        const float ultimo = std::max(float(tira.size()) - 3, 1.0f);
        for (std::size_t k = 0; k < tira.size(); ++k) {
            const float t = (float(k) - 2) / ultimo; // da su color al triángulo k − 2
            enOrden.push_back({estado.vertices[tira[k]], deClaroAOscuro(colorTira(i), t)});
        }
    }
    glBufferData(GL_ARRAY_BUFFER, enOrden.size() * sizeof(VerticeColor), enOrden.data(), GL_STATIC_DRAW);
    informa();
}

static void inicia(const std::string &fichero) {
    estado.programa = creaPrograma("ch02_modelado/sin_interpolar.vert", "ch02_modelado/sin_interpolar.frag");
    const MallaVf malla = leeVf(fichero);
    estado.triangulos = triangula(concuerda(malla, analizaTopologia(malla)));
    estado.vertices = encuadra(malla.vertices);
    estado.orbita.distancia = distanciaQueEncuadra(estado.vertices, estado.orbita, ANGULO);
    creaVerticesColor({});
    construye();

    glEnable(GL_DEPTH_TEST);
    ponFondo(FONDO_CLARO);
}

// Al resaltar una tira, de las demás quedan las líneas, que no la tapan.
static bool seDibuja(std::size_t i) {
    return estado.elegido == TODOS || estado.elegido == int(i);
}

static void dibujaTiras() {
    // E2.2: las tiras que se ven (seDibuja); sus vértices están en el buffer, los de una tras los de otra
    GLint primero = 0;
    for (std::size_t i = 0; i < estado.tiras.size(); ++i) {
        const auto n = GLsizei(estado.tiras[i].size());
        if (seDibuja(i))
            glDrawArrays(GL_TRIANGLE_STRIP, primero, n);
        primero += n;
    }
    // fin de E2.2
}

static void dibujaRecorridos(const glm::mat4 &transformacion) {
    std::vector<glm::vec3> encendidos, apagados, principios;
    for (std::size_t i = 0; i < estado.tiras.size(); ++i) {
        const Tira &tira = estado.tiras[i];
        std::vector<glm::vec3> &recorrido = seDibuja(i) ? encendidos : apagados;
        for (std::size_t k = 1; k < tira.size(); ++k)
            recorrido.insert(recorrido.end(), {estado.vertices[tira[k - 1]], estado.vertices[tira[k]]});
        if (seDibuja(i))
            principios.push_back(estado.vertices[tira[0]]);
    }
    trazaSegmentos(apagados, transformacion, GRIS, GROSOR / 2);
    trazaSegmentos(encendidos, transformacion, OSCURO);
    if (estado.unica == 1) // el recorrido no pasa por ella
        trazaSegmentos({estado.vertices[DIAGONAL_NUEVA[0]], estado.vertices[DIAGONAL_NUEVA[1]]},
                       transformacion, MORADO, 1.5f * GROSOR);
    trazaPuntos(principios, transformacion, OSCURO, 4 * GROSOR);
}

// Abajo a la izquierda, una tira encima de otra.
static void escribeIndices() {
    float y = 0.03f;
    for (std::size_t i = estado.tiras.size(); i-- > 0;) {
        const float alto = ALTO_RENGLON * float((estado.tiras[i].size() + POR_RENGLON - 1) / POR_RENGLON);
        rotula(indicesEscritos(estado.tiras[i], POR_RENGLON), {0.02f, y + alto / 2}, 0.77f * colorTira(i),
               Lado::DERECHA);
        y += alto;
    }
}

static void dibuja() {
    const glm::mat4 camara = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(ANGULO, 0.1f, 100);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    usaPrograma(estado.programa, camara, proyeccion);
    dibujaTiras();
    alejaEnProfundidad(dibujaTiras);
    dibujaRecorridos(proyeccion * camara);
    rotulaVertices(estado.vertices, estado.triangulos, posicionCamara(estado.orbita), proyeccion * camara);
    if (estado.tiras.size() <= MAXIMO_ESCRITO && estado.triangulos.size() <= MAXIMO_NUMERADO)
        escribeIndices();
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || eligeModoOTodos(estado.elegido, std::min(int(estado.tiras.size()), 9), tecla))
        return;
    if (tecla == 'u' && estado.esLaCaja) {
        estado.unica = (estado.unica + 1) % 3;
        construye();
        glutPostRedisplay();
    }
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Tiras de triángulos", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE, "[FICHERO]");
    if (argc > 2)
        falla("solo se puede dar un fichero; sobra «" + std::string(argv[2]) + "»", 2);
    estado.esLaCaja = argc == 1;
    inicia(estado.esLaCaja ? recurso("assets/ejercicio_2_1.vf") : argv[1]);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
