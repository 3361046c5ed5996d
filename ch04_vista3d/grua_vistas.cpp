// Cuatro vistas de la grúa en proyección paralela (ejercicio 4.2): alzado, planta, perfil y dirección (1,1,1). El
// volumen de la vista encierra la grúa en todas sus posturas y las cuatro tienen la misma escala, como en un plano
// (vistas_grua.h): por eso las líneas de referencia, que pasan por la carga, van rectas de una vista a otra.
// Controles: 1 alzado · 2 planta · 3 perfil · 4 (1,1,1) · 0 las cuatro · u sistema europeo o americano · menú ·
// a d giran · q e desplazan la carga · w s la suben y bajan · ratón orbita la cuarta · Esc termina.
#include "buferes.h"
#include "camaras_grua.h"
#include "ch03_transformaciones/grua.h"
#include "ch03_transformaciones/objeto.h"
#include "colores.h"
#include "malla.h"
#include "orbita.h"
#include "recuadro.h"
#include "shader.h"
#include "trazo.h"
#include "ventana.h"
#include "vistas_grua.h"

static struct {
    GLuint programa;
    Buferes cubo;
    std::vector<glm::dvec3> envolvente;
    PosturaGrua postura = {0.58f, 5, 4};
    VistasGrua vistas = {LAS_CUATRO, true}; // el europeo, el de aquí, al empezar
} estado;

static void inicia() {
    estado.programa = creaProgramaObjeto();
    estado.cubo = creaBuferes(cubo());
    estado.envolvente = envolventeGrua();
    glEnable(GL_DEPTH_TEST); // el ejercicio 4.4
}

static glm::dmat4 proyeccionEn(const PanelVista &p) {
    return paralelaQueEncierra(estado.envolvente, p.camara, p.escena, p.unidadesPorPixel);
}

// El alzado y la planta comparten la X de cada cosa; el alzado y el perfil, su altura.
static void trazaReferencias(const std::vector<PanelVista> &paneles) {
    const glm::dvec4 centroCarga(piezasGrua(estado.postura).back().M[3]);
    const Recuadro v = ventanaEntera();
    glm::vec3 carga[N_VISTAS]; // en coordenadas normalizadas de la ventana
    for (const PanelVista &p : paneles) {
        const glm::dvec2 enPanel = 0.5 + 0.5 * glm::dvec2(proyeccionEn(p) * p.camara * centroCarga);
        const glm::dvec2 enVentana =
            glm::dvec2(p.escena.x, p.escena.y) + enPanel * glm::dvec2(p.escena.ancho, p.escena.alto);
        carga[p.vista] = glm::vec3(2.0 * enVentana / glm::dvec2(v.ancho, v.alto) - 1.0, 0);
    }
    abreRecuadro(v);
    glClear(GL_DEPTH_BUFFER_BIT); // delante de todo
    trazaSegmentos({carga[ALZADO], carga[PLANTA], carga[ALZADO], carga[PERFIL]}, glm::mat4(1), MORADO);
}

static void dibuja() {
    abreRecuadro(ventanaEntera());
    ponFondo(GRIS);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(estado.programa);
    const std::vector<PanelVista> paneles = reparteVistas(estado.vistas, estado.envolvente);
    for (const PanelVista &p : paneles) {
        abreRecuadro(p.panel);
        ponFondo(CIELO);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        abreRecuadro(p.escena);
        envia(estado.programa, "proyeccion", glm::mat4(proyeccionEn(p)));
        envia(estado.programa, "camara", glm::mat4(p.camara));
        for (const Pieza &pieza : escenaGrua(estado.postura))
            dibujaObjeto(estado.programa, estado.cubo, pieza.M, pieza.color);
        rotulaVista(p);
    }
    if (paneles.size() == N_VISTAS)
        trazaReferencias(paneles);
    ponTitulo(std::string("Cuatro vistas de la grúa: sistema ") +
              (estado.vistas.europeo ? "europeo" : "americano"));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (!teclaComun(tecla) && (mueve(estado.postura, tecla) || eligeVista(estado.vistas, tecla)))
        glutPostRedisplay();
}

static void eligeMenu(int tecla) {
    teclado(GLubyte(tecla), 0, 0);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Cuatro vistas de la grúa", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.vistas.orbita);
    glutCreateMenu(eligeMenu);
    ponOpcionesVistas();
    glutAttachMenu(GLUT_RIGHT_BUTTON);
    glutMainLoop();
    return 0;
}
