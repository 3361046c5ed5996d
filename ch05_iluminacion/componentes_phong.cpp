// Los tres componentes del modelo de Phong (figura 5.1): solo luz ambiente (ecuación 5.1), más reflexión
// difusa (5.2) y más reflexión especular (5.4). El shader es siempre el mismo: un componente se quita
// apagando su luz, Ld o Ls.
// Controles: 1 ambiente · 2 más difusa · 3 más especular · ratón orbita · Esc termina.
#include "ch03_transformaciones/transformaciones.h"
#include "iluminacion.h"
#include "malla.h"
#include "orbita.h"
#include "ventana.h"

static const Material ceramica = {{0.08f, 0.20f, 0.38f}, {0.14f, 0.36f, 0.62f}, {0.75f, 0.75f, 0.75f}, 30};
static const Material laton = {{0.42f, 0.23f, 0.05f}, {0.58f, 0.36f, 0.08f}, {0.60f, 0.55f, 0.45f}, 30};
static const glm::vec3 La(1);

static struct {
    GLuint programa;
    Buferes esfera, anillo;
    Orbita orbita = {0.0f, 0.0f, 10, {0, 0, 0}};
    int componentes = 3;
} estado;

static void inicia() {
    estado.programa =
        creaPrograma("ch05_iluminacion/sombreado_phong.vert", "ch05_iluminacion/sombreado_phong.frag");
    estado.esfera = creaBuferes(esfera(segmentosPara(250, 0.1f)));
    estado.anillo = creaBuferes(toro(1.55f, 0.22f, segmentosPara(400, 0.1f), segmentosPara(60, 0.1f)));
    glEnable(GL_DEPTH_TEST);
    glClearColor(0.16f, 0.17f, 0.20f, 1);
}

static void dibujaObjeto(const Buferes &objeto, const glm::mat4 &M, const Material &material) {
    const glm::mat3 N = matrizNormal(camaraOrbita(estado.orbita) * M);
    envia(estado.programa, "M", M);
    envia(estado.programa, "N", N);
    enviaMaterial(estado.programa, material);
    dibuja(objeto);
}

static void dibuja() {
    Luz luz{{-3.5f, 4, 6, 1}};
    luz.Ld = glm::vec3(estado.componentes >= 2 ? 1 : 0);
    luz.Ls = glm::vec3(estado.componentes >= 3 ? 1 : 0);

    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    const glm::mat4 vista = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.31f, 1, 100);
    envia(estado.programa, "vista", vista);
    envia(estado.programa, "proyeccion", proyeccion);
    envia(estado.programa, "La", La);
    enviaLuz(estado.programa, "luz", luz, vista);
    dibujaObjeto(estado.esfera, glm::mat4(1), ceramica);
    dibujaObjeto(estado.anillo, giroZ(0.35f) * giroX(-1.15f), laton);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla < '1' || tecla > '3')
        return;
    estado.componentes = tecla - '0';
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Componentes del modelo de Phong", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
