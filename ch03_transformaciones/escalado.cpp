// Seis escalados de una F (ejercicio 3.1). Arriba: uniforme, no uniforme y un factor cero; abajo: un factor
// negativo, dos negativos y factores entre 0 y 1. En líneas, la F sin escalar. Amarillo es el lado de fuera
// de las caras y morado el de dentro: con un factor negativo la F es su imagen en un espejo y sus caras giran
// al revés; con dos (determinante positivo) es la F girada media vuelta.
// Controles: ratón orbita · Esc termina.
#include "buferes.h"
#include "colores.h"
#include "dibujos.h"
#include "letra_f.h"
#include "orbita.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "transformaciones.h"
#include "ventana.h"
#include <glm/gtc/matrix_transform.hpp>

static const struct Escalado {
    glm::vec3 factores;
    const char *nombre, *clase;
} ESCALADOS[] = {
    {{2, 2, 2}, "S(2,2,2)", "uniforme"},          {{2, 0.5f, 1}, "S(2,0.5,1)", "no uniforme"},
    {{1, 1, 0}, "S(1,1,0)", "uno nulo"},          {{-1, 1, 1}, "S(−1,1,1)", "uno negativo"},
    {{-1, -1, 1}, "S(−1,−1,1)", "dos negativos"}, {glm::vec3(0.5f), "S(0.5,0.5,0.5)", "menores que 1"}};

static const float ASPECTO_ESCENA = 0.92f, SEMIALTO = 0.236f; // a distancia 1 del ojo
static const float TALLA = 0.031f;                            // de los rótulos

static struct {
    GLuint programa;
    Buferes letra;
    Orbita orbita = {0.55f, 0.25f, 10};
} estado;

static void inicia() {
    estado.programa =
        creaPrograma("ch03_transformaciones/objeto.vert", "ch03_transformaciones/escalado.frag");
    estado.letra = creaBuferes(letraF());
    glEnable(GL_DEPTH_TEST);
}

static void dibujaVista(const Escalado &caso, const Recuadro &r) {
    const glm::vec3 &s = caso.factores;
    // Cada vista se centra en lo que abarcan la F y su escalada; la escala es la misma en todas.
    Orbita orbita = estado.orbita;
    orbita.centro = 0.5f * (glm::min(MINIMO_F, glm::min(s * MINIMO_F, s * MAXIMO_F)) +
                            glm::max(MAXIMO_F, glm::max(s * MINIMO_F, s * MAXIMO_F)));
    orbita.centro.y -= 0.45f; // debajo van los rótulos
    // vistas más altas que anchas: en perspectivaVentana, que es para 4:3, se quedarían pequeñas
    const float semialto = SEMIALTO * std::max(ASPECTO_ESCENA / aspecto(r), 1.0f);
    const glm::mat4 proyeccion = glm::perspective(2 * std::atan(semialto), aspecto(r), 1.0f, 100.0f),
                    camara = camaraOrbita(orbita);
    const glm::mat4 transformacion = proyeccion * camara;
    // E3.1: el escalado de factores s, y cómo cambia la normal con él
    const glm::mat4 M = escalado(s);
    const glm::mat3 N = matrizNormal(M);
    // de partida: const glm::mat4 M(1);
    // de partida: const glm::mat3 N(1);
    // fin de E3.1
    abreRecuadro(r);
    ponFondo(FONDO_CLARO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    envia(estado.programa, "proyeccion", proyeccion);
    envia(estado.programa, "camara", camara);
    envia(estado.programa, "M", M);
    envia(estado.programa, "N", N);
    envia(estado.programa, "colorFuera", AMARILLO);
    envia(estado.programa, "colorDentro", MORADO);
    // Con un factor cero la cara de delante y la de atrás coinciden: se descartan las que miran hacia atrás,
    // porque la profundidad no puede decidir entre dos iguales.
    if (s.x * s.y * s.z == 0)
        glEnable(GL_CULL_FACE);
    dibujaMalla(estado.letra);
    glDisable(GL_CULL_FACE);
    trazaOriginal(aristasF(), transformacion);
    trazaEjes({1.6f, 1.8f, 0.9f}, transformacion);
    rotula(caso.nombre, {0.5f, 0.17f}, OSCURO, Lado::CENTRO, TALLA);
    rotula(caso.clase, {0.5f, 0.05f}, OSCURO, Lado::CENTRO, TALLA);
}

static void dibuja() {
    abreRecuadro(ventanaEntera()); // las rayas que separan las vistas
    ponFondo(GRIS);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(estado.programa);
    const std::vector<Recuadro> paneles = reparte(6, ASPECTO_ESCENA);
    for (std::size_t i = 0; i < paneles.size(); ++i)
        dibujaVista(ESCALADOS[i], paneles[i]);
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
