// Banderas en una grada como sistema de partículas (figura 12.2): cada bandera es un cuadrado, que nace y muere en
// instantes al azar, como en mosaico, y mientras vive la agita una textura de ruido. Entre todas hacen un dibujo.
// Controles: espacio pausa · s adelanta medio segundo · d una décima · h diez horas · ratón orbita · Esc termina.
#include "animacion.h"
#include "buferes.h"
#include "buferes_piezas.h"
#include "ch03_transformaciones/objeto.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "imagen_ruido.h"
#include "malla.h"
#include "orbita.h"
#include "piezas.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "reloj.h"
#include "shader.h"
#include "textura.h"
#include "ventana.h"

static const int COLUMNAS = 26, FILAS = 12;
static const float SEPARACION = 1.0f;
static const glm::vec3 ASIENTO(0, 0.8f, -0.9f), COLOR_GRADA(0.66f, 0.68f, 0.72f);
static const glm::vec3 PALETA[] = {ROJO, AMARILLO, AZUL};

static struct {
    GLuint programa, programaObjeto;
    BuferPiezas piezas;
    Buferes cubo;
    Orbita orbita = {0.35f, 0.34f, 43, {0.4f, 3.9f, -4.5f}, 0.03f};
    Reloj reloj = {INICIO};
} estado;

static void dibujaGrada(const glm::mat4 &camara, const glm::mat4 &proyeccion) {
    usaPrograma(estado.programaObjeto, camara, proyeccion);
    for (int i = 0; i < FILAS; ++i) { // cada escalón, macizo hasta el suelo
        const float alto = ASIENTO.y * float(i + 1), z = ASIENTO.z * float(i);
        dibujaObjeto(estado.programaObjeto, estado.cubo,
                     traslacion({0, 0.5f * alto - ASIENTO.y, z}) *
                         escalado({COLUMNAS + 0.6f, alto, -ASIENTO.z}),
                     COLOR_GRADA);
    }
}

static void dibuja() {
    const float t = float(PERIODO_PIEZAS) * fase(tiempo(estado.reloj), PERIODO_PIEZAS);
    const glm::mat4 camara = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.5f, 1, 200);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    dibujaGrada(camara, proyeccion);
    usaPrograma(estado.programa, camara, proyeccion);
    envia(estado.programa, "talla", glm::vec2(COLUMNAS, FILAS));
    envia(estado.programa, "asiento", ASIENTO);
    envia(estado.programa, "separacion", SEPARACION);
    envia(estado.programa, "t", t);
    envia(estado.programa, "ruido", 0);
    for (int i = 0; i < 3; ++i)
        envia(estado.programa, ("paleta[" + std::to_string(i) + "]").c_str(), PALETA[i]);
    dibujaPiezas(estado.piezas);
    rotulaTiempo(estado.reloj, OSCURO, std::string(", ") + etapa(t));
    tituloAnimado(estado.reloj, "Banderas en una grada: " + std::string(etapa(t)));
    glutSwapBuffers();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Banderas en una grada", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    estado.programa = creaPrograma("ch12_animacion/banderas.vert", "ch12_animacion/banderas.frag");
    estado.programaObjeto = creaProgramaObjeto();
    estado.piezas = creaBuferPiezas(estado.programa, COLUMNAS, FILAS);
    estado.cubo = creaBuferes(cubo());
    glEnable(GL_DEPTH_TEST);
    creaTextura2D(imagenRuido());
    ponFondo(CIELO);
    glutDisplayFunc(dibuja);
    orbitaConRaton(estado.orbita);
    animaConReloj(estado.reloj);
    glutMainLoop();
    return 0;
}
