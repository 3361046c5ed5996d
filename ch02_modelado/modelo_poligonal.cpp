// Un modelo poligonal de principio a fin: la estructura de datos (listado 2.1), sus buffer objects (2.2), los
// índices de los atributos (2.3) y el dibujo (2.4). Es una rueda de color: seis triángulos que comparten siete
// vértices. Del libro se aparta en el VAO, sin el que un contexto core no dibuja: como recuerda dónde está cada
// atributo, glVertexAttribPointer se llama una vez, en inicia, y no en cada imagen (display, aquí dibuja).
// Controles: Esc termina.
#include "colores.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "ventana.h"
#include <algorithm>
#include <cstddef>
#include <glm/gtc/type_ptr.hpp>

struct VerticeColor {
    GLfloat coordenadas[3];
    GLfloat color[3];
};

struct Triangulo {
    GLuint indices[3];
};

static const VerticeColor VERTICES[] = {
    {{0.000f, 0.000f, 0.0f}, {1, 1, 1}},   // 0: el centro, blanco
    {{0.000f, 0.780f, 0.0f}, {1, 0, 0}},   // 1: rojo
    {{-0.675f, 0.390f, 0.0f}, {1, 1, 0}},  // 2: amarillo
    {{-0.675f, -0.390f, 0.0f}, {0, 1, 0}}, // 3: verde
    {{0.000f, -0.780f, 0.0f}, {0, 1, 1}},  // 4: cian
    {{0.675f, -0.390f, 0.0f}, {0, 0, 1}},  // 5: azul
    {{0.675f, 0.390f, 0.0f}, {1, 0, 1}},   // 6: magenta
};

// A qué lado del vértice va su número.
static const Lado LADOS[] = {Lado::DEBAJO, Lado::ENCIMA,  Lado::IZQUIERDA, Lado::IZQUIERDA,
                             Lado::DEBAJO, Lado::DERECHA, Lado::DERECHA};

static const Triangulo TRIANGULOS[] = {
    {{0, 1, 2}}, {{0, 2, 3}}, {{0, 3, 4}}, {{0, 4, 5}}, {{0, 5, 6}}, {{0, 6, 1}},
};
static const GLsizei N_TRIANGULOS = sizeof TRIANGULOS / sizeof TRIANGULOS[0];

enum { bufferVertices, bufferTriangulos, nBuffers };

static struct { GLuint programa, vao, buffers[nBuffers]; } estado;

static void inicia() {
    estado.programa = creaPrograma("ch02_modelado/plana.vert", "ch02_modelado/plana.frag");
    glGenVertexArrays(1, &estado.vao);
    glBindVertexArray(estado.vao);

    // El modelo pasa a la memoria del procesador gráfico.
    glGenBuffers(nBuffers, estado.buffers);
    glBindBuffer(GL_ARRAY_BUFFER, estado.buffers[bufferVertices]);
    glBufferData(GL_ARRAY_BUFFER, sizeof VERTICES, VERTICES, GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, estado.buffers[bufferTriangulos]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof TRIANGULOS, TRIANGULOS, GL_STATIC_DRAW);

    // Qué índice tiene cada atributo del shader y dónde está su dato dentro de cada vértice.
    const GLint iPosicion = glGetAttribLocation(estado.programa, "posicion"),
                iColor = glGetAttribLocation(estado.programa, "color");
    glVertexAttribPointer(iPosicion, 3, GL_FLOAT, GL_FALSE, sizeof(VerticeColor),
                          reinterpret_cast<const void *>(offsetof(VerticeColor, coordenadas)));
    glVertexAttribPointer(iColor, 3, GL_FLOAT, GL_FALSE, sizeof(VerticeColor),
                          reinterpret_cast<const void *>(offsetof(VerticeColor, color)));
    glEnableVertexAttribArray(iPosicion);
    glEnableVertexAttribArray(iColor);

    ponFondo(FONDO_OSCURO);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(estado.programa);
    glBindVertexArray(estado.vao); // con él vuelven los atributos y el buffer de índices
    glDrawElements(GL_TRIANGLES, 3 * N_TRIANGULOS, GL_UNSIGNED_INT, nullptr);
    for (std::size_t i = 0; i < sizeof VERTICES / sizeof VERTICES[0]; ++i)
        rotulaPunto(std::to_string(i), glm::make_vec3(VERTICES[i].coordenadas), glm::mat4(1), BLANCO,
                    LADOS[i]);
    glutSwapBuffers();
}

// El mayor cuadrado centrado que cabe: la rueda conserva su forma en cualquier ventana.
static void cambiaTamano(int ancho, int alto) {
    const int lado = std::max(std::min(ancho, alto), 1);
    glViewport((ancho - lado) / 2, (alto - lado) / 2, lado, lado);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Modelo poligonal", GLUT_DOUBLE | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutReshapeFunc(cambiaTamano);
    glutMainLoop();
    return 0;
}
