// Un mosaico como sistema de partículas (figura 12.1): cada tesela es una partícula cuadrada que nace y muere en
// instantes al azar, y mientras vive la mueve una textura de ruido. Las teselas y sus atributos están en un buffer
// object que no cambia: el vertex shader decide, con el instante, si cada una aún no ha nacido, vive o ya ha muerto.
// Controles: espacio pausa · s adelanta medio segundo · d una décima · h diez horas · Esc termina.
#include "animacion.h"
#include "buferes_piezas.h"
#include "colores.h"
#include "imagen_ruido.h"
#include "piezas.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "reloj.h"
#include "shader.h"
#include "textura.h"
#include "ventana.h"

static const int COLUMNAS = 52, FILAS = 39;
static const float SEMIALTO = 1.28f; // el mosaico mide 2 de alto
static const glm::vec3 PALETA[] = {ROJO, AMARILLO, NARANJA, OSCURO, {0.30f, 0.55f, 0.78f}};

static struct {
    GLuint programa;
    BuferPiezas piezas;
    Reloj reloj = {INICIO};
} estado;

static void dibuja() {
    const float t = float(PERIODO_PIEZAS) * fase(tiempo(estado.reloj), PERIODO_PIEZAS);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(estado.programa);
    envia(estado.programa, "proyeccion", paralelaVentana(SEMIALTO));
    envia(estado.programa, "talla", glm::vec2(COLUMNAS, FILAS));
    envia(estado.programa, "t", t);
    envia(estado.programa, "ruido", 0);
    for (int i = 0; i < 5; ++i)
        envia(estado.programa, ("paleta[" + std::to_string(i) + "]").c_str(), PALETA[i]);
    dibujaPiezas(estado.piezas);
    rotulaTiempo(estado.reloj, OSCURO, std::string(", ") + etapa(t));
    tituloAnimado(estado.reloj, "Mosaico de partículas: " + std::string(etapa(t)));
    glutSwapBuffers();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Mosaico de partículas", GLUT_DOUBLE | GLUT_MULTISAMPLE);
    estado.programa = creaPrograma("ch12_animacion/mosaico.vert", "ch12_animacion/mosaico.frag");
    estado.piezas = creaBuferPiezas(estado.programa, COLUMNAS, FILAS);
    creaTextura2D(imagenRuido());
    ponFondo(FONDO_CLARO);
    glutDisplayFunc(dibuja);
    animaConReloj(estado.reloj);
    glutMainLoop();
    return 0;
}
