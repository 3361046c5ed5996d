#include "recuadro.h"
#include "proyeccion.h"
#include <GL/glew.h>
#include <GL/freeglut.h>
#include <algorithm>

Recuadro ventanaEntera() {
    return {0, 0, glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT)};
}

float aspecto(const Recuadro &r) {
    return static_cast<float>(std::max(r.ancho, 1)) / static_cast<float>(std::max(r.alto, 1));
}

std::vector<Recuadro> rejilla(int columnas, int filas, const Recuadro &donde) {
    const int raya = std::max(static_cast<int>(altoUtil() / 180), 1);
    // comienzo del panel i de n, de modo que entre todos y las rayas llenen el largo sin que sobre un píxel
    const auto comienzo = [raya](int i, int n, int largo) { return i * (largo + raya) / n; };
    std::vector<Recuadro> paneles;
    for (int fila = filas - 1; fila >= 0; --fila)
        for (int columna = 0; columna < columnas; ++columna) {
            const int x = comienzo(columna, columnas, donde.ancho), y = comienzo(fila, filas, donde.alto);
            paneles.push_back({donde.x + x, donde.y + y,
                               std::max(comienzo(columna + 1, columnas, donde.ancho) - raya - x, 0),
                               std::max(comienzo(fila + 1, filas, donde.alto) - raya - y, 0)});
        }
    return paneles;
}

std::vector<Recuadro> reparte(int n, float aspectoEscena, const Recuadro &donde) {
    int mejor = 1;
    float mayor = 0;
    for (int columnas = 1; columnas <= n; ++columnas) {
        const int filas = (n + columnas - 1) / columnas;
        const float alto =
            std::min(static_cast<float>(donde.ancho) / static_cast<float>(columnas) / aspectoEscena,
                     static_cast<float>(donde.alto) / static_cast<float>(filas));
        if (alto > mayor) {
            mayor = alto;
            mejor = columnas;
        }
    }
    std::vector<Recuadro> paneles = rejilla(mejor, (n + mejor - 1) / mejor, donde);
    paneles.resize(static_cast<std::size_t>(n));
    return paneles;
}

void abreRecuadro(const Recuadro &r) {
    glViewport(r.x, r.y, r.ancho, r.alto);
    glScissor(r.x, r.y, r.ancho, r.alto); // glClear no obedece a glViewport, pero sí a glScissor
    glEnable(GL_SCISSOR_TEST);            // hasta que glutSwapBuffers acaba el cuadro (ayuda.cpp)
}

void ponFondo(const glm::vec3 &color) {
    glClearColor(color.r, color.g, color.b, 1);
}
