// Lee una malla v/f, la dibuja con el anverso azul y el reverso amarillo e informa de su topología (ejercicio
// 2.1; el análisis está en topologia.h). Las aristas de borde van en rojo: la malla del ejercicio, que es la
// que se ve sin dar fichero, es una caja sin tapa en la que las caras 5 y 6 están definidas al revés.
// Controles: f invierte las caras mal orientadas · ratón orbita · Esc termina.
#include "colores.h"
#include "encuadre_malla.h"
#include "error.h"
#include "malla.h"
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

static const float ANGULO = 0.6f; // de la perspectiva, en radianes

static struct {
    GLuint programa;
    MallaVf malla;
    bool arreglada = false;
    std::vector<glm::vec3> vertices;
    std::vector<IndicesTriangulo> triangulos;
    std::vector<glm::vec3> aristas[3]; // los extremos de las de una cara, de dos y de más
    Orbita orbita = {0.55f, 0.62f, 1}; // la distancia la pone el encuadre
} estado;

static std::string sentidoVistoDesdeFuera(const Topologia &t) {
    static const char *const nombres[] = {"antihorario", "horario", "indefinido"};
    std::string texto;
    for (Sentido s : {Sentido::ANTIHORARIO, Sentido::HORARIO, Sentido::INDEFINIDO}) {
        const std::size_t n = std::count(t.sentidos.begin(), t.sentidos.end(), s);
        const std::string nombre = nombres[int(s)];
        if (n == t.sentidos.size())
            return nombre;
        if (n > 0)
            texto += (texto.empty() ? "" : ", ") + nombre + " en " + std::to_string(n) +
                     (n == 1 ? " componente" : " componentes");
    }
    return texto;
}

static void informa(const MallaVf &malla, const Topologia &t) {
    std::string contrarias;
    for (std::size_t c : t.contrarias)
        contrarias += (contrarias.empty() ? "" : ", ") + std::to_string(c + 1);
    std::printf("Vértices: %zu\nCaras: %zu\nComponentes: %zu\nAristas de borde: %zu\n"
                "Aristas de más de dos caras: %zu\nOrientable: %s\nCaras con orientación contraria: %s\n"
                "Sentido visto desde fuera: %s\n",
                malla.vertices.size(), malla.caras.size(), t.sentidos.size(), t.deBorde, t.ramificadas,
                std::count(t.orientables.begin(), t.orientables.end(), false) ? "no" : "sí",
                contrarias.empty() ? "ninguna" : contrarias.c_str(), sentidoVistoDesdeFuera(t).c_str());
    std::fflush(stdout);
}

static void construye() {
    MallaVf malla = estado.malla;
    Topologia t = analizaTopologia(malla);
    if (estado.arreglada) {
        malla = concuerda(malla, t);
        t = analizaTopologia(malla);
    }
    informa(malla, t);

    estado.triangulos = triangula(malla);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, estado.triangulos.size() * sizeof(IndicesTriangulo),
                 estado.triangulos.data(), GL_STATIC_DRAW);
    for (std::vector<glm::vec3> &extremos : estado.aristas)
        extremos.clear();
    for (const Arista &a : t.aristas) {
        std::vector<glm::vec3> &extremos = estado.aristas[std::min(a.caras, 3) - 1];
        extremos.insert(extremos.end(), {estado.vertices[a.a], estado.vertices[a.b]});
    }
    ponTitulo("Malla v/f: " + std::to_string(malla.vertices.size()) + " vértices, " +
              std::to_string(malla.caras.size()) + " caras, " + std::to_string(t.contrarias.size()) +
              " al revés");
}

static void inicia(const std::string &fichero) {
    estado.programa = creaPrograma("ch02_modelado/caras.vert", "ch02_modelado/caras.frag");
    estado.malla = leeVf(fichero);
    estado.vertices = encuadra(estado.malla.vertices);
    estado.orbita.distancia = distanciaQueEncuadra(estado.vertices, estado.orbita, ANGULO);

    GLuint vao, buffers[2];
    glGenVertexArrays(1, &vao);
    glBindVertexArray(vao);
    glGenBuffers(2, buffers);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, estado.vertices.size() * sizeof(glm::vec3), estado.vertices.data(),
                 GL_STATIC_DRAW);
    glVertexAttribPointer(ATRIBUTO_POSICION, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(ATRIBUTO_POSICION);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    construye();

    glEnable(GL_DEPTH_TEST);
    ponFondo(FONDO_CLARO);
}

// En el centro de cada cara que se ve, su número, desde el 1 como en el fichero.
static void rotulaCaras(const glm::vec3 &ojo, const glm::mat4 &transformacion) {
    if (estado.triangulos.size() > MAXIMO_NUMERADO)
        return;
    for (std::size_t c = 0; c < estado.malla.caras.size(); ++c) {
        glm::vec3 centro(0);
        for (GLuint i : estado.malla.caras[c])
            centro += estado.vertices[i] / float(estado.malla.caras[c].size());
        if (seVe(centro, ojo, estado.vertices, estado.triangulos))
            rotulaPunto("c" + std::to_string(c + 1), centro, transformacion, BLANCO, Lado::CENTRO);
    }
}

static void dibujaCaras() {
    glDrawElements(GL_TRIANGLES, GLsizei(3 * estado.triangulos.size()), GL_UNSIGNED_INT, nullptr);
}

static void dibuja() {
    const glm::mat4 camara = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(ANGULO, 0.1f, 100);
    const glm::mat4 transformacion = proyeccion * camara;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

    usaPrograma(estado.programa, camara, proyeccion);
    envia(estado.programa, "colorAnverso", AZUL);
    envia(estado.programa, "colorReverso", AMARILLO);
    dibujaCaras();
    alejaEnProfundidad(dibujaCaras);

    trazaSegmentos(estado.aristas[1], transformacion, OSCURO, GROSOR / 2);
    trazaSegmentos(estado.aristas[0], transformacion, ROJO, 2 * GROSOR);
    trazaSegmentos(estado.aristas[2], transformacion, MORADO, 2 * GROSOR);
    const glm::vec3 ojo = posicionCamara(estado.orbita);
    rotulaVertices(estado.vertices, estado.triangulos, ojo, transformacion);
    rotulaCaras(ojo, transformacion);
    rotula("anverso", {0.02f, 0.185f}, AZUL, Lado::DERECHA);
    rotula("reverso", {0.02f, 0.125f}, AMARILLO, Lado::DERECHA);
    rotula("borde", {0.02f, 0.065f}, ROJO, Lado::DERECHA);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla != 'f')
        return;
    estado.arreglada = !estado.arreglada;
    construye();
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Malla v/f", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE, "[FICHERO]");
    if (argc > 2)
        falla("solo se puede dar un fichero; sobra «" + std::string(argv[2]) + "»", 2);
    inicia(argc > 1 ? argv[1] : recurso("assets/ejercicio_2_1.vf"));
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
