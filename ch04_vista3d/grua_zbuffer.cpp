// La grúa con eliminación de partes ocultas (ejercicio 4.4): hacen falta GLUT_DEPTH, GL_DEPTH_TEST y limpiar el buffer
// de profundidad antes de dibujar. Sin el test, lo que se pinta tapa lo pintado antes, esté delante o detrás; aquí se
// pinta de la carga al suelo para que se note. Lo que se añade a grua_proyeccion está marcado.
// Controles: z partes ocultas · v compara · p paralela o perspectiva · 1 2 3 4 vistas · 0 las cuatro · u sistema ·
// menú · a d giran · q e desplazan la carga · w s la suben y bajan · ratón orbita la cuarta · Esc termina.
#include "buferes.h"
#include "camaras_grua.h"
#include "ch03_transformaciones/grua.h"
#include "ch03_transformaciones/objeto.h"
#include "colores.h"
#include "malla.h"
#include "orbita.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "ventana.h"
#include "vistas_grua.h"

static struct {
    GLuint programa;
    Buferes cubo;
    std::vector<glm::dvec3> envolvente;
    PosturaGrua postura = {0.58f, 5, 4};
    VistasGrua vistas = {DIAGONAL};
    bool enPerspectiva = true, test = true, compara = false; // nuevo en 4.4: los dos últimos
} estado;

static void inicia() {
    estado.programa = creaProgramaObjeto();
    estado.cubo = creaBuferes(cubo());
    estado.envolvente = envolventeGrua();
}

static void dibujaVistas(const Recuadro &donde, bool test) {
    for (const PanelVista &p : reparteVistas(estado.vistas, estado.envolvente, donde)) {
        abreRecuadro(p.panel);
        ponFondo(CIELO);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        abreRecuadro(p.escena);
        const glm::mat4 proyeccion(
            estado.enPerspectiva
                ? perspectivaQueEncierra(estado.envolvente, p.camara, p.escena)
                : paralelaQueEncierra(estado.envolvente, p.camara, p.escena, p.unidadesPorPixel));
        envia(estado.programa, "proyeccion", proyeccion);
        envia(estado.programa, "camara", glm::mat4(p.camara));
        // E4.4: activa el test de profundidad, si se pide
        if (test) // nuevo en 4.4
            glEnable(GL_DEPTH_TEST);
        // fin de E4.4
        const std::vector<Pieza> piezas = escenaGrua(estado.postura);
        for (auto pieza = piezas.rbegin(); pieza != piezas.rend(); ++pieza)
            dibujaObjeto(estado.programa, estado.cubo, pieza->M, pieza->color);
        glDisable(GL_DEPTH_TEST);
        rotulaVista(p, test ? " con test" : " sin test");
    }
}

static void dibuja() {
    const Recuadro ventana = ventanaEntera();
    const std::string proyeccion = estado.enPerspectiva ? "en perspectiva" : "en paralela";
    abreRecuadro(ventana);
    ponFondo(GRIS);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(estado.programa);
    if (estado.compara) { // nuevo en 4.4
        const std::vector<Recuadro> mitades = reparte(2);
        dibujaVistas(mitades[0], false);
        dibujaVistas(mitades[1], true);
    } else {
        dibujaVistas(ventana, estado.test);
    }
    abreRecuadro(ventana);
    if (estado.vistas.elegido != LAS_CUATRO) // en las cuatro no hay sitio: la dice el título
        rotula(proyeccion, {0.98f, 0.05f}, OSCURO, Lado::IZQUIERDA, 0.03f);
    std::string que = estado.test ? "sin partes ocultas" : "con partes ocultas";
    if (estado.compara)
        que = "sin partes ocultas y con ellas";
    ponTitulo("La grúa " + que + ", " + proyeccion);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    if (tecla == 'p')
        estado.enPerspectiva = !estado.enPerspectiva;
    else if (tecla == 'z') { // nuevo en 4.4
        estado.test = !estado.test;
        estado.compara = false;
    } else if (tecla == 'v') // nuevo en 4.4
        estado.compara = !estado.compara;
    else if (!mueve(estado.postura, tecla) && !eligeVista(estado.vistas, tecla))
        return;
    glutPostRedisplay();
}

static void eligeMenu(int tecla) {
    teclado(GLubyte(tecla), 0, 0);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "La grúa sin partes ocultas", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.vistas.orbita);
    glutCreateMenu(eligeMenu);
    glutAddMenuEntry("Con o sin partes ocultas", 'z'); // nuevo en 4.4
    glutAddMenuEntry("Comparar", 'v');                 // nuevo en 4.4
    glutAddMenuEntry("Paralela o perspectiva", 'p');
    ponOpcionesVistas();
    glutAttachMenu(GLUT_RIGHT_BUTTON);
    glutMainLoop();
    return 0;
}
