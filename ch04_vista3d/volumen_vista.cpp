// El volumen de la vista visto desde fuera (figuras 4.3 y 4.4), con sus parámetros: la pirámide truncada de la
// perspectiva o la caja de la paralela, entre el plano cerca (naranja) y el plano lejos (azul). Solo lo que está dentro
// conserva su color: el fragment shader comprueba la condición del recortado, −w ≤ x, y, z ≤ w. Con e se ve lo que ve
// la cámara en dos áreas de dibujo (glViewport): en la de 4:3, si el volumen no tiene esa forma, la imagen se deforma
// (§4.5); en la de la forma del volumen, ancho/alto, no.
// Controles: p cambia de proyección · , . mueven el plano cerca · - + mueven el plano lejos · s w cierran y abren θ ·
// a d cambian ancho/alto · e lo que ve la cámara · ratón orbita · Esc termina.
#include "buferes.h"
#include "camara_fotos.h"
#include "ch03_transformaciones/objeto.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "malla.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "trazo.h"
#include "trazos_volumen.h"
#include "ventana.h"
#include "vista.h"
#include "volumen.h"
#include <glm/gtc/constants.hpp>

static const double PASO = 0.5, CERCA_MINIMO = 1.5, LEJOS_MAXIMO = 10, ENTRE_PLANOS = 3;
static const double PASO_THETA = 0.065, THETA_MINIMO = 0.26, THETA_MAXIMO = 0.585; // radianes
static const double PASO_ASPECTO = 1.0 / 3, ASPECTO_MINIMO = 2.0 / 3, ASPECTO_MAXIMO = 2,
                    ASPECTO_VISOR = 4.0 / 3;
static const double ALTO_VISOR = 0.26; // de lo alto útil de la ventana
static const glm::dvec3 INTERES(0, 2.5, 0);

static struct {
    GLuint deObjetos, deEscena, deTintes;
    Buferes cubo, cilindro, cono, esfera, plano;
    Volumen volumen;
    bool conVisores = false;
    Orbita orbita = {0.95f, 0.36f, 20.3f, {0.0f, 1.6f, 0.9f}, 0.05f};
} estado;

static void inicia() {
    estado.deObjetos = creaProgramaObjeto();
    estado.deEscena = creaPrograma("ch04_vista3d/volumen_vista.vert", "ch04_vista3d/volumen_vista.frag");
    estado.deTintes = creaPrograma("ch03_transformaciones/objeto.vert", "common/liso.frag");
    estado.cubo = creaBuferes(cubo());
    estado.cilindro = creaBuferes(cilindro(24));
    estado.cono = creaBuferes(cono(48));
    estado.esfera = creaBuferes(esfera(48));
    estado.plano = creaBuferes(plano(1));
    glEnable(GL_DEPTH_TEST);
}

static void dibujaEscena(const glm::mat4 &volumen) {
    const auto pon = [&](const Buferes &solido, const glm::mat4 &M, const glm::vec3 &color) {
        envia(estado.deEscena, "aRecortado", volumen * M);
        dibujaObjeto(estado.deEscena, solido, M, color);
    };
    const glm::mat4 dePie = giroX(-glm::half_pi<float>()); // los conos, con el vértice arriba
    pon(estado.cubo, traslacion({0, -0.1f, 0.5f}) * escalado({8, 0.2f, 12}), SUELO);
    pon(estado.esfera, traslacion({-0.7f, 2.5f, 2.3f}) * escalado(0.6f), ROJO);
    pon(estado.cono, traslacion({1.2f, 0, 0.2f}) * dePie * escalado({0.9f, 0.9f, 3.8f}), VERDE);
    pon(estado.cubo, traslacion({-2.3f, 1.5f, -0.4f}) * escalado({1.4f, 3, 1.4f}), AMARILLO);
    pon(estado.esfera, traslacion({0.5f, 1.8f, -2.7f}) * escalado(1.5f), MORADO);
    pon(estado.cubo, traslacion({1.9f, 0.5f, 5.7f}), AZUL);
    pon(estado.cono, traslacion({-3.0f, 0, 3.2f}) * dePie * escalado({0.8f, 0.8f, 2.4f}), NARANJA);
}

// Los dos planos, translúcidos: el cuadrado de lado 1 llevado a la esquina 0 con los lados que salen de ella.
static void dibujaTintes(const std::array<glm::vec3, 8> &e) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    glBlendColor(0, 0, 0, 0.35f);
    glDepthMask(GL_FALSE);
    // primero el más lejano a quien mira
    const bool porDelante =
        posicionCamara(estado.orbita).z < OJO_VOLUMEN.z - (estado.volumen.cerca + estado.volumen.lejos) / 2;
    for (const std::size_t base : {porDelante ? 0u : 4u, porDelante ? 4u : 0u}) {
        const glm::vec3 x = e[base + 1] - e[base], y = e[base + 3] - e[base];
        envia(estado.deTintes, "M",
              glm::mat4(glm::vec4(x, 0), glm::vec4(y, 0), glm::vec4(0, 0, 1, 0),
                        glm::vec4(e[base] + 0.5f * (x + y), 1)));
        envia(estado.deTintes, "color", base ? AZUL : NARANJA);
        dibujaMalla(estado.plano);
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

// Lo que ve la cámara en un área de dibujo de esa forma, la mayor que cabe en una de 4:3 y abajo; `x`: desde dónde, en
// alturas útiles, en el 4:3 central de la ventana.
static void dibujaVisor(double x, double aspecto, const std::string &texto, const glm::mat4 &vista) {
    const Recuadro ventana = ventanaEntera();
    const double util = altoUtil();
    const double alto = ALTO_VISOR * util;
    const double ancho = ASPECTO_VISOR * alto;
    const Recuadro visor = {int(ventana.ancho / 2.0 + (x - 2.0 / 3) * util),
                            int((ventana.alto - util) / 2 + 0.07 * util),
                            int(std::min(ancho, alto * aspecto)), int(std::min(alto, ancho / aspecto))};
    abreRecuadro(visor);
    ponFondo(CIELO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 volumen = proyeccionDe(estado.volumen);
    usaPrograma(estado.deEscena, vista, volumen);
    dibujaEscena(volumen * vista);
    trazaPolilinea({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, glm::mat4(1), OSCURO, GROSOR, true);
    abreRecuadro(ventana);
    const glm::dvec2 pie(visor.x + visor.ancho / 2.0, visor.y), entera(ventana.ancho, ventana.alto);
    rotula(texto, pie / entera, OSCURO, Lado::DEBAJO, 0.033f);
}

static void dibuja() {
    ponFondo(FONDO_CLARO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const Volumen &v = estado.volumen;
    const glm::dmat4 vista = transformacionCamara(OJO_VOLUMEN, INTERES, {0, 1, 0});
    const glm::dmat4 alMundo = glm::inverse(vista);
    const Esquinas enCamara = esquinasDe(v);
    std::array<glm::vec3, 8> esquinas;
    for (std::size_t k = 0; k < 8; ++k)
        esquinas[k] = alMundo * glm::dvec4(enCamara[k], 1);
    const glm::mat4 proyeccion = perspectivaVentana(0.55f, 1, 100), camara = camaraOrbita(estado.orbita);
    usaPrograma(estado.deEscena, camara, proyeccion);
    dibujaEscena(glm::mat4(proyeccionDe(v) * vista));
    usaPrograma(estado.deObjetos, camara, proyeccion);
    for (const PiezaCamara &pieza : piezasCamara())
        dibujaObjeto(estado.deObjetos, pieza.esRedonda ? estado.cilindro : estado.cubo,
                     glm::mat4(alMundo) * pieza.M, pieza.color);
    usaPrograma(estado.deTintes, camara, proyeccion);
    dibujaTintes(esquinas);
    trazaVolumen(v, esquinas, proyeccion * camara);
    if (estado.conVisores) {
        dibujaVisor(0.62, ASPECTO_VISOR, "4:3", vista);
        dibujaVisor(0.975, v.aspecto, "ancho/alto", vista);
    }
    ponTitulo("El volumen de la vista: " + describeVolumen(v));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    Volumen &v = estado.volumen;
    switch (tecla) {
    case 'p': v.enPerspectiva = !v.enPerspectiva; break;
    case ',': v.cerca = std::max(v.cerca - PASO, CERCA_MINIMO); break;
    case '.': v.cerca = std::min(v.cerca + PASO, v.lejos - ENTRE_PLANOS); break;
    case '-': v.lejos = std::max(v.lejos - PASO, v.cerca + ENTRE_PLANOS); break;
    case '+': v.lejos = std::min(v.lejos + PASO, LEJOS_MAXIMO); break;
    case 's': v.theta = std::max(v.theta - PASO_THETA, THETA_MINIMO); break;
    case 'w': v.theta = std::min(v.theta + PASO_THETA, THETA_MAXIMO); break;
    case 'a': v.aspecto = std::max(v.aspecto - PASO_ASPECTO, ASPECTO_MINIMO); break;
    case 'd': v.aspecto = std::min(v.aspecto + PASO_ASPECTO, ASPECTO_MAXIMO); break;
    case 'e': estado.conVisores = !estado.conVisores; break;
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
