// La grúa en paralela o en perspectiva, entera en las dos y sin tocar la matriz de la cámara (ejercicio 4.3): lo que
// cambia es solo el volumen de la vista. En perspectiva, cuanto más cerca esté la cámara más se abre el ángulo para que
// siga entera: con la rueda la grúa no cambia de tamaño, se deforma. Lo que se añade a grua_vistas está marcado.
// Controles: p paralela o perspectiva · 1 alzado · 2 planta · 3 perfil · 4 (1,1,1) · 0 las cuatro · u sistema · menú ·
// a d giran · q e desplazan la carga · w s la suben y bajan · ratón orbita la cuarta · Esc termina.
#include "buferes.h"
#include "camaras_grua.h"
#include "ch03_transformaciones/grua.h"
#include "ch03_transformaciones/objeto.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "malla.h"
#include "orbita.h"
#include "recuadro.h"
#include "shader.h"
#include "trazo.h"
#include "ventana.h"
#include "vistas_grua.h"

static const float CASILLA = LADO_SUELO / 5;
static const glm::mat4 EN_SUELO =
    traslacion({0, 0.02f, 0}) * giroX(glm::half_pi<float>()); // lo justo para que se vea

static struct {
    GLuint programa;
    Buferes cubo;
    std::vector<glm::dvec3> envolvente;
    PosturaGrua postura = {0.58f, 5, 4};
    VistasGrua vistas = {DIAGONAL};
    bool enPerspectiva = false; // nuevo en 4.3
} estado;

static void inicia() {
    estado.programa = creaProgramaObjeto();
    estado.cubo = creaBuferes(cubo());
    estado.envolvente = envolventeGrua();
    glEnable(GL_DEPTH_TEST); // el ejercicio 4.4
}

static void dibuja() {
    const char *const nombre = estado.enPerspectiva ? "perspectiva" : "paralela";
    abreRecuadro(ventanaEntera());
    ponFondo(GRIS);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(estado.programa);
    for (const PanelVista &p : reparteVistas(estado.vistas, estado.envolvente)) {
        abreRecuadro(p.panel);
        ponFondo(CIELO);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        abreRecuadro(p.escena);
        // E4.3: la proyección de cada vista, la que diga estado.enPerspectiva
        const glm::mat4 proyeccion( // nuevo en 4.3
            estado.enPerspectiva
                ? perspectivaQueEncierra(estado.envolvente, p.camara, p.escena)
                : paralelaQueEncierra(estado.envolvente, p.camara, p.escena, p.unidadesPorPixel));
        // de partida: const glm::mat4 proyeccion(proyeccionParalela(-14, 14, -14, 14, 1, 100));
        // fin de E4.3
        envia(estado.programa, "proyeccion", proyeccion);
        envia(estado.programa, "camara", glm::mat4(p.camara));
        for (const Pieza &pieza : escenaGrua(estado.postura))
            dibujaObjeto(estado.programa, estado.cubo, pieza.M, pieza.color);
        trazaSegmentos(cuadricula(LADO_SUELO, CASILLA), proyeccion * glm::mat4(p.camara) * EN_SUELO, OSCURO,
                       GROSOR / 2);
        rotulaVista(p, std::string(" ") + nombre);
    }
    ponTitulo(std::string("La grúa en ") + nombre);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    if (tecla == 'p') // nuevo en 4.3
        estado.enPerspectiva = !estado.enPerspectiva;
    else if (!mueve(estado.postura, tecla) && !eligeVista(estado.vistas, tecla))
        return;
    glutPostRedisplay();
}

static void eligeMenu(int tecla) {
    teclado(GLubyte(tecla), 0, 0);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "La grúa en paralela o en perspectiva",
                GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.vistas.orbita);
    glutCreateMenu(eligeMenu);
    glutAddMenuEntry("Paralela o perspectiva", 'p'); // nuevo en 4.3
    ponOpcionesVistas();
    glutAttachMenu(GLUT_RIGHT_BUTTON);
    glutMainLoop();
    return 0;
}
