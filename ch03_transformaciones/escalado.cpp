// Seis escalados de una F (ejercicio 3.1). Arriba: uniforme, no uniforme y un factor cero; abajo: un factor
// negativo, dos negativos y factores entre 0 y 1. En líneas, la F sin escalar. Amarillo es el lado de fuera
// de las caras y morado el de dentro: con un factor negativo la F es su imagen en un espejo y sus caras giran
// al revés; con dos (determinante positivo) es la F girada media vuelta.
// Controles: ratón orbita · Esc termina.
#include "malla.h"
#include "orbita.h"
#include "shader.h"
#include "transformaciones.h"
#include "ventana.h"
#include <algorithm>

static const glm::vec3 factores[6] = {{1.4f, 1.4f, 1.4f}, {1.8f, 0.6f, 1}, {1, 1, 0},
                                      {-1, 1, 1},         {-1, -1, 1},     {0.5f, 0.5f, 0.5f}};

// La F no pasa por el origen: escalar también acerca, aleja o cambia de lado. Su contorno, en sentido
// antihorario, y los triángulos que lo llenan; se extiende de z = −0.25 a 0.25.
static const glm::vec2 contorno[10] = {{0.15f, 0.15f}, {0.55f, 0.15f}, {0.55f, 0.70f}, {1.05f, 0.70f},
                                       {1.05f, 1.05f}, {0.55f, 1.05f}, {0.55f, 1.30f}, {1.30f, 1.30f},
                                       {1.30f, 1.65f}, {0.15f, 1.65f}};
static const GLuint triangulos[8][3] = {{0, 1, 2}, {2, 3, 4}, {2, 4, 5}, {0, 2, 5},
                                        {0, 5, 6}, {0, 6, 9}, {6, 7, 8}, {6, 8, 9}};
static const glm::vec3 minimo(0.15f, 0.15f, -0.25f), maximo(1.30f, 1.65f, 0.25f);

static const glm::vec3 amarillo(0.98f, 0.78f, 0.15f), morado(0.56f, 0.24f, 0.66f), gris(0.55f, 0.58f, 0.62f);
static const glm::vec3 colorEje[3] = {{0.85f, 0.20f, 0.18f}, {0.20f, 0.62f, 0.28f}, {0.16f, 0.38f, 0.80f}};

static struct {
    GLuint programa;
    Buferes letra, aristas, cilindro;
    Orbita orbita = {0.6f, 0.3f, 10};
} estado;

static Malla creaLetra() {
    Malla letra;
    for (float z : {minimo.z, maximo.z}) {
        const GLuint base = static_cast<GLuint>(letra.vertices.size());
        const bool delante = z > 0;
        for (const glm::vec2 &p : contorno)
            letra.vertices.push_back({{p, z}, {0, 0, delante ? 1 : -1}, p});
        for (const auto &t : triangulos) // la tapa de atrás se ve por el otro lado: gira al revés
            letra.indices.insert(letra.indices.end(),
                                 {base + t[0], base + t[delante ? 1 : 2], base + t[delante ? 2 : 1]});
    }
    for (int i = 0; i < 10; ++i) {
        const glm::vec2 p = contorno[i], q = contorno[(i + 1) % 10];
        const glm::vec3 normal = glm::normalize(glm::vec3(q.y - p.y, p.x - q.x, 0));
        const GLuint base = static_cast<GLuint>(letra.vertices.size());
        for (const glm::vec3 &v :
             {glm::vec3(p, minimo.z), glm::vec3(q, minimo.z), glm::vec3(q, maximo.z), glm::vec3(p, maximo.z)})
            letra.vertices.push_back({v, normal, glm::vec2(v)});
        letra.indices.insert(letra.indices.end(), {base, base + 1, base + 2, base, base + 2, base + 3});
    }
    return letra;
}

// Pares de índices, para GL_LINES: en creaLetra, los diez primeros vértices son la tapa de atrás y los diez
// siguientes la de delante.
static Malla creaAristas() {
    Malla aristas = creaLetra();
    aristas.indices.clear();
    for (Vertice &v : aristas.vertices)
        v.normal = glm::vec3(0); // todas las líneas con la misma luz
    for (GLuint i = 0; i < 10; ++i) {
        const GLuint j = (i + 1) % 10;
        aristas.indices.insert(aristas.indices.end(), {i, j, i + 10, j + 10, i, i + 10});
    }
    return aristas;
}

static void inicia() {
    estado.programa =
        creaPrograma("ch03_transformaciones/objeto.vert", "ch03_transformaciones/escalado.frag");
    estado.letra = creaBuferes(creaLetra());
    estado.aristas = creaBuferes(creaAristas());
    estado.cilindro = creaBuferes(cilindro(16));
    glEnable(GL_DEPTH_TEST);
}

static void dibujaObjeto(GLenum primitiva, const Buferes &objeto, const glm::mat4 &M, const glm::vec3 &fuera,
                         const glm::vec3 &dentro) {
    const glm::mat3 N = matrizNormal(M);
    envia(estado.programa, "M", M);
    envia(estado.programa, "N", N);
    envia(estado.programa, "colorFuera", fuera);
    envia(estado.programa, "colorDentro", dentro);
    glBindVertexArray(objeto.vao);
    glDrawElements(primitiva, objeto.nIndices, GL_UNSIGNED_INT, nullptr);
}

static void dibujaVista(const glm::vec3 &s, const glm::mat4 &proyeccion) {
    // Cada vista se centra en lo que abarcan la F y su escalada; la escala es la misma en todas.
    Orbita orbita = estado.orbita;
    orbita.centro = 0.5f * (glm::min(minimo, glm::min(s * minimo, s * maximo)) +
                            glm::max(maximo, glm::max(s * minimo, s * maximo)));
    const glm::mat4 camara = proyeccion * camaraOrbita(orbita);
    envia(estado.programa, "camara", camara);
    for (int eje = 0; eje < 3; ++eje)
        dibujaObjeto(GL_TRIANGLES, estado.cilindro, ejeCoordenado(eje, eje == 2 ? 0.9f : 1.8f, 0.04f),
                     colorEje[eje], colorEje[eje]);
    // Con un factor cero la cara de delante y la de atrás coinciden: se descartan las que miran hacia atrás,
    // porque la profundidad no puede decidir entre dos iguales.
    if (s.x * s.y * s.z == 0)
        glEnable(GL_CULL_FACE);
    dibujaObjeto(GL_TRIANGLES, estado.letra, escalado(s), amarillo, morado);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST); // el original se ve aunque quede dentro
    dibujaObjeto(GL_LINES, estado.aristas, glm::mat4(1), gris, gris);
    glEnable(GL_DEPTH_TEST);
}

static void dibuja() {
    const int ancho = std::max(glutGet(GLUT_WINDOW_WIDTH) / 3, 1),
              alto = std::max(glutGet(GLUT_WINDOW_HEIGHT) / 2, 1);
    const glm::mat4 proyeccion =
        perspectivaVentana(0.34f, 1, 100, static_cast<float>(ancho) / static_cast<float>(alto));
    glClearColor(0.55f, 0.58f, 0.62f, 1); // el de las rayas que separan las vistas
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glClearColor(0.95f, 0.96f, 0.98f, 1);
    glUseProgram(estado.programa);
    glLineWidth(static_cast<float>(std::max(std::min(ancho, alto) / 150, 1)));
    for (int i = 0; i < 6; ++i) {
        const int x = i % 3 * ancho, y = (1 - i / 3) * alto; // la primera fila es la de arriba
        glEnable(GL_SCISSOR_TEST);
        glScissor(x + 1, y + 1, std::max(ancho - 2, 1), std::max(alto - 2, 1));
        glClear(GL_COLOR_BUFFER_BIT);
        glDisable(GL_SCISSOR_TEST);
        glViewport(x, y, ancho, alto);
        dibujaVista(factores[i], proyeccion);
    }
    glutSwapBuffers();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Seis escalados", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
