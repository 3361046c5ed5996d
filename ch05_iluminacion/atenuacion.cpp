// La atenuación de la luz con la distancia d a la fuente, 1/(a + b·d + c·d²) (ecuación 5.3), sobre filas de
// esferas que se alejan de ella: constante (a), lineal (b) y cuadrática (c). Con estos coeficientes las tres
// valen 1 a distancia 3: más cerca alumbra más la cuadrática y más lejos, la constante.
// Controles: 1 constante · 2 lineal · 3 cuadrática · ratón orbita · Esc termina.
#include "ch03_transformaciones/transformaciones.h"
#include "iluminacion.h"
#include "malla.h"
#include "orbita.h"
#include "ventana.h"

static const float RECTO = 1.57079633f; // radianes
static const int COLUMNAS = 5, FILAS = 3;
static const glm::vec3 La(1), POSICION(-5.0f, 2.4f, 3.6f);
static const glm::vec3 COEFICIENTES[] = {
    {1, 0, 0}, {0, 1 / 3.0f, 0}, {0, 0, 1 / 9.0f}}; // a, b, c de cada tecla

static const Material suelo = {{0.05f, 0.05f, 0.06f}, {0.55f, 0.57f, 0.60f}, {0, 0, 0}, 1};
static const Material bola = {{0.06f, 0.035f, 0.01f}, {0.90f, 0.50f, 0.12f}, {0.45f, 0.45f, 0.45f}, 40};
static const Material encendido = {{1.00f, 0.93f, 0.60f}, {0, 0, 0}, {0, 0, 0}, 1}; // la propia fuente

static struct {
    GLuint programa;
    Buferes plano, esfera;
    Orbita orbita = {0, 0.72f, 25.5f, {-0.2f, 0.2f, 0}};
    int modo = 0;
} estado;

static void inicia() {
    estado.programa =
        creaPrograma("ch05_iluminacion/sombreado_phong.vert", "ch05_iluminacion/sombreado_phong.frag");
    estado.plano = creaBuferes(plano(1));
    estado.esfera = creaBuferes(esfera(segmentosPara(60, 0.05f)));
    glEnable(GL_DEPTH_TEST);
    glClearColor(0.10f, 0.11f, 0.13f, 1);
}

static void dibujaObjeto(const Buferes &objeto, const glm::mat4 &M, const Material &material) {
    const glm::mat3 N = matrizNormal(camaraOrbita(estado.orbita) * M);
    envia(estado.programa, "M", M);
    envia(estado.programa, "N", N);
    enviaMaterial(estado.programa, material);
    dibuja(objeto);
}

static void dibuja() {
    Luz luz{glm::vec4(POSICION, 1)};
    luz.atenuacion = COEFICIENTES[estado.modo];

    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    const glm::mat4 vista = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.36f, 1, 100);
    envia(estado.programa, "vista", vista);
    envia(estado.programa, "proyeccion", proyeccion);
    envia(estado.programa, "La", La);
    enviaLuz(estado.programa, "luz", luz, vista);
    dibujaObjeto(estado.plano, giroX(-RECTO) * escalado({12.5f, 9, 1}), suelo);
    dibujaObjeto(estado.esfera, traslacion(POSICION) * escalado(0.25f), encendido);
    for (int i = 0; i < COLUMNAS; ++i)
        for (int j = 0; j < FILAS; ++j) {
            const glm::vec3 centro(2.2f * static_cast<float>(i) - 4, 0.8f, 2.2f * static_cast<float>(j) - 3);
            dibujaObjeto(estado.esfera, traslacion(centro) * escalado(0.8f), bola);
        }
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla < '1' || tecla > '3')
        return;
    estado.modo = tecla - '1';
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Atenuación con la distancia", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
