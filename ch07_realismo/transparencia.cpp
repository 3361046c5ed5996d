// Un cilindro transparente (listado 7.1, ecuación 7.1, figura 7.1): primero lo opaco y después lo transparente,
// mezclado con lo que hay y sin escribir su profundidad. El cilindro se ve también por dentro: antes sus caras de
// detrás y luego las de delante, para que la mezcla vaya de atrás adelante.
// Controles: + - opacidad · 1 2 3 4 la ponen a 0.1, 0.4, 0.7 y 1 · v las cuatro a la vez · ratón orbita · Esc termina.
#include "buferes.h"
#include "ch03_transformaciones/transformaciones.h"
#include "ch05_iluminacion/iluminacion.h"
#include "ch05_iluminacion/materiales.h"
#include "colores.h"
#include "malla.h"
#include "modos.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "texto.h"
#include "ventana.h"
#include <algorithm>
#include <glm/gtc/constants.hpp>

static const float ALFAS[4] = {0.1f, 0.4f, 0.7f, 1}, PASO = 0.1f;
static const float RADIO_PX = 250; // del cilindro, en una pantalla de 1080 líneas
static const Luz luz{{4, 7, 6, 1}};
static const Material VIDRIO = {{0.10f, 0.28f, 0.42f}, {0.15f, 0.50f, 0.75f}, {0.9f, 0.9f, 0.9f}, 60};

static Material pintura(const glm::vec3 &color) {
    return {0.35f * color, 0.75f * color, glm::vec3(0.2f), 20};
}

static struct {
    GLuint programa;
    Buferes cubo, esfera, cilindro;
    float alfa = ALFAS[1];
    bool compara = false;
    Orbita orbita = {0.35f, 0.30f, 9.2f, {0, 0.95f, 0}, 0.02f};
} estado;

static void inicia() {
    estado.programa =
        creaPrograma("ch05_iluminacion/sombreado_phong.vert", "ch07_realismo/transparente.frag");
    estado.cubo = creaBuferes(cubo());
    estado.esfera = creaBuferes(esfera(48));
    estado.cilindro = creaBuferes(cilindro(segmentosPara(RADIO_PX)));
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
}

static void dibujaOpacos(const glm::mat4 &camara) {
    const GLuint p = estado.programa;
    envia(p, "alfaMaterial", 1.0f);
    dibujaIluminado(p, estado.cubo, traslacion({0, -0.1f, 0}) * escalado({4.4f, 0.2f, 3.4f}), camara,
                    pintura({0.85f, 0.82f, 0.74f}));
    dibujaIluminado(p, estado.cubo, traslacion({0, 0.55f, 0}) * giroY(0.6f) * escalado(0.75f), camara,
                    pintura(ROJO)); // dentro
    dibujaIluminado(p, estado.esfera, traslacion({1.45f, 0.45f, -0.9f}) * escalado(0.45f), camara,
                    pintura(AMARILLO));
    for (int i = 0; i < 5; ++i) // detrás, una valla
        dibujaIluminado(p, estado.cubo,
                        traslacion({-1.8f + 0.55f * float(i), 0.9f, -1.4f}) * escalado({0.26f, 1.8f, 0.12f}),
                        camara, pintura(i % 2 ? VERDE : NARANJA));
}

static void dibujaVista(const Recuadro &r, float alfa) {
    abreRecuadro(r);
    ponFondo(CIELO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 camara = camaraOrbita(estado.orbita);
    const GLuint p = estado.programa;
    usaIluminado(p, camara, perspectivaVentana(0.5f, 1, 60, aspecto(r)), luz);
    dibujaOpacos(camara);

    // Listado 7.1
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    envia(p, "alfaMaterial", alfa);
    const glm::mat4 M = traslacion({0, 1.07f, 0}) * giroX(-glm::half_pi<float>()) * escalado({1, 1, 2.1f});
    for (const GLenum caras : {GL_FRONT, GL_BACK}) { // las que NO se dibujan
        glCullFace(caras);
        dibujaIluminado(p, estado.cilindro, M, camara, VIDRIO);
    }
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);

    rotula(formatea("α = %.1f", alfa), {0.5f, 0.93f}, OSCURO, Lado::CENTRO, estado.compara ? 0.035f : 0.055f);
}

static void dibuja() {
    if (estado.compara) {
        abreRecuadro(ventanaEntera());
        ponFondo(GRIS);
        glClear(GL_COLOR_BUFFER_BIT);
        const std::vector<Recuadro> paneles = reparte(4);
        for (std::size_t i = 0; i < 4; ++i)
            dibujaVista(paneles[i], ALFAS[i]);
    } else {
        dibujaVista(ventanaEntera(), estado.alfa);
    }
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    if (int i; eligeModo(i, 4, tecla))
        estado.alfa = ALFAS[i];
    else if (tecla == '+' || tecla == '-')
        estado.alfa += tecla == '+' ? PASO : -PASO;
    else if (tecla == 'v')
        estado.compara = !estado.compara;
    else
        return;
    if (tecla != 'v')
        estado.compara = false;
    estado.alfa = std::clamp(estado.alfa, 0.0f, 1.0f);
    ponTitulo("Transparencia: alfa = " +
              (estado.compara ? "0.1, 0.4, 0.7 y 1" : formatea("%.1f", estado.alfa)));
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Transparencia: alfa = 0.4", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
