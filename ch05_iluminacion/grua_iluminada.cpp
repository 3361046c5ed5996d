// La grúa de obra con una fuente de luz y materiales (ejercicio 5.1). Con el sombreado de Gouraud las caras
// grandes, que solo tienen cuatro vértices, pierden los brillos y lo que la luz cambia dentro de ellas; con
// el de Phong, no.
// Controles: g Gouraud o Phong · a d giran · q e mueven la carga · w s la suben y bajan · ratón orbita · Esc termina.
#include "ch03_transformaciones/grua.h"
#include "iluminacion.h"
#include "malla.h"
#include "orbita.h"
#include "ventana.h"

static const float PASO_GIRO = 0.1f; // radianes
static const float PASO = 0.5f;
static const glm::vec3 La(1);
static const Luz luz{{3.5f, 8.5f, 5.5f, 1}};

static const Material pintura = {{0.25f, 0.18f, 0.03f}, {0.68f, 0.50f, 0.08f}, {0.60f, 0.60f, 0.60f}, 15};
static const Material hormigon = {{0.12f, 0.13f, 0.14f}, {0.45f, 0.47f, 0.50f}, {0.05f, 0.05f, 0.05f}, 5};
static const Material acero = {{0.06f, 0.06f, 0.07f}, {0.20f, 0.21f, 0.24f}, {0.70f, 0.70f, 0.70f}, 80};
static const Material chapa = {{0.22f, 0.05f, 0.05f}, {0.68f, 0.14f, 0.12f}, {0.60f, 0.60f, 0.60f}, 30};
static const Material terreno = {{0.13f, 0.17f, 0.12f}, {0.46f, 0.58f, 0.42f}, {0.25f, 0.25f, 0.25f}, 12};
static const Material MATERIALES[] = {pintura, pintura, hormigon, acero, chapa}; // como piezasGrua

static struct {
    GLuint gouraud, phong;
    Buferes cubo;
    PosturaGrua postura;
    Orbita orbita = {0.5f, 0.25f, 23, {1.5f, 5.2f, 0}};
    bool porFragmento = false;
} estado;

static GLuint programaActual() {
    return estado.porFragmento ? estado.phong : estado.gouraud;
}

static void inicia() {
    estado.gouraud =
        creaPrograma("ch05_iluminacion/sombreado_gouraud.vert", "ch05_iluminacion/sombreado_gouraud.frag");
    estado.phong =
        creaPrograma("ch05_iluminacion/sombreado_phong.vert", "ch05_iluminacion/sombreado_phong.frag");
    estado.cubo = creaBuferes(cubo());
    glEnable(GL_DEPTH_TEST);
    glClearColor(0.87f, 0.93f, 0.98f, 1);
}

static void dibujaCubo(const glm::mat4 &M, const Material &material) {
    const GLuint programa = programaActual();
    const glm::mat3 N = matrizNormal(camaraOrbita(estado.orbita) * M);
    envia(programa, "M", M);
    envia(programa, "N", N);
    enviaMaterial(programa, material);
    glDrawElements(GL_TRIANGLES, estado.cubo.nIndices, GL_UNSIGNED_INT, nullptr);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const GLuint programa = programaActual();
    glUseProgram(programa);
    const glm::mat4 vista = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.6f, 1, 100);
    envia(programa, "vista", vista);
    envia(programa, "proyeccion", proyeccion);
    envia(programa, "La", La);
    enviaLuz(programa, "luz", luz, vista);
    glBindVertexArray(estado.cubo.vao);
    dibujaCubo(traslacion({0, -0.1f, 0}) * escalado({20, 0.2f, 20}), terreno);
    int i = 0;
    for (const Pieza &pieza : piezasGrua(estado.postura))
        dibujaCubo(pieza.M, MATERIALES[i++]);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    PosturaGrua &p = estado.postura;
    switch (tecla) {
    case 'g': estado.porFragmento = !estado.porFragmento; break;
    case 'a': p.giro += PASO_GIRO; break;
    case 'd': p.giro -= PASO_GIRO; break;
    case 'q': p.distancia -= PASO; break;
    case 'e': p.distancia += PASO; break;
    case 'w': p.altura += PASO; break;
    case 's': p.altura -= PASO; break;
    default: return;
    }
    p = limita(p);
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Grúa iluminada", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
