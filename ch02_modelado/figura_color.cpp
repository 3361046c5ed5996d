// Una figura plana con degradados (ejercicio 2.3, cuya ilustración no ha llegado al texto del libro): un
// velero al atardecer. Todo sale de dar un color a cada vértice y dejar que OpenGL lo interpole; los trozos
// son tiras, abanicos y triángulos sueltos de un mismo buffer, dibujados de atrás hacia delante.
// Controles: Esc termina.
#include "shader.h"
#include "ventana.h"
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/gtc/constants.hpp>
#include <vector>

struct VerticePlano {
    GLfloat posicion[2], color[3];
};

struct Trozo {
    GLenum primitiva;
    std::vector<VerticePlano> vertices;
};

static const float HORIZONTE = -0.20f, X_SOL = -0.28f, RADIO_SOL = 0.30f;

static struct {
    GLuint programa;
    std::vector<Trozo> trozos;
} estado;

// Medio disco sobre el horizonte: un abanico que se aclara hacia el centro.
static Trozo sol() {
    const int SEGMENTOS = 24;
    Trozo p = {GL_TRIANGLE_FAN, {{{X_SOL, HORIZONTE}, {1.00f, 0.98f, 0.75f}}}};
    for (int i = 0; i <= SEGMENTOS; ++i) {
        const float a = glm::pi<float>() * float(i) / SEGMENTOS;
        p.vertices.push_back(
            {{X_SOL + RADIO_SOL * std::cos(a), HORIZONTE + RADIO_SOL * std::sin(a)}, {1.00f, 0.62f, 0.16f}});
    }
    return p;
}

static std::vector<Trozo> trozos() {
    return {
        {GL_TRIANGLE_STRIP, // cielo: cuatro alturas, de la noche al horizonte
         {{{-1, 1}, {0.10f, 0.12f, 0.36f}},
          {{1, 1}, {0.10f, 0.12f, 0.36f}},
          {{-1, 0.45f}, {0.42f, 0.24f, 0.55f}},
          {{1, 0.45f}, {0.42f, 0.24f, 0.55f}},
          {{-1, 0.10f}, {0.93f, 0.42f, 0.38f}},
          {{1, 0.10f}, {0.93f, 0.42f, 0.38f}},
          {{-1, HORIZONTE}, {1.00f, 0.78f, 0.38f}},
          {{1, HORIZONTE}, {1.00f, 0.78f, 0.38f}}}},
        sol(),
        {GL_TRIANGLE_STRIP, // costa
         {{{0.25f, HORIZONTE}, {0.45f, 0.24f, 0.45f}},
          {{0.50f, 0.02f}, {0.62f, 0.36f, 0.52f}},
          {{0.68f, HORIZONTE}, {0.45f, 0.24f, 0.45f}},
          {{0.80f, 0.10f}, {0.62f, 0.36f, 0.52f}},
          {{1.00f, HORIZONTE}, {0.45f, 0.24f, 0.45f}},
          {{1.00f, -0.02f}, {0.62f, 0.36f, 0.52f}}}},
        {GL_TRIANGLE_STRIP, // mar
         {{{-1, HORIZONTE}, {0.93f, 0.55f, 0.40f}},
          {{1, HORIZONTE}, {0.93f, 0.55f, 0.40f}},
          {{-1, -0.45f}, {0.36f, 0.33f, 0.60f}},
          {{1, -0.45f}, {0.36f, 0.33f, 0.60f}},
          {{-1, -1}, {0.05f, 0.13f, 0.33f}},
          {{1, -1}, {0.05f, 0.13f, 0.33f}}}},
        {GL_TRIANGLES, // reflejo del sol, que se apaga en el color del mar
         {{{X_SOL - RADIO_SOL, HORIZONTE}, {0.96f, 0.60f, 0.36f}},
          {{X_SOL + RADIO_SOL, HORIZONTE}, {0.96f, 0.60f, 0.36f}},
          {{X_SOL, -0.90f}, {0.24f, 0.22f, 0.46f}},
          {{X_SOL - 0.14f, HORIZONTE}, {1.00f, 0.90f, 0.60f}},
          {{X_SOL + 0.14f, HORIZONTE}, {1.00f, 0.90f, 0.60f}},
          {{X_SOL, -0.62f}, {0.62f, 0.42f, 0.52f}}}},
        {GL_TRIANGLE_STRIP, // mástil
         {{{0.303f, -0.42f}, {0.30f, 0.14f, 0.16f}},
          {{0.327f, -0.42f}, {0.20f, 0.10f, 0.14f}},
          {{0.303f, 0.58f}, {0.52f, 0.26f, 0.22f}},
          {{0.327f, 0.58f}, {0.36f, 0.18f, 0.20f}}}},
        {GL_TRIANGLES, // velas
         {{{0.30f, -0.36f}, {0.98f, 0.84f, 0.70f}},
          {{0.30f, 0.52f}, {1.00f, 0.97f, 0.92f}},
          {{-0.12f, -0.36f}, {0.95f, 0.55f, 0.10f}},
          {{0.35f, -0.36f}, {0.85f, 0.20f, 0.18f}},
          {{0.62f, -0.34f}, {0.72f, 0.10f, 0.22f}},
          {{0.33f, 0.40f}, {1.00f, 0.62f, 0.30f}}}},
        {GL_TRIANGLE_FAN, // casco
         {{{0.27f, -0.40f}, {0.55f, 0.27f, 0.20f}},
          {{-0.20f, -0.40f}, {0.70f, 0.34f, 0.20f}},
          {{-0.06f, -0.56f}, {0.24f, 0.11f, 0.16f}},
          {{0.56f, -0.56f}, {0.18f, 0.08f, 0.14f}},
          {{0.76f, -0.38f}, {0.42f, 0.18f, 0.18f}}}},
    };
}

static void inicia() {
    estado.programa = creaPrograma("ch02_modelado/plana.vert", "ch02_modelado/plana.frag");
    estado.trozos = trozos();
    std::vector<VerticePlano> vertices;
    for (const Trozo &p : estado.trozos)
        vertices.insert(vertices.end(), p.vertices.begin(), p.vertices.end());

    GLuint vao, buffer;
    glGenVertexArrays(1, &vao);
    glBindVertexArray(vao);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, vertices.size() * sizeof(VerticePlano), vertices.data(), GL_STATIC_DRAW);
    glVertexAttribPointer(ATRIBUTO_POSICION, 2, GL_FLOAT, GL_FALSE, sizeof(VerticePlano),
                          reinterpret_cast<const void *>(offsetof(VerticePlano, posicion)));
    glVertexAttribPointer(ATRIBUTO_COLOR, 3, GL_FLOAT, GL_FALSE, sizeof(VerticePlano),
                          reinterpret_cast<const void *>(offsetof(VerticePlano, color)));
    glEnableVertexAttribArray(ATRIBUTO_POSICION);
    glEnableVertexAttribArray(ATRIBUTO_COLOR);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(estado.programa);
    GLint primero = 0;
    for (const Trozo &p : estado.trozos) {
        const auto n = GLsizei(p.vertices.size());
        glDrawArrays(p.primitiva, primero, n);
        primero += n;
    }
    glutSwapBuffers();
}

// El menor cuadrado centrado que cubre la ventana: la escena la llena sin deformarse y lo que sobra se
// recorta.
static void cambiaTamano(int ancho, int alto) {
    const int lado = std::max(std::max(ancho, alto), 1);
    glViewport((ancho - lado) / 2, (alto - lado) / 2, lado, lado);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Figura con degradado", GLUT_DOUBLE | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutReshapeFunc(cambiaTamano);
    glutMainLoop();
    return 0;
}
