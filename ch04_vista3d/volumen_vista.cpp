// El volumen de la vista visto desde fuera (figuras 4.3 y 4.4): la pirámide truncada de la perspectiva o la caja de
// la paralela, entre el plano cerca (naranja) y el plano lejos (azul). Solo lo que está dentro conserva su color:
// el fragment shader comprueba la condición del recortado, −w ≤ x, y, z ≤ w.
// Controles: p cambia de proyección · + - mueven el plano lejos · ratón orbita · Esc termina.
#include "malla.h"
#include "orbita.h"
#include "piezas.h"
#include "shader.h"
#include "ventana.h"
#include "volumen.h"

static const double THETA = 0.52, ASPECTO = 4.0 / 3, ALTO = 1.7; // radianes; medio alto de la caja
static const double CERCA = 2.5, PASO = 0.5, LEJOS_MINIMO = 3.5, LEJOS_MAXIMO = 14;
static const glm::dvec3 ojo(0, 2.5, 6.5), interes(0, 2.5, 0);

static const glm::vec3 rojo(0.85f, 0.20f, 0.18f), verde(0.20f, 0.62f, 0.28f), azul(0.16f, 0.38f, 0.80f),
    naranja(0.95f, 0.55f, 0.10f), amarillo(0.98f, 0.78f, 0.15f), morado(0.55f, 0.30f, 0.70f),
    oscuro(0.16f, 0.17f, 0.20f), gris(0.55f, 0.58f, 0.62f), suelo(0.60f, 0.80f, 0.58f);

static struct {
    GLuint deObjetos, deEscena, deTintes;
    Buferes cubo, cilindro, cono, esfera, plano;
    bool enPerspectiva = true;
    double lejos = 9;
    Orbita orbita = {0.95f, 0.38f, 17.5f, {0, 2.2f, 1.5f}};
} estado;

static void inicia() {
    estado.deObjetos = creaPrograma("ch03_transformaciones/objeto.vert", "ch03_transformaciones/objeto.frag");
    estado.deEscena = creaPrograma("ch04_vista3d/volumen_vista.vert", "ch04_vista3d/volumen_vista.frag");
    estado.deTintes = creaPrograma("ch04_vista3d/linea.vert", "ch04_vista3d/linea.frag");
    estado.cubo = creaBuferes(cubo());
    estado.cilindro = creaBuferes(cilindro(24));
    estado.cono = creaBuferes(cono(48));
    estado.esfera = creaBuferes(esfera(48));
    estado.plano = creaBuferes(plano(1));
    glEnable(GL_DEPTH_TEST);
    glClearColor(0.95f, 0.96f, 0.98f, 1);
}

static void dibujaMalla(GLuint programa, const Buferes &malla, const glm::mat4 &M, const glm::vec3 &color) {
    const glm::mat3 N = matrizNormal(M);
    envia(programa, "M", M);
    envia(programa, "N", N);
    envia(programa, "colorObjeto", color);
    dibuja(malla);
}

static void dibujaEscena(const glm::mat4 &camara, const glm::mat4 &volumen) {
    const GLuint p = estado.deEscena;
    const glm::mat4 dePie = giroX(-1.5708f); // los conos, con el vértice arriba
    glUseProgram(p);
    envia(p, "camara", camara);
    envia(p, "volumen", volumen);
    dibujaMalla(p, estado.cubo, traslacion({0, -0.1f, 0.5f}) * escalado({9, 0.2f, 12}), suelo);
    dibujaMalla(p, estado.esfera, traslacion({-0.7f, 2.5f, 2.3f}) * escalado(0.6f), rojo);
    dibujaMalla(p, estado.cono, traslacion({1.2f, 0, 0.2f}) * dePie * escalado({0.9f, 0.9f, 3.8f}), verde);
    dibujaMalla(p, estado.cubo, traslacion({-2.3f, 1.5f, -0.4f}) * escalado({1.4f, 3, 1.4f}), amarillo);
    dibujaMalla(p, estado.esfera, traslacion({0.5f, 1.8f, -2.7f}) * escalado(1.5f), morado);
    dibujaMalla(p, estado.cubo, traslacion({1.9f, 0.5f, 5.7f}), azul);
    dibujaMalla(p, estado.cono, traslacion({-3.0f, 0, 3.2f}) * dePie * escalado({0.8f, 0.8f, 2.4f}), naranja);
}

static void dibujaVolumen(const glm::mat4 &camara, const Esquinas &esquinas, const glm::dmat4 &alMundo) {
    const GLuint p = estado.deObjetos;
    glUseProgram(p);
    envia(p, "camara", camara);
    for (const PiezaCamara &pieza : piezasCamara())
        dibujaMalla(p, pieza.esRedonda ? estado.cilindro : estado.cubo, glm::mat4(alMundo) * pieza.M,
                    pieza.color);
    std::array<glm::vec3, 8> e;
    for (std::size_t k = 0; k < 8; ++k)
        e[k] = alMundo * glm::dvec4(esquinas[k], 1);
    for (std::size_t k = 0; k < 8; ++k) {
        const glm::vec3 &siguiente = e[k % 4 == 3 ? k - 3 : k + 1], &color = k < 4 ? naranja : azul;
        dibujaMalla(p, estado.cilindro, segmento(e[k], siguiente, 0.06f), color);
        dibujaMalla(p, estado.esfera, traslacion(e[k]) * escalado(0.1f), color);
    }
    for (std::size_t k = 0; k < 4; ++k) {
        dibujaMalla(p, estado.cilindro, segmento(e[k], e[k + 4], 0.05f), oscuro);
        if (estado.enPerspectiva)
            dibujaMalla(p, estado.cilindro, segmento(ojo, e[k], 0.02f), gris);
    }
}

// Los dos planos, translúcidos: el cuadrado de lado 1 llevado a la esquina 0 con los lados que salen de ella.
static void dibujaTintes(const glm::mat4 &camara, const Esquinas &e, const glm::dmat4 &alMundo) {
    const GLuint p = estado.deTintes;
    glUseProgram(p);
    glEnable(GL_BLEND);
    glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    glBlendColor(0, 0, 0, 0.35f);
    glDepthMask(GL_FALSE);
    glBindVertexArray(estado.plano.vao);
    // primero el más lejano a quien mira
    const bool porDelante = posicionCamara(estado.orbita).z < ojo.z - (CERCA + estado.lejos) / 2;
    for (const std::size_t base : {porDelante ? 0u : 4u, porDelante ? 4u : 0u}) {
        const glm::dvec3 x = e[base + 1] - e[base], y = e[base + 3] - e[base];
        const glm::mat4 M = glm::dmat4(camara) * alMundo *
                            glm::dmat4(glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(0, 0, 1, 0),
                                       glm::dvec4(e[base] + 0.5 * (x + y), 1));
        envia(p, "camara", M);
        envia(p, "colorObjeto", base ? azul : naranja);
        glDrawElements(GL_TRIANGLES, estado.plano.nIndices, GL_UNSIGNED_INT, nullptr);
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const double x = ASPECTO * ALTO;
    const glm::dmat4 vista = transformacionCamara(ojo, interes, {0, 1, 0}), alMundo = glm::inverse(vista);
    const glm::dmat4 proyeccion = estado.enPerspectiva
                                      ? proyeccionPerspectiva(THETA, ASPECTO, CERCA, estado.lejos)
                                      : proyeccionParalela(-x, x, -ALTO, ALTO, CERCA, estado.lejos);
    const Esquinas esquinas = estado.enPerspectiva
                                  ? esquinasPerspectiva(THETA, ASPECTO, CERCA, estado.lejos)
                                  : esquinasParalela(-x, x, -ALTO, ALTO, CERCA, estado.lejos);
    const glm::mat4 camara = perspectivaVentana(0.55f, 1, 100) * camaraOrbita(estado.orbita);
    dibujaEscena(camara, proyeccion * vista);
    dibujaVolumen(camara, esquinas, alMundo);
    dibujaTintes(camara, esquinas, alMundo);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    switch (tecla) {
    case 'p': estado.enPerspectiva = !estado.enPerspectiva; break;
    case '+': estado.lejos = std::min(estado.lejos + PASO, LEJOS_MAXIMO); break;
    case '-': estado.lejos = std::max(estado.lejos - PASO, LEJOS_MINIMO); break;
    default: return;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "El volumen de la vista", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
