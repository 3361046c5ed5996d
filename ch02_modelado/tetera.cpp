// La tetera de Utah (figuras 2.1 y 2.2): 32 parches de Bézier triangulados con la normal exacta en cada vértice. Se da
// el mayor error de cuerda, en píxeles de la ventana de partida, y salen los triángulos que hacen falta (bezier.h). Los
// cuadriláteros de la figura 2.1 se parten en dos triángulos, porque OpenGL 3.1 no tiene esa primitiva; las aristas las
// pinta el fragment shader.
// Controles: m triángulos · c cuadriláteros · + más fina · - más basta · ratón orbita · Esc termina.
#include "bezier.h"
#include "buferes.h"
#include "colores.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "texto.h"
#include "ventana.h"
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

static const float ANGULO = 0.55f; // de la perspectiva, en radianes
static const Orbita ORBITA = {0.22f, 0.38f, 9.5f, {0.43f, 1.42f, 0}};
// Lado de un píxel a la distancia del centro, con 720 líneas. Con error de 1 el medido no llega a medio píxel (la
// prueba ch02_bezier lo mide): en esta superficie es como mucho la mitad de lo que garantiza la cota.
static const double PIXEL = 2 * std::tan(0.5 * ANGULO) * ORBITA.distancia / 720;
static const double ERROR_INICIAL = 1, ERROR_MINIMO = 1.0 / 16, ERROR_MAXIMO = 64; // píxeles
static const double ERROR_CON_LINEAS = 0.5; // con menos, todo serían líneas

enum Lineas { NINGUNA, TRIANGULOS, CUADRILATEROS };

static struct {
    GLuint programa;
    std::vector<Parche> parches;
    double error = ERROR_INICIAL;
    Lineas lineas = NINGUNA;
    Buferes tetera = {};
    Orbita orbita = ORBITA;
} estado;

static std::string texto(const char *separador) {
    return formatea("error ≤ %.3g px%s", estado.error, separador) +
           (estado.lineas == CUADRILATEROS ? "cuadriláteros"
                                           : formatea("%d triángulos", estado.tetera.nIndices / 3));
}

static void construye() {
    Teselacion t = teselaParches(estado.parches, estado.error * PIXEL);
    for (std::size_t i = 0; i < t.cuadricula.size(); ++i)
        t.malla.vertices[i].coordTextura = t.cuadricula[i];
    borraBuferes(estado.tetera);
    estado.tetera = creaBuferes(t.malla);
}

static void dibuja() {
    const bool hayLineas = estado.lineas != NINGUNA;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    usaPrograma(estado.programa, camaraOrbita(estado.orbita), perspectivaVentana(ANGULO, 0.5f, 50));
    // en los datos la vertical es Z, y en la cámara Y
    envia(estado.programa, "M", glm::rotate(glm::mat4(1), -glm::half_pi<float>(), glm::vec3(1, 0, 0)));
    envia(estado.programa, "ojo", posicionCamara(estado.orbita));
    envia(estado.programa, "colorObjeto", hayLineas ? GRIS : AZUL);
    envia(estado.programa, "colorLinea", OSCURO);
    envia(estado.programa, "grosor", hayLineas ? glm::max(altoUtil() / 360, 1.0f) : 0.0f);
    envia(estado.programa, "hayDiagonales", estado.lineas == TRIANGULOS);
    dibujaMalla(estado.tetera);
    rotula(texto("\n"), {0.5f, 0.08f}, OSCURO);
    ponTitulo("Tetera: " + texto(", "));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    switch (tecla) {
    case 'm': estado.lineas = estado.lineas == TRIANGULOS ? NINGUNA : TRIANGULOS; break;
    case 'c': estado.lineas = estado.lineas == CUADRILATEROS ? NINGUNA : CUADRILATEROS; break;
    case '+': estado.error /= 2; break;
    case '-': estado.error *= 2; break;
    default: return;
    }
    estado.error =
        glm::clamp(estado.error, estado.lineas == NINGUNA ? ERROR_MINIMO : ERROR_CON_LINEAS, ERROR_MAXIMO);
    construye();
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Tetera", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    estado.programa = creaPrograma("ch02_modelado/tetera.vert", "ch02_modelado/tetera.frag");
    estado.parches = leeParches("assets/tetera.txt");
    construye();
    glEnable(GL_DEPTH_TEST);
    ponFondo(FONDO_CLARO);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
