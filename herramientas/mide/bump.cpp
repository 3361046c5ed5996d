// Un plano con bultos: el mapa de normales según su talla, la normal calculada en el shader y el plano deformado de
// verdad, frente a la normal exacta en cada punto del plano.
#include "ch08_texturas_avanzadas/mapa_normales.h"
#include "escena.h"
#include <glm/gtc/constants.hpp>

using namespace mide;

static const int VECES = 6;
static const double LADO = 2.6, ALTURA = LADO / VECES; // el mapa da alturas en lados de baldosa

static const double INCLINACION = -0.6;

// En double, la altura y la pendiente del bulto de mapa_normales.h.
static glm::dvec3 bulto(const glm::dvec2 &st) {
    const double radio = double(RADIO_BULTO), alto = double(ALTO_BULTO);
    const glm::dvec2 d = (glm::fract(st) - 0.5) / radio;
    const double queda = std::max(1 - glm::dot(d, d), 0.0);
    return {d * (-4 * alto / radio * queda), alto * queda * queda};
}

// El plano con la normal exacta en cada punto.
static oraculo::ImagenRef trazaBultos(const Framebuffer &framebuffer) {
    const oraculo::Mat4 girado = oraculo::gira({1, 0, 0}, INCLINACION);
    return oraculo::render(
        {oraculo::plano(girado * oraculo::escala(LADO))}, camaraExacta(), framebuffer.ancho, framebuffer.alto,
        [&](const oraculo::Impacto &i) {
            const glm::dvec3 h = bulto({VECES * i.s, VECES * i.t});
            return i ? phongExacto(i.punto, oraculo::unitario(oraculo::direccion(girado, {-h.x, -h.y, 1})))
                     : exacto(FONDO);
        });
}

static GLuint creaProgramaBultos(const char *fragmentos) {
    const GLuint programa = creaPrograma("ch08_texturas_avanzadas/iluminado.vert", fragmentos);
    glUseProgram(programa);
    envia(programa, "nVeces", glm::vec2(VECES));
    envia(programa, "altura", float(ALTURA));
    return programa;
}

static Malla planoDeformado(int n) {
    Malla malla = plano(n);
    for (Vertice &v : malla.vertices) {
        const glm::dvec3 h = bulto(double(VECES) * glm::dvec2(v.coordTextura));
        v.posicion.z += float(h.z) / VECES;
        v.normal = glm::normalize(glm::vec3(-h.x, -h.y, 1));
    }
    return malla;
}

static void mideBump(Medidor &m) {
    glEnable(GL_DEPTH_TEST);
    const Framebuffer framebuffer(m.elige(64, 480), m.elige(48, 360));
    const oraculo::ImagenRef ref = trazaBultos(framebuffer);
    m.referencia = oraculo::enBytes(ref);
    const Dibujadas dibujada{m, framebuffer, [&](const Imagen &i) { return errorDeFrente(i, ref); }};
    const auto variante = [&](const std::string &nombre, const std::string &nota, GLuint programa,
                              const Malla &malla) {
        mideIluminada(dibujada, framebuffer, nombre, nota, programa, malla,
                      giroX(float(INCLINACION)) * escalado(float(LADO)));
    };
    const GLuint calculado = creaProgramaBultos("herramientas/mide/bump_calculado.frag"),
                 conMapa = creaProgramaBultos("ch08_texturas_avanzadas/bump.frag");
    envia(conMapa, "mapaNormales", 0);
    for (const int n : m.elige<std::vector<int>>({16, 64}, {8, 16, 32, 64, 128, 256})) {
        const GLuint mapa = creaTextura2D({n, n, mapaNormales(n)});
        variante(formatea("mapa de %d²", n), formatea("%.3g kB", 4 * n * n / 1000.0), conMapa, plano(1));
        glDeleteTextures(1, &mapa);
    }
    variante("calculada en el shader", "sin textura", calculado, plano(1));
    for (const int n : m.elige<std::vector<int>>({60}, {60, 240}))
        variante(formatea("deformado, %d×%d", n, n),
                 formatea("%d triángulos; los bultos se tapan: es otra superficie", 2 * n * n),
                 creaSombreado("phong"), planoDeformado(n));
}

static const Apunta
    APUNTA({15, "bump", "Bultos con la normal", "ms por imagen de 480×360",
            "niveles de 255 (RMSE), frente a la normal exacta", "mapa de 64²",
            "Desde 64² no mejora: un mapa mayor de lo que se ve lo emborronan sus mipmaps. Deformar la malla "
            "de verdad mueve además los puntos: eso no lo imita ningún mapa.",
            mideBump});
