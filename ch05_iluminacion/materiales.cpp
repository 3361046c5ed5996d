// Los doce materiales de la tabla 5.1, en su orden y por filas: esmeralda, jade, obsidiana y perla; rubí,
// turquesa, bronce y cobre; oro, plata, plástico y goma. El brillo de la tabla es una fracción de 128 y no
// alfa (materiales.h).
// Controles: n enseña el siguiente solo · t todos · ratón orbita · Esc termina.
#include "materiales.h"
#include "ch03_transformaciones/transformaciones.h"
#include "iluminacion.h"
#include "malla.h"
#include "orbita.h"
#include "ventana.h"

static const int COLUMNAS = 4, FILAS = 3;
static const float SEPARACION = 2.2f, RADIO_SOLO = 3;
static const glm::vec3 La(1);
static const Luz luz{{-0.9f, 0.9f, 1, 0}};
static const char *const TITULO = "Los doce materiales";

static struct {
    GLuint programa;
    Buferes esfera;
    Orbita orbita = {0, 0, 22, {0, 0, 0}};
    int solo = -1; // material que se enseña, o -1 si son todos
} estado;

static void inicia() {
    estado.programa =
        creaPrograma("ch05_iluminacion/sombreado_phong.vert", "ch05_iluminacion/sombreado_phong.frag");
    estado.esfera = creaBuferes(esfera(segmentosPara(300, 0.1f)));
    glEnable(GL_DEPTH_TEST);
    glClearColor(0.26f, 0.27f, 0.30f, 1);
}

static void dibujaEsfera(const glm::mat4 &M, const Material &material) {
    const glm::mat3 N = matrizNormal(camaraOrbita(estado.orbita) * M);
    envia(estado.programa, "M", M);
    envia(estado.programa, "N", N);
    enviaMaterial(estado.programa, material);
    glDrawElements(GL_TRIANGLES, estado.esfera.nIndices, GL_UNSIGNED_INT, nullptr);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    const glm::mat4 vista = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.31f, 1, 100);
    envia(estado.programa, "vista", vista);
    envia(estado.programa, "proyeccion", proyeccion);
    envia(estado.programa, "La", La);
    enviaLuz(estado.programa, "luz", luz, vista);
    glBindVertexArray(estado.esfera.vao);
    if (estado.solo >= 0) {
        dibujaEsfera(escalado(RADIO_SOLO), TABLA_MATERIALES[estado.solo].material);
    } else {
        for (int i = 0; i < COLUMNAS * FILAS; ++i) {
            const float x = static_cast<float>(i % COLUMNAS) - 0.5f * (COLUMNAS - 1),
                        y = 0.5f * (FILAS - 1) - static_cast<float>(i / COLUMNAS);
            dibujaEsfera(traslacion(SEPARACION * glm::vec3(x, y, 0)), TABLA_MATERIALES[i].material);
        }
    }
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    switch (tecla) {
    case 'n': estado.solo = (estado.solo + 1) % (COLUMNAS * FILAS); break;
    case 't': estado.solo = -1; break;
    default: return;
    }
    glutSetWindowTitle(estado.solo >= 0 ? TABLA_MATERIALES[estado.solo].nombre : TITULO);
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, TITULO, GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
