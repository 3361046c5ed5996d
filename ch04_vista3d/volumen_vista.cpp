// El volumen de la vista visto desde fuera (figuras 4.3 y 4.4), con sus parámetros: la pirámide truncada de la
// perspectiva o la caja de la paralela, entre el plano cerca (naranja) y el plano lejos (azul). Solo lo que está dentro
// conserva su color: el fragment shader comprueba la condición del recortado, −w ≤ x, y, z ≤ w.
// Controles: p cambia de proyección · , . mueven el plano cerca · - + mueven el plano lejos · ratón orbita ·
// Esc termina.
#include "camara_fotos.h"
#include "ch03_transformaciones/objeto.h"
#include "orbita.h"
#include "proyeccion.h"
#include "rotulo.h"
#include "texto.h"
#include "trazo.h"
#include "ventana.h"
#include "vista.h"
#include "volumen.h"
#include <glm/gtc/constants.hpp>

static const double THETA = 0.52, ASPECTO = 4.0 / 3, ALTO = 1.7; // radianes; medio alto de la caja
static const double PASO = 0.5, CERCA_MINIMO = 1.5, LEJOS_MAXIMO = 10, ENTRE_PLANOS = 3, RADIO_ARCO = 1.4;
static const float TALLA = 0.033f; // de los rótulos
static const glm::dvec3 OJO(0, 2.5, 6.5), INTERES(0, 2.5, 0);

static struct {
    GLuint deObjetos, deEscena, deTintes;
    Buferes cubo, cilindro, cono, esfera, plano;
    bool enPerspectiva = true;
    double cerca = 2.5, lejos = 9;
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
    ponFondo(FONDO_CLARO);
}

static void empieza(GLuint programa, const glm::mat4 &proyeccion, const glm::mat4 &camara) {
    usaPrograma(programa, camara, proyeccion);
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

static std::string conValor(const char *nombre, double valor) {
    return formatea("%s %.3g", nombre, valor);
}

// Las aristas y los parámetros, en el lado o el plano que cada uno decide.
static void trazaVolumen(const std::array<glm::vec3, 8> &e, const glm::mat4 &aRecortado) {
    const auto base = e.begin();
    for (int k = 0; k < 4; ++k) {
        trazaSegmentos({e[k], e[k + 4]}, aRecortado, OSCURO, 5);
        if (estado.enPerspectiva)
            trazaSegmentos({glm::vec3(OJO), e[k]}, aRecortado, GRIS, 3);
    }
    trazaPolilinea({base, base + 4}, aRecortado, NARANJA, 8, true);
    trazaPolilinea({base + 4, base + 8}, aRecortado, AZUL, 8, true);
    // Fuera del volumen: el rótulo va junto al medio de dos esquinas, o a una, algo más arriba o más abajo.
    const auto rotulaLado = [&](const std::string &texto, std::size_t a, std::size_t b, float sube, Lado lado,
                                const glm::vec3 &color) {
        rotulaPunto(texto, 0.5f * (e[a] + e[b]) + glm::vec3(0, sube, 0), aRecortado, color, lado, TALLA);
    };
    rotulaLado(conValor("cerca", estado.cerca), 3, 3, 0, Lado::IZQUIERDA, NARANJA);
    rotulaLado(conValor("lejos", estado.lejos), 7, 7, 0, Lado::ENCIMA, AZUL);
    if (estado.enPerspectiva) {
        std::vector<glm::vec3> arco; // θ va del plano de abajo al de arriba
        for (int i = 0; i <= 12; ++i) {
            const double angulo = THETA * (i / 12.0 - 0.5);
            arco.push_back(OJO + RADIO_ARCO * glm::dvec3(0, std::sin(angulo), -std::cos(angulo)));
        }
        trazaSegmentos({arco.front(), glm::vec3(OJO), glm::vec3(OJO), arco.back()}, aRecortado, OSCURO, 3);
        trazaPolilinea(arco, aRecortado, OSCURO, 6);
        rotulaPunto("θ", arco.front(), aRecortado, OSCURO, Lado::DEBAJO);
        rotulaLado("ancho", 6, 7, 0.3f, Lado::DERECHA, OSCURO);
        rotulaLado("alto", 5, 6, 0, Lado::DERECHA, OSCURO);
    } else {
        rotulaLado("izquierda", 0, 3, 0, Lado::IZQUIERDA, OSCURO);
        rotulaLado("derecha", 5, 6, 0, Lado::DERECHA, OSCURO);
        rotulaLado("abajo", 0, 1, -0.3f, Lado::IZQUIERDA, OSCURO);
        rotulaLado("arriba", 3, 7, 0.3f, Lado::IZQUIERDA, OSCURO);
    }
}

// Los dos planos, translúcidos: el cuadrado de lado 1 llevado a la esquina 0 con los lados que salen de ella.
static void dibujaTintes(const std::array<glm::vec3, 8> &e) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    glBlendColor(0, 0, 0, 0.35f);
    glDepthMask(GL_FALSE);
    // primero el más lejano a quien mira
    const bool porDelante = posicionCamara(estado.orbita).z < OJO.z - (estado.cerca + estado.lejos) / 2;
    for (const std::size_t base : {porDelante ? 0u : 4u, porDelante ? 4u : 0u}) {
        const glm::vec3 x = e[base + 1] - e[base], y = e[base + 3] - e[base];
        envia(estado.deTintes, "M",
              glm::mat4(glm::vec4(x, 0), glm::vec4(y, 0), glm::vec4(0, 0, 1, 0),
                        glm::vec4(e[base] + 0.5f * (x + y), 1)));
        envia(estado.deTintes, "color", base ? AZUL : NARANJA);
        dibuja(estado.plano);
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const double x = ASPECTO * ALTO;
    const glm::dmat4 vista = transformacionCamara(OJO, INTERES, {0, 1, 0}), alMundo = glm::inverse(vista);
    const glm::dmat4 volumen = estado.enPerspectiva
                                   ? proyeccionPerspectiva(THETA, ASPECTO, estado.cerca, estado.lejos)
                                   : proyeccionParalela(-x, x, -ALTO, ALTO, estado.cerca, estado.lejos);
    const Esquinas enCamara = estado.enPerspectiva
                                  ? esquinasPerspectiva(THETA, ASPECTO, estado.cerca, estado.lejos)
                                  : esquinasParalela(-x, x, -ALTO, ALTO, estado.cerca, estado.lejos);
    std::array<glm::vec3, 8> esquinas;
    for (std::size_t k = 0; k < 8; ++k)
        esquinas[k] = alMundo * glm::dvec4(enCamara[k], 1);
    const glm::mat4 proyeccion = perspectivaVentana(0.55f, 1, 100), camara = camaraOrbita(estado.orbita);
    empieza(estado.deEscena, proyeccion, camara);
    dibujaEscena(glm::mat4(volumen * vista));
    empieza(estado.deObjetos, proyeccion, camara);
    for (const PiezaCamara &pieza : piezasCamara())
        dibujaObjeto(estado.deObjetos, pieza.esRedonda ? estado.cilindro : estado.cubo,
                     glm::mat4(alMundo) * pieza.M, pieza.color);
    empieza(estado.deTintes, proyeccion, camara);
    dibujaTintes(esquinas);
    trazaVolumen(esquinas, proyeccion * camara);
    ponTitulo(conValor("El volumen de la vista: cerca", estado.cerca) + conValor(", lejos", estado.lejos));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    switch (tecla) {
    case 'p': estado.enPerspectiva = !estado.enPerspectiva; break;
    case ',': estado.cerca = std::max(estado.cerca - PASO, CERCA_MINIMO); break;
    case '.': estado.cerca = std::min(estado.cerca + PASO, estado.lejos - ENTRE_PLANOS); break;
    case '-': estado.lejos = std::max(estado.lejos - PASO, estado.cerca + ENTRE_PLANOS); break;
    case '+': estado.lejos = std::min(estado.lejos + PASO, LEJOS_MAXIMO); break;
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
