// Un plano con bultos: el mapa de normales según su talla, la normal calculada en el shader y el plano deformado de
// verdad, frente a la normal exacta en cada punto del plano.
#include "ch08_texturas_avanzadas/mapa_normales.h"
#include "escena.h"
#include <glm/gtc/constants.hpp>

using namespace mide;

static const int VECES = 6;
static const double LADO = 2.6, ALTURA = LADO / VECES; // el mapa da alturas en lados de baldosa

static double fraccion(double x) {
    return x - std::floor(x);
}

static glm::dvec2 pendiente(double s, double t) { // en double, la de mapa_normales.h
    const glm::dvec2 d = (glm::dvec2(fraccion(s), fraccion(t)) - 0.5) / double(RADIO_BULTO);
    const double queda = 1 - glm::dot(d, d);
    return queda > 0 ? d * (-4.0 * double(ALTO_BULTO) / double(RADIO_BULTO) * queda) : glm::dvec2(0);
}

static double altura(const glm::vec2 &st) {
    const glm::dvec2 d = (glm::dvec2(fraccion(st.x), fraccion(st.y)) - 0.5) / double(RADIO_BULTO);
    const double queda = 1 - glm::dot(d, d);
    return queda > 0 ? double(ALTO_BULTO) * queda * queda : 0;
}

static const float INCLINACION = -0.6f;

// El plano con la normal exacta en cada punto.
static oraculo::ImagenRef trazaBultos(const Framebuffer &framebuffer) {
    const oraculo::Mat4 girado = oraculo::gira({1, 0, 0}, -0.6);
    return oraculo::render(
        {oraculo::plano(girado * oraculo::escala(LADO))}, camaraExacta(), framebuffer.ancho, framebuffer.alto,
        [&](const oraculo::Impacto &i) {
            const glm::dvec2 h = pendiente(VECES * i.s, VECES * i.t);
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
        const glm::dvec2 h = pendiente(VECES * double(v.coordTextura.x), VECES * double(v.coordTextura.y));
        v.posicion.z += float(altura(float(VECES) * v.coordTextura)) / VECES;
        v.normal = glm::normalize(glm::vec3(-h, 1));
    }
    return malla;
}

static void mideBump(Medidor &m) {
    abreContexto();
    glEnable(GL_DEPTH_TEST);
    const Framebuffer framebuffer(m.elige(64, 480), m.elige(48, 360));
    const oraculo::ImagenRef ref = trazaBultos(framebuffer);
    m.referencia = oraculo::enBytes(ref);
    const glm::mat4 M = giroX(INCLINACION) * escalado(float(LADO));
    const auto variante = [&](const std::string &nombre, GLuint programa, const Malla &malla,
                              const std::string &nota) {
        const Buferes b = creaBuferes(malla);
        enviaEscena(programa, framebuffer);
        const auto dibuja = [&] {
            framebuffer.borra(FONDO);
            dibujaIluminado(programa, b, M, camaraEscena(), CORAL);
        };
        mideImagen(
            m, nombre, framebuffer, dibuja, [&](const Imagen &i) { return errorDeFrente(i, ref); }, nota);
        borraBuferes(b);
    };
    const GLuint calculado = creaProgramaBultos("herramientas/mide/bump_calculado.frag"),
                 conMapa = creaProgramaBultos("ch08_texturas_avanzadas/bump.frag");
    envia(conMapa, "mapaNormales", 0);
    for (const int n : m.elige<std::vector<int>>({16, 64}, {8, 16, 32, 64, 128, 256})) {
        const GLuint mapa = creaTextura2D({n, n, mapaNormales(n)});
        variante(formatea("mapa de %d²", n), conMapa, plano(1), formatea("%.3g kB", 4 * n * n / 1000.0));
        glDeleteTextures(1, &mapa);
    }
    variante("calculada en el shader", calculado, plano(1), "sin textura");
    for (const int n : m.elige<std::vector<int>>({60}, {60, 240}))
        variante(formatea("deformado, %d×%d", n, n), creaSombreado("phong"), planoDeformado(n),
                 formatea("%d triángulos; los bultos se tapan: es otra superficie", 2 * n * n));
}

static const Apunta
    APUNTA({15, "bump", "Bultos con la normal", "ms por imagen de 480×360",
            "niveles de 255 (RMSE), frente a la normal exacta", "mapa de 64²",
            "Desde 64² no mejora: un mapa mayor de lo que se ve lo emborronan sus mipmaps. Deformar la malla "
            "de verdad mueve además los puntos: eso no lo imita ningún mapa.",
            mideBump});
