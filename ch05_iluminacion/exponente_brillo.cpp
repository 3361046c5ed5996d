// El exponente del brillo en la reflexión especular (ecuación 5.4, figura 5.3): cinco esferas iguales, del mismo
// material, con α de 1 a 500. Cuanto mayor es α, más pequeño es el brillo.
// Controles: ratón orbita · rueda acerca · Esc termina.
#include "buferes.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "iluminacion.h"
#include "malla.h"
#include "materiales.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "ventana.h"

static const struct {
    glm::vec3 centro;
    float alfa;
} ESFERAS[] = {{{-2.3f, 1.25f, 0}, 1},
               {{0, 1.25f, 0}, 5},
               {{2.3f, 1.25f, 0}, 20},
               {{-1.15f, -1.25f, 0}, 100},
               {{1.15f, -1.25f, 0}, 500}};
static const float RADIO = 1.12f;
static const Material ESMALTE = {{0.09f, 0.02f, 0.03f}, {0.44f, 0.07f, 0.10f}, {0.85f, 0.85f, 0.85f}, 1};
static const Luz LUZ{{-0.45f, 0.60f, 1, 0}}; // en el infinito: el brillo cae en el mismo sitio de cada esfera

static struct {
    GLuint programa;
    Buferes esfera;
    Orbita orbita = {0, 0, 17, {0, 0, 0}};
} estado;

static void inicia() {
    estado.programa = creaSombreado("phong");
    estado.esfera = creaBuferes(esfera(segmentosEsfera(200)));
    glEnable(GL_DEPTH_TEST);
    ponFondo(FONDO_OSCURO);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 camara = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.31f, 1, 100);
    usaIluminado(estado.programa, camara, proyeccion, LUZ);
    for (const auto &e : ESFERAS) {
        Material material = ESMALTE;
        material.alfa = e.alfa;
        dibujaIluminado(estado.programa, estado.esfera, traslacion(e.centro) * escalado(RADIO), camara,
                        material);
        rotulaPunto("α = " + std::to_string(int(e.alfa)), e.centro - glm::vec3(0, 0.7f * RADIO, 0),
                    proyeccion * camara, BLANCO, Lado::CENTRO);
    }
    glutSwapBuffers();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Exponente del brillo", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
