// Una esfera con luz y textura, y una raya, a las que se puede estropear una cosa: con eso se prueba que el comparador
// la nota (tests/comparador/defectos.sh). Argumento: nada, luz (gira 3 grados), textura (falta), pixel (todo se corre
// uno), medio (solo la esfera, medio), triangulo (falta uno de los 3968), raya (falta), colores (rojo por azul) u
// oscura (un 5 %).
#include "buferes.h"
#include "error.h"
#include "proyeccion.h"
#include "shader.h"
#include "textura.h"
#include "trazo.h"
#include "ventana.h"
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <string>
#include <utility>

static struct {
    GLuint programa;
    Buferes esfera;
    std::string defecto = "nada";
} estado;

static void inicia() {
    estado.programa = creaPrograma("tests/comparador/escena.vert", "tests/comparador/escena.frag");
    Malla malla = esfera(64);
    if (estado.defecto == "triangulo") {
        const auto centro = malla.indices.begin() + 3 * (64 + 15 * 128 + 96); // en medio de lo que se ve
        malla.indices.erase(centro, centro + 3);
    }
    estado.esfera = creaBuferes(malla);
    Imagen ajedrez{8, 8, {}};
    for (int i = 0; i < 64; ++i)
        for (int c = 0; c < 3; ++c)
            ajedrez.rgb.push_back((i + i / 8) % 2 ? 230 : c == 2 ? 60 : 180);
    if (estado.defecto == "textura")
        ajedrez = {1, 1, {255, 255, 255}};
    if (estado.defecto == "colores")
        for (std::size_t i = 0; i < ajedrez.rgb.size(); i += 3)
            std::swap(ajedrez.rgb[i], ajedrez.rgb[i + 2]);
    if (estado.defecto == "oscura")
        for (unsigned char &v : ajedrez.rgb)
            v = static_cast<unsigned char>(v * 95 / 100);
    creaTextura2D(ajedrez);
    glEnable(GL_DEPTH_TEST);
    glClearColor(0.2f, 0.3f, 0.4f, 1);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    const float giro = glm::radians(estado.defecto == "luz" ? 43.0f : 40.0f);
    const glm::vec3 luz(std::sin(giro), 0.3f, std::cos(giro));
    const float corrida = estado.defecto == "medio" ? 1.0f / 240 : 0;
    const glm::mat4 camara = glm::translate(glm::mat4(1), {corrida, 0, 0}) * perspectivaVentana(0.6f, 1, 10) *
                             glm::lookAt(glm::vec3(0, -4, 0), glm::vec3(0), glm::vec3(0, 0, 1));
    glUniformMatrix4fv(uniforme(estado.programa, "camara"), 1, GL_FALSE, glm::value_ptr(camara));
    glUniform3f(uniforme(estado.programa, "luz"), luz.x, -luz.z, luz.y);
    glDrawElements(GL_TRIANGLES, estado.esfera.nIndices, GL_UNSIGNED_INT, nullptr);
    if (estado.defecto != "raya")
        trazaSegmentos({{-0.8f, 0.9f, 0}, {0.4f, 0.87f, 0}}, glm::mat4(1), glm::vec3(1));
    glutSwapBuffers();
}

static void cambiaTamano(int ancho, int alto) {
    glViewport(estado.defecto == "pixel" ? 1 : 0, 0, ancho, alto);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "escena_comparador", GLUT_DOUBLE | GLUT_RGBA | GLUT_DEPTH, "[DEFECTO]");
    if (argc > 1)
        estado.defecto = argv[1];
    inicia();
    glutDisplayFunc(dibuja);
    glutReshapeFunc(cambiaTamano);
    glutMainLoop();
    return 0;
}
