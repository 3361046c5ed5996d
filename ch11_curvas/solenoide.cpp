// Un solenoide (figura 11.1): una curva 3D hecha de una secuencia de segmentos cúbicos. Cada cuarto de vuelta es una
// curva de Hermite con los extremos de la hélice y tangentes en su dirección; a lo largo de ella se tiende un tubo.
// Controles: + - una vuelta más o menos · s de dos colores los segmentos · ratón orbita · Esc termina.
#include "solenoide.h"
#include "buferes.h"
#include "ch03_transformaciones/transformaciones.h"
#include "ch05_iluminacion/iluminacion.h"
#include "ch05_iluminacion/materiales.h"
#include "colores.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "ventana.h"

static const Material COBRE = {{0.22f, 0.09f, 0.04f}, {0.72f, 0.32f, 0.16f}, {0.60f, 0.45f, 0.35f}, 40},
                      ACERO = {{0.22f, 0.25f, 0.30f}, {0.50f, 0.58f, 0.66f}, {0.5f, 0.5f, 0.5f}, 40};
static const Luz LUZ{{-0.5f, 0.8f, 0.7f, 0}};
static const int VUELTAS_MINIMAS = 2, VUELTAS_MAXIMAS = 16;

static struct {
    GLuint programa;
    Buferes tubo[2], remate; // los segmentos pares y los impares, y una esfera en cada punta
    int vueltas = 7;
    bool segmentos = false;
    Orbita orbita = {0.45f, 0.38f, 10.4f};
} estado;

static void construye() {
    for (int i = 0; i < 2; ++i) {
        borraBuferes(estado.tubo[i]);
        estado.tubo[i] = creaBuferes(tuboSolenoide(estado.vueltas, i));
    }
}

static void inicia() {
    estado.programa = creaSombreado("phong");
    construye();
    estado.remate = creaBuferes(esfera(24));
    glEnable(GL_DEPTH_TEST);
    ponFondo(FONDO_OSCURO);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 camara = camaraOrbita(estado.orbita);
    usaIluminado(estado.programa, camara, perspectivaVentana(0.45f, 1, 100), LUZ);
    for (int i = 0; i < 2; ++i)
        dibujaIluminado(estado.programa, estado.tubo[i], glm::mat4(1), camara,
                        estado.segmentos && i == 1 ? ACERO : COBRE);
    const int ultimo = SEGMENTOS_VUELTA * estado.vueltas;
    for (const glm::vec3 &punta :
         {cubica(Base::HERMITE, segmentoSolenoide(estado.vueltas, 0), 0.0f),
          cubica(Base::HERMITE, segmentoSolenoide(estado.vueltas, ultimo - 1), 1.0f)})
        dibujaIluminado(estado.programa, estado.remate, traslacion(punta) * escalado(GRUESO_TUBO), camara,
                        COBRE);
    ponTitulo("Solenoide: " + std::to_string(estado.vueltas) + " vueltas, " + std::to_string(ultimo) +
              " segmentos cúbicos");
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    if (tecla == 's')
        estado.segmentos = !estado.segmentos;
    else if (tecla == '+' || tecla == '-')
        estado.vueltas =
            glm::clamp(estado.vueltas + (tecla == '+' ? 1 : -1), VUELTAS_MINIMAS, VUELTAS_MAXIMAS);
    construye();
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Solenoide", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
