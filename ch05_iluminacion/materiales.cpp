// Los doce materiales de la tabla 5.1, en su orden y por filas. El brillo de la tabla es una fracción de 128 y no α
// (materiales.h).
// Controles: n enseña el siguiente solo · t todos · ratón orbita · Esc termina.
#include "materiales.h"
#include "buferes.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "iluminacion.h"
#include "malla.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "ventana.h"

static const int COLUMNAS = 4, FILAS = 3;
static const float SEPARACION = 2.7f, RADIO_SOLA = 3;
static const Luz LUZ{{-0.9f, 0.9f, 1, 0}};
static const std::string TITULO = "Los doce materiales";

static struct {
    GLuint programa;
    Buferes esfera, esferaSola;
    Orbita orbita = {0, 0, 26, {0, -0.3f, 0}};
    int elegido = -1; // o -1 si son todos
} estado;

static void inicia() {
    estado.programa = creaSombreado("phong");
    estado.esfera = creaBuferes(esfera(segmentosEsfera(95)));
    estado.esferaSola = creaBuferes(esfera(segmentosEsfera(290)));
    glEnable(GL_DEPTH_TEST);
    ponFondo(FONDO_OSCURO);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 camara = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.325f, 1, 100);
    usaIluminado(estado.programa, camara, proyeccion, LUZ);
    const auto muestra = [&](int cual, const Buferes &esfera, const glm::vec3 &centro, float radio) {
        const auto &[nombre, material] = TABLA_MATERIALES[cual];
        dibujaIluminado(estado.programa, esfera, traslacion(centro) * escalado(radio), camara, material);
        rotulaPunto(nombre, centro - glm::vec3(0, radio, 0), proyeccion * camara, BLANCO, Lado::DEBAJO);
    };
    if (estado.elegido >= 0)
        muestra(estado.elegido, estado.esferaSola, glm::vec3(0), RADIO_SOLA);
    else
        for (int i = 0; i < COLUMNAS * FILAS; ++i) {
            const glm::vec2 casilla(float(i % COLUMNAS) - 0.5f * (COLUMNAS - 1),
                                    0.5f * (FILAS - 1) - float(i / COLUMNAS));
            muestra(i, estado.esfera, glm::vec3(SEPARACION * casilla, 0), 1);
        }
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    switch (tecla) {
    case 'n': estado.elegido = (estado.elegido + 1) % (COLUMNAS * FILAS); break;
    case 't': estado.elegido = -1; break;
    default: return;
    }
    ponTitulo(estado.elegido < 0 ? TITULO : TITULO + ": " + TABLA_MATERIALES[estado.elegido].nombre);
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, TITULO.c_str(), GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
