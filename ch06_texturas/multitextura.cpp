// Varias unidades de textura en un fragment shader (§6.3, §6.5): los ladrillos, el musgo, la máscara que dice
// dónde lo hay y la luz de dos apliques, calculada de antemano. Cada textura está en su unidad, y cada
// sampler2D recibe el número de una. Ladrillos y musgo se repiten; la máscara y la luz abarcan la pared
// entera.
// Controles: 1 ladrillos y musgo · 2 ladrillos y luz · 3 las cuatro texturas · ratón orbita · Esc termina.
#include "ch03_transformaciones/transformaciones.h"
#include "malla.h"
#include "orbita.h"
#include "rutas.h"
#include "shader.h"
#include "textura.h"
#include "ventana.h"

static const float ANCHO = 4, ALTO = 3; // de la pared
static const glm::vec2 repeticiones(2, 1.5f);
static const struct {
    const char *nombre; // del fichero y del sampler2D
    int ancho, alto;
    GLint borde;
} texturas[4] = {{"ladrillo", 256, 256, GL_REPEAT},
                 {"musgo", 256, 256, GL_REPEAT},
                 {"mascara", 128, 96, GL_CLAMP_TO_EDGE},
                 {"luz", 64, 48, GL_CLAMP_TO_EDGE}};

static struct {
    GLuint programa;
    Buferes pared;
    bool conMusgo = true, conLuz = true;
    Orbita orbita = {0, 0, 5, {0, 0, 0}};
} estado;

static void inicia() {
    estado.programa = creaPrograma("ch06_texturas/multitextura.vert", "ch06_texturas/multitextura.frag");
    estado.pared = creaBuferes(plano(1));
    GLenum unidad = GL_TEXTURE0;
    for (const auto &t : texturas) {
        glActiveTexture(unidad++); // creaTextura2D deja su textura en la unidad activa
        creaTextura2D(leeTextura(recurso("assets/" + std::string(t.nombre) + ".rgb"), t.ancho, t.alto));
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, t.borde);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, t.borde);
    }
    glEnable(GL_DEPTH_TEST);
    glClearColor(0.16f, 0.17f, 0.20f, 1);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    const glm::mat4 matriz =
        perspectivaVentana(0.583f, 0.1f, 100) * camaraOrbita(estado.orbita) * escalado({ANCHO, ALTO, 1});
    envia(estado.programa, "matriz", matriz);
    envia(estado.programa, "repeticiones", repeticiones);
    GLint unidad = 0;
    for (const auto &t : texturas)
        envia(estado.programa, t.nombre, unidad++);
    envia(estado.programa, "conMusgo", estado.conMusgo);
    envia(estado.programa, "conLuz", estado.conLuz);
    dibuja(estado.pared);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla < '1' || tecla > '3')
        return;
    estado.conMusgo = tecla != '2';
    estado.conLuz = tecla != '1';
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Multitextura", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
