// Un menú desplegable con un submenú (listado 10.1, figura 10.1): la grúa en perspectiva o en una de las tres vistas
// paralelas (ch04_vista3d/vistas_grua.h). Elegir una opción es recibir su número, que se escribe en stdout. El listado
// crea antes el submenú y no necesita glutSetMenu; aquí, al revés, hace falta para volver al principal.
// Controles: botón derecho abre el menú · 1 perspectiva · 2 alzado · 3 planta · 4 perfil · 0 termina ·
// ratón orbita la perspectiva · rueda la exagera o la suaviza, siempre con la grúa entera · Esc termina.
#include "buferes.h"
#include "ch03_transformaciones/grua.h"
#include "ch03_transformaciones/objeto.h"
#include "ch04_vista3d/camaras_grua.h"
#include "ch04_vista3d/vistas_grua.h"
#include "colores.h"
#include "malla.h"
#include "orbita.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "ventana.h"
#include <cstdio>

enum Opcion { SALIR, PERSPECTIVA, PARALELA_ALZADO, PARALELA_PLANTA, PARALELA_PERFIL, N_OPCIONES };
static const int VISTA_DE[N_OPCIONES] = {DIAGONAL, DIAGONAL, ALZADO, PLANTA, PERFIL};

static struct {
    GLuint programa;
    Buferes cubo;
    std::vector<glm::dvec3> envolvente;
    VistasGrua vistas;
} estado;

static void inicia() {
    estado.programa = creaProgramaObjeto();
    estado.cubo = creaBuferes(cubo());
    estado.envolvente = envolventeGrua();
    estado.vistas.elegido = DIAGONAL;
    glEnable(GL_DEPTH_TEST);
}

static void dibuja() {
    abreRecuadro(ventanaEntera());
    ponFondo(CIELO);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(estado.programa);
    const bool enPerspectiva = estado.vistas.elegido == DIAGONAL;
    for (const PanelVista &p : reparteVistas(estado.vistas, estado.envolvente)) { // uno, o ninguno si no cabe
        abreRecuadro(p.panel);
        ponFondo(CIELO);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        abreRecuadro(p.escena);
        envia(estado.programa, "proyeccion",
              glm::mat4(enPerspectiva ? perspectivaQueEncierra(estado.envolvente, p.camara, p.escena)
                                      : paralelaQueEncierra(estado.envolvente, p.camara, p.escena,
                                                            p.unidadesPorPixel)));
        envia(estado.programa, "camara", glm::mat4(p.camara));
        for (const Pieza &pieza : escenaGrua({0.58f, 5, 4}))
            dibujaObjeto(estado.programa, estado.cubo, pieza.M, pieza.color);
        rotulaVista(p);
        abreRecuadro(p.panel);
        rotula("menú → " + (enPerspectiva
                                ? "Perspectiva"
                                : std::string("Paralela → ") + VISTAS[estado.vistas.elegido].nombre),
               {0.98f, 0.94f}, OSCURO, Lado::IZQUIERDA, 0.03f);
    }
    ponTitulo(std::string("Menú: ") + (enPerspectiva ? "Perspectiva" : VISTAS[estado.vistas.elegido].nombre));
    glutSwapBuffers();
}

// Lo llama GLUT con el número de la opción, sea del menú o del submenú.
static void menu(int opcion) {
    std::printf("opción %d\n", opcion);
    std::fflush(stdout);
    if (opcion == SALIR) {
        glutLeaveMainLoop();
        return;
    }
    estado.vistas.elegido = VISTA_DE[opcion];
    glutPostRedisplay();
}

static void teclado(unsigned char tecla, int, int) {
    if (!teclaComun(tecla) && tecla >= '0' && tecla < '0' + N_OPCIONES)
        menu(tecla - '0');
}

static void creaMenu() {
    const int principal = glutCreateMenu(menu);
    glutAddMenuEntry("Perspectiva", PERSPECTIVA);
    const int paralela = glutCreateMenu(menu); // ahora el actual es este: las opciones que siguen son suyas
    for (int opcion = PARALELA_ALZADO; opcion < N_OPCIONES; ++opcion)
        glutAddMenuEntry(VISTAS[VISTA_DE[opcion]].nombre, opcion);
    glutSetMenu(principal);
    glutAddSubMenu("Paralela", paralela);
    glutAddMenuEntry("Salir", SALIR);
    glutAttachMenu(GLUT_RIGHT_BUTTON);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Menú", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.vistas.orbita);
    creaMenu();
    glutMainLoop();
    return 0;
}
