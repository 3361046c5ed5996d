// El mismo cubo en perspectiva y en paralela (ecuaciones 4.2 y 4.3, figura 4.2), con sus aristas prolongadas hacia el
// fondo. En perspectiva todas las que son paralelas van a un punto de fuga, el de su dirección; los de las horizontales
// están en el horizonte, a la altura de los ojos. En paralela siguen paralelas y no hay punto de fuga.
// Controles: p cambia de proyección · ratón orbita · Esc termina.
#include "aspecto.h"
#include "buferes.h"
#include "ch03_transformaciones/objeto.h"
#include "colores.h"
#include "malla.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "trazo.h"
#include "ventana.h"
#include "vista.h"

static const double ANGULO = 1.0, CERCA = 0.1, LEJOS = 2000; // de la perspectiva; el ángulo, en radianes
static const float FONDO = 1000;                             // hasta dónde se prolongan las aristas

static struct {
    GLuint programa;
    Buferes cubo;
    bool enPerspectiva = true;
    Orbita orbita = {0.50f, 0.33f, 3.0f, {0.1f, 0.2f, 0}};
} estado;

static void inicia() {
    estado.programa = creaProgramaObjeto();
    estado.cubo = creaBuferes(cubo());
    glEnable(GL_DEPTH_TEST);
    glPolygonOffset(8, 8);  // las caras, por detrás de sus aristas
    glEnable(GL_CULL_FACE); // tan atrás, junto al contorno asomarían las del otro lado
    ponFondo(FONDO_CLARO);
}

// Las cuatro aristas de un eje, de punta a punta, y su prolongación en el sentido `fondo`.
static void trazaAristas(int eje, const glm::vec3 &fondo, const glm::mat4 &aRecortado) {
    glm::vec3 medio(0), mitad(0);
    mitad[eje] = 0.5f;
    std::vector<glm::vec3> aristas, rectas;
    for (const float a : {-0.5f, 0.5f})
        for (const float b : {-0.5f, 0.5f}) {
            medio[(eje + 1) % 3] = a;
            medio[(eje + 2) % 3] = b;
            aristas.insert(aristas.end(), {medio - mitad, medio + mitad});
            rectas.insert(rectas.end(), {medio, medio + FONDO * fondo});
        }
    if (eje != 1)
        trazaSegmentos(rectas, aRecortado, COLOR_EJE[eje], 5);
    trazaSegmentos(aristas, aRecortado, COLOR_EJE[eje], 14);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::dvec3 ojo(posicionCamara(estado.orbita));
    const glm::dvec3 F = baseCamara(ojo, estado.orbita.centro, {0, 1, 0}).F;
    const double aspecto = relacionAspecto();
    const double theta = anguloVertical(ANGULO, aspecto);
    // la paralela abarca lo mismo que la perspectiva a la distancia del centro
    const double y = estado.orbita.distancia * std::tan(theta / 2);
    const double x = aspecto * y;
    const glm::mat4 proyeccion(estado.enPerspectiva ? proyeccionPerspectiva(theta, aspecto, CERCA, LEJOS)
                                                    : proyeccionParalela(-x, x, -y, y, -LEJOS, LEJOS)),
        camara(transformacionCamara(ojo, estado.orbita.centro, {0, 1, 0}));
    const glm::mat4 aRecortado = proyeccion * camara;
    usaPrograma(estado.programa, camara, proyeccion);
    glEnable(GL_POLYGON_OFFSET_FILL);
    dibujaObjeto(estado.programa, estado.cubo, glm::mat4(1), AMARILLO);
    glDisable(GL_POLYGON_OFFSET_FILL);

    std::vector<glm::vec3> fugas; // vistos desde el ojo, a la mitad del fondo
    for (int eje = 0; eje < 3; ++eje) {
        glm::vec3 fondo(0);
        fondo[eje] = F[eje] < 0 ? -1.0f : 1.0f;
        trazaAristas(eje, fondo, aRecortado);
        if (eje != 1)
            fugas.push_back(glm::vec3(ojo) + FONDO * fondo);
    }
    if (estado.enPerspectiva) {
        const glm::vec3 tramo = 3.0f * (fugas[1] - fugas[0]), horizonte = glm::mix(fugas[0], fugas[1], 0.6f);
        trazaSegmentos({fugas[0] - tramo, fugas[1] + tramo}, aRecortado, OSCURO, 9);
        glDisable(GL_DEPTH_TEST); // los puntos, delante de las rectas que llegan a ellos
        trazaPuntos(fugas, aRecortado, OSCURO, 30);
        glEnable(GL_DEPTH_TEST);
        for (const glm::vec3 &fuga : fugas)
            rotulaPunto("punto de fuga", fuga, aRecortado, OSCURO);
        rotulaPunto("horizonte", horizonte, aRecortado, OSCURO);
    }
    rotula(estado.enPerspectiva ? "perspectiva" : "paralela", {0.02f, 0.05f}, OSCURO, Lado::DERECHA);
    ponTitulo(estado.enPerspectiva ? "El cubo en perspectiva" : "El cubo en paralela");
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla != 'p')
        return;
    estado.enPerspectiva = !estado.enPerspectiva;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Perspectiva y paralela", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
