// Seis escalados de una F (ejercicio 3.1). Arriba: uniforme, no uniforme y un factor cero; abajo: un factor negativo, dos
// negativos y factores entre 0 y 1. En gris, la F sin escalar. Amarillo es el lado de fuera de las caras y morado el de
// dentro: con un factor negativo la F es su imagen en un espejo y sus caras giran al revés; con dos (determinante
// positivo) es la F girada media vuelta.
// Controles: ratón orbita · Esc termina.
#include "ejes.h"
#include "letra_f.h"
#include "orbita.h"
#include "recuadro.h"
#include "shader.h"
#include "transformaciones.h"
#include "ventana.h"
#include <cstdio>

static const glm::vec3 FACTORES[6] = {{1.4f, 1.4f, 1.4f}, {1.8f, 0.6f, 1}, {1, 1, 0},
                                      {-1, 1, 1},         {-1, -1, 1},     {0.5f, 0.5f, 0.5f}};
static const float ATENUADO = 0.35f; // de las aristas que quedan ocultas

static struct {
    GLuint programa;
    Buferes letra;
    Orbita orbita = {0.55f, 0.3f, 10};
} estado;

static void inicia() {
    estado.programa =
        creaPrograma("ch03_transformaciones/objeto.vert", "ch03_transformaciones/escalado.frag");
    estado.letra = creaBuferes(letraF());
    glEnable(GL_DEPTH_TEST);
}

static void dibujaVista(const Recuadro &r, const glm::vec3 &s) {
    abreRecuadro(r, FONDO_CLARO);
    // Cada vista se centra en lo que abarcan la F y su escalada; la escala es la misma en todas.
    Orbita orbita = estado.orbita;
    orbita.centro = 0.5f * (glm::min(MINIMO_F, glm::min(s * MINIMO_F, s * MAXIMO_F)) +
                            glm::max(MAXIMO_F, glm::max(s * MINIMO_F, s * MAXIMO_F)));
    const glm::mat4 camara = camaraOrbita(orbita), M = escalado(s);
    const glm::mat4 proyeccion = perspectivaVentana(0.32f, 1, 100, aspecto(r));
    glDisable(GL_DEPTH_TEST); // lo oculto del original, tenue
    trazaSegmentos(aristasF(), proyeccion * camara, glm::mix(FONDO_CLARO, GRIS, ATENUADO), 3);
    glEnable(GL_DEPTH_TEST);

    glUseProgram(estado.programa);
    envia(estado.programa, "proyeccion", proyeccion);
    envia(estado.programa, "camara", camara);
    envia(estado.programa, "M", M);
    envia(estado.programa, "N", matrizNormal(M));
    envia(estado.programa, "colorFuera", AMARILLO);
    envia(estado.programa, "colorDentro", MORADO);
    // Con un factor cero la cara de delante y la de atrás coinciden: se descartan las que miran hacia atrás,
    // porque la profundidad no puede decidir entre dos iguales.
    if (s.x * s.y * s.z == 0)
        glEnable(GL_CULL_FACE);
    dibuja(estado.letra);
    glDisable(GL_CULL_FACE);
    trazaSegmentos(aristasF(), proyeccion * camara, GRIS, 3);
    trazaEjes(proyeccion * camara, {1.8f, 1.8f, 1.0f}, 4);
    char texto[64];
    std::snprintf(texto, sizeof texto, "S(%g, %g, %g)", static_cast<double>(s.x), static_cast<double>(s.y),
                  static_cast<double>(s.z));
    rotula(texto, {0.5f, 0.93f}, OSCURO);
}

static void dibuja() {
    abreRecuadro(ventanaEntera(), GRIS);
    const std::vector<Recuadro> paneles = reparte(6);
    for (std::size_t i = 0; i < paneles.size(); ++i)
        dibujaVista(paneles[i], FACTORES[i]);
    glutSwapBuffers();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Seis escalados", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
