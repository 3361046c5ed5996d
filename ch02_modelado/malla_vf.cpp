// Lee una malla v/f, la dibuja con el anverso azul y el reverso amarillo e informa de su topología (ejercicio
// 2.1; el análisis está en topologia.h). Las aristas de borde van en rojo: la malla del ejercicio, que es la
// que se ve sin dar fichero, es una caja sin tapa en la que las caras 5 y 6 están definidas al revés.
// Controles: f invierte las caras mal orientadas · ratón orbita · Esc termina.
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

static const glm::vec3 azul(0.20f, 0.42f, 0.84f), amarillo(0.98f, 0.78f, 0.15f), rojo(0.85f, 0.12f, 0.12f),
    morado(0.55f, 0.15f, 0.60f), oscuro(0.16f, 0.17f, 0.20f);
static const float ANGULO = 0.6f; // de la perspectiva, en radianes

static struct {
    GLuint programaCaras, programaLineas;
    MallaVf malla;
    bool arreglada = false;
    // en el buffer de índices van, seguidos, los triángulos y las aristas de una, de dos y de más caras
    GLsizei nTriangulos, nAristas[3];
    Orbita orbita = {0.55f, 0.62f, 1}; // la distancia la pone el encuadre
} estado;

static std::string sentidoVistoDesdeFuera(const Topologia &t) {
    static const char *const nombres[] = {"antihorario", "horario", "indefinido"};
    std::string texto;
    for (Sentido s : {Sentido::ANTIHORARIO, Sentido::HORARIO, Sentido::INDEFINIDO}) {
        const auto n = static_cast<std::size_t>(std::count(t.sentidos.begin(), t.sentidos.end(), s));
        const std::string nombre = nombres[static_cast<int>(s)];
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

    std::vector<GLuint> indices;
    for (const auto &triangulo : triangula(malla))
        indices.insert(indices.end(), triangulo.begin(), triangulo.end());
    estado.nTriangulos = static_cast<GLsizei>(indices.size());
    for (int caras = 1; caras <= 3; ++caras) {
        const std::size_t antes = indices.size();
        for (const Arista &a : t.aristas)
            if (std::min(a.caras, 3) == caras)
                indices.insert(indices.end(), {a.a, a.b});
        estado.nAristas[caras - 1] = static_cast<GLsizei>(indices.size() - antes);
    }
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(GLuint)),
                 indices.data(), GL_STATIC_DRAW);
}

static void inicia(const std::string &fichero) {
    estado.programaCaras = creaPrograma("ch02_modelado/caras.vert", "ch02_modelado/caras.frag");
    estado.programaLineas = creaPrograma("ch02_modelado/caras.vert", "ch02_modelado/lineas.frag");
    estado.malla = leeVf(fichero);
    const std::vector<glm::vec3> vertices = encuadra(estado.malla.vertices);
    estado.orbita.distancia = distanciaQueEncuadra(vertices, estado.orbita, ANGULO, relacionAspecto());

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
    construye();

    glEnable(GL_DEPTH_TEST);
    glEnable(GL_POLYGON_OFFSET_FILL); // las caras un poco más lejos: no tapan sus propias aristas
    glPolygonOffset(1, 1);
    glClearColor(0.95f, 0.96f, 0.98f, 1);
}

static void dibuja() {
    const glm::mat4 camara = perspectivaVentana(ANGULO, 0.1f, 100) * camaraOrbita(estado.orbita);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

    glUseProgram(estado.programaCaras);
    envia(estado.programaCaras, "camara", camara);
    envia(estado.programaCaras, "colorAnverso", azul);
    envia(estado.programaCaras, "colorReverso", amarillo);
    glDrawElements(GL_TRIANGLES, estado.nTriangulos, GL_UNSIGNED_INT, nullptr);

    glUseProgram(estado.programaLineas);
    envia(estado.programaLineas, "camara", camara);
    const float pixel =
        static_cast<float>(glutGet(GLUT_WINDOW_HEIGHT)) / 240; // el grosor crece con la imagen
    const glm::vec3 colores[] = {rojo, oscuro, morado};
    const float grosores[] = {4, 1, 4};
    std::size_t primero = static_cast<std::size_t>(estado.nTriangulos);
    for (int i = 0; i < 3; ++i) {
        glLineWidth(std::max(grosores[i] * pixel, grosores[i]));
        envia(estado.programaLineas, "color", colores[i]);
        glDrawElements(GL_LINES, estado.nAristas[i], GL_UNSIGNED_INT,
                       reinterpret_cast<const void *>(primero * sizeof(GLuint)));
        primero += static_cast<std::size_t>(estado.nAristas[i]);
    }
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
