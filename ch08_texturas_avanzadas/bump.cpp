// Bump mapping (§8.4, figura 8.5): la superficie es lisa y solo cambia la normal con que se ilumina, que sale de un
// mapa de normales (mapa_normales.h). Se nota en que el contorno, ampliado arriba a la derecha, sigue siendo liso. La
// esfera está aplastada y el plano estirado: los bultos no dejan de ser redondos ni de tener la pendiente debida.
// Controles: b con bultos o sin ellos · v las dos cosas · ratón orbita · Esc termina.
#include "aspecto.h"
#include "buferes.h"
#include "ch03_transformaciones/transformaciones.h"
#include "ch04_vista3d/vista.h"
#include "ch05_iluminacion/iluminacion.h"
#include "ch05_iluminacion/materiales.h"
#include "colores.h"
#include "malla.h"
#include "mapa_normales.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "ventana.h"
#include <algorithm>
#include <glm/gtc/constants.hpp>

static const Material BARRO = {{0.26f, 0.14f, 0.09f}, {0.80f, 0.42f, 0.26f}, {0.40f, 0.40f, 0.40f}, 40};
static const Material PIEDRA = {{0.17f, 0.20f, 0.24f}, {0.50f, 0.58f, 0.68f}, {0.20f, 0.20f, 0.20f}, 20};
static const glm::vec3 CENTRO(0, 0.25f, 0);            // el de la bola
static const float LADO_BALDOSA = 0.4f, AZIMUT = 0.3f; // con que empieza la cámara
static const double ASPECTO_DE_DOS =
    1.05; // de lo que hay, se mire desde donde se mire: llena a lo ancho un panel alto

static struct {
    GLuint programa, mapa;
    Buferes esfera, plano;
    bool conBultos = true, comparando = false;
    Orbita orbita = {AZIMUT, 0.5f, 8.8f, {0, -0.25f, 0}, 0.05f};
} estado;

static void inicia() {
    estado.programa =
        creaPrograma("ch08_texturas_avanzadas/iluminado.vert", "ch08_texturas_avanzadas/bump.frag");
    estado.esfera = creaBuferes(esfera(segmentosEsfera(300)));
    estado.plano = creaBuferes(plano(1));
    const int lado = 64;
    glGenTextures(1, &estado.mapa);
    glBindTexture(GL_TEXTURE_2D, estado.mapa);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, lado, lado, 0, GL_RGB, GL_UNSIGNED_BYTE,
                 mapaNormales(lado).data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glEnable(GL_DEPTH_TEST);
}

static void dibujaEscena(const Recuadro &panel, const glm::mat4 &camara, const glm::mat4 &proyeccion,
                         bool conBultos) {
    abreRecuadro(panel);
    ponFondo(FONDO_CLARO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 tumbado = giroX(-glm::half_pi<float>());
    const auto objeto = [&](const Buferes &solido, const glm::mat4 &M, const Material &material,
                            const glm::vec2 &nVeces, float altura) {
        envia(estado.programa, "nVeces", nVeces);
        envia(estado.programa, "altura", conBultos ? altura : 0);
        dibujaIluminado(estado.programa, solido, M, camara, material);
    };
    usaIluminado(estado.programa, camara, proyeccion, {{-4, 5, 4, 1}});
    envia(estado.programa, "mapaNormales", 0);
    const glm::vec2 talla(2.8f, 2.8f);
    objeto(estado.plano, traslacion({0, -1, 0}) * tumbado * escalado({talla.x, talla.y, 1}), PIEDRA,
           talla / LADO_BALDOSA, LADO_BALDOSA);
    // los polos, donde los bultos se aprietan, a los lados
    const glm::mat4 bola =
        traslacion(CENTRO) * giroY(glm::half_pi<float>() + AZIMUT) * escalado({1.25f, 1.25f, 1.125f});
    objeto(estado.esfera, bola, BARRO, {20, 10}, 0.36f);
}

static void dibujaPanel(const Recuadro &panel, bool conBultos) {
    const glm::mat4 camara = camaraOrbita(estado.orbita);
    dibujaEscena(panel, camara,
                 perspectivaVentana(0.45f, 1, 100, aspecto(panel),
                                    estado.comparando ? ASPECTO_DE_DOS : ASPECTO_COMPUESTO),
                 conBultos);
    rotula(conBultos ? "con el mapa" : "sin el mapa", {0.02f, 0.98f}, OSCURO, Lado::DERECHA);

    // desde el mismo sitio, con un ángulo menor y hacia el borde de arriba a la izquierda; en una ventana alta, de modo
    // que no tape la bola
    const int libre = estado.comparando ? panel.ancho : 3 * panel.ancho / 4;
    const int lado = 3 * std::min(libre, panel.alto) / 10;
    const int margen = lado / 10, raya = lado / 60 + 1;
    const int x = panel.x + panel.ancho - lado - margen, y = panel.y + panel.alto - lado - margen;
    const glm::mat3 ejes = glm::transpose(glm::mat3(camara));
    const glm::vec3 borde = CENTRO + 0.83f * (ejes[1] - ejes[0]);
    abreRecuadro({x - raya, y - raya, lado + 2 * raya, lado + 2 * raya});
    ponFondo(GRIS);
    glClear(GL_COLOR_BUFFER_BIT);
    dibujaEscena({x, y, lado, lado}, transformacionCamara(posicionCamara(estado.orbita), borde, {0, 1, 0}),
                 perspectivaVentana(0.07f, 1, 100, 1), conBultos);
}

static void dibuja() {
    if (estado.comparando) {
        abreRecuadro(ventanaEntera());
        ponFondo(GRIS);
        glClear(GL_COLOR_BUFFER_BIT);
        const std::vector<Recuadro> paneles = reparte(2);
        dibujaPanel(paneles[0], false);
        dibujaPanel(paneles[1], true);
    } else {
        dibujaPanel(ventanaEntera(), estado.conBultos);
    }
    const char *const uno = estado.conBultos ? "con el mapa de normales" : "sin el mapa";
    ponTitulo(std::string("Bump mapping: ") + (estado.comparando ? "sin y con el mapa de normales" : uno));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    if (tecla == 'b') {
        estado.conBultos = !estado.conBultos;
        estado.comparando = false;
    } else if (tecla == 'v') {
        estado.comparando = !estado.comparando;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Bump mapping", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
