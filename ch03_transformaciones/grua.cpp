// La grúa de obra con cubos de lado uno (ejercicio 3.5, figura 3.3): gira sobre el pie, desplaza la carga por
// el brazo y la sube y baja. Cada movimiento es una transformación que heredan las piezas que mueve (grua.h).
// Controles: a d giran · q e desplazan la carga · w s la suben y bajan · ratón orbita · Esc termina.
#include "grua.h"
#include "buferes.h"
#include "colores.h"
#include "malla.h"
#include "objeto.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "texto.h"
#include "trazo.h"
#include "ventana.h"
#include <glm/gtc/constants.hpp>

static const float LADO_SUELO = 14, LADO_CUADRICULA = 2;
static const glm::vec3 COLOR_ZAPATA(0.80f, 0.80f, 0.78f);
static const struct {
    const char *nombre;
    glm::vec3 punto; // del cubo de lado uno, o cerca
    Lado lado;
} ROTULOS[] = {{"pie", {-1.2f, 0, 0}, Lado::IZQUIERDA}, // en el orden de piezasGrua
               {"brazo", {0, 0.5f, 0}, Lado::ENCIMA},
               {"contrapeso", {-0.8f, -0.2f, 0}, Lado::IZQUIERDA},
               {"cable", {3, -0.4f, -0.5f}, Lado::DERECHA},
               {"carga", {0, -0.8f, 0}, Lado::DEBAJO}};

static struct {
    GLuint programa;
    Buferes cubo;
    PosturaGrua postura;
    Orbita orbita = {0.5f, 0.25f, 40, {0.4f, 4.1f, 0}, 0.05f};
} estado;

static void inicia() {
    estado.programa = creaProgramaObjeto();
    estado.cubo = creaBuferes(cubo());
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE); // las caras de detrás nunca se ven: los sólidos son cerrados
    ponFondo(CIELO);
}

// El suelo, con su cuadrícula, y la zapata en que se apoya el pie.
static void dibujaSuelo(const glm::mat4 &transformacion) {
    dibujaObjeto(estado.programa, estado.cubo,
                 traslacion({0, -0.1f, 0}) * escalado({LADO_SUELO, 0.2f, LADO_SUELO}), SUELO);
    glDisable(GL_DEPTH_TEST); // están en el suelo, y lo demás aún no se ha dibujado
    trazaSegmentos(cuadricula(LADO_SUELO, LADO_CUADRICULA), transformacion * giroX(glm::half_pi<float>()),
                   0.8f * SUELO, 0.5f * GROSOR);
    glEnable(GL_DEPTH_TEST);
    dibujaObjeto(estado.programa, estado.cubo, escalado({3, 0.1f, 3}), COLOR_ZAPATA);
}

static void dibuja() {
    const glm::mat4 proyeccion = perspectivaVentana(ANGULO_GRUA, 1, 200),
                    camara = camaraOrbita(estado.orbita);
    const glm::mat4 transformacion = proyeccion * camara;
    const std::vector<Pieza> piezas = piezasGrua(estado.postura);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    usaPrograma(estado.programa, camara, proyeccion);
    dibujaSuelo(transformacion);
    for (const Pieza &pieza : piezas)
        dibujaObjeto(estado.programa, estado.cubo, pieza.M, pieza.color);
    for (std::size_t i = 0; i < piezas.size(); ++i)
        rotulaPunto(ROTULOS[i].nombre, piezas[i].M * glm::vec4(ROTULOS[i].punto, 1), transformacion, OSCURO,
                    ROTULOS[i].lado);
    ponTitulo(formatea("Grúa de obra: giro %.0f°, distancia %.1f, altura %.1f",
                       glm::degrees(estado.postura.giro), estado.postura.distancia, estado.postura.altura));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || !mueve(estado.postura, tecla))
        return;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Grúa de obra", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
