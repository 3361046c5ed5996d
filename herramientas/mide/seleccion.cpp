// Saber qué objeto hay bajo el ratón: dibujar sus identificadores y leerlos, o cortar un rayo.
#include "ch03_transformaciones/transformaciones.h"
#include "ch10_interaccion/identificador.h"
#include "escena.h"

using namespace mide;

using Clic = glm::ivec2;
using Bolas = std::vector<glm::vec4>; // centro y radio

// El primer corte del rayo con las bolas; 0 si no hay ninguno.
static unsigned cortaBolas(const Bolas &bolas, const oraculo::Rayo &r) {
    const glm::dvec3 o(r.origen.x, r.origen.y, r.origen.z), d(r.direccion.x, r.direccion.y, r.direccion.z);
    double cerca = INFINITO;
    unsigned cual = 0;
    for (std::size_t i = 0; i < bolas.size(); ++i) {
        const glm::dvec3 v = o - glm::dvec3(bolas[i]);
        const double radio = double(bolas[i].w), b = glm::dot(v, d),
                     disc = b * b - glm::dot(v, v) + radio * radio, t = disc > 0 ? -b - std::sqrt(disc) : -1;
        if (t > 0 && t < cerca) {
            cerca = t;
            cual = unsigned(i + 1);
        }
    }
    return cual;
}

// Las bolas, cada una de su identificador.
static void dibuja(const Framebuffer &framebuffer, GLuint programa, const Buferes &malla,
                   const Bolas &bolas) {
    framebuffer.borra({0, 0, 0});
    for (std::size_t i = 0; i < bolas.size(); ++i) {
        envia(programa, "M", traslacion(glm::vec3(bolas[i])) * escalado(bolas[i].w));
        envia(programa, "identificador", colorDe(unsigned(i + 1)));
        dibujaMalla(malla);
    }
}

static unsigned leePixel(const Clic &c) {
    unsigned char p[4];
    glReadPixels(c.x, c.y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, p);
    return identificadorDe({p[0], p[1], p[2]});
}

// Lo que se compara: qué objeto da cada manera en un clic.
using Elige = std::function<unsigned(const Clic &)>;
using Variante = std::function<void(const std::string &nombre, const char *nota, const Elige &elige)>;

static void mideDibujando(const Variante &variante, const Framebuffer &framebuffer, const Bolas &bolas) {
    const GLuint programa =
        creaPrograma("ch03_transformaciones/objeto.vert", "ch10_interaccion/identificador.frag");
    usaPrograma(programa, camaraEscena(), proyeccionEscena(framebuffer));
    for (const int n : {12, 64}) {
        const Buferes malla = creaBuferes(esfera(n));
        variante(formatea("dibujar y leer un píxel, esferas de %d", n), "", [&](const Clic &c) {
            dibuja(framebuffer, programa, malla, bolas);
            return leePixel(c);
        });
        borraBuferes(malla);
    }
    const Buferes malla = creaBuferes(esfera(64));
    variante("dibujar solo ese píxel, esferas de 64", "glScissor", [&](const Clic &c) {
        glEnable(GL_SCISSOR_TEST);
        glScissor(c.x, c.y, 1, 1);
        dibuja(framebuffer, programa, malla, bolas);
        glDisable(GL_SCISSOR_TEST);
        return leePixel(c);
    });
    const int ancho = framebuffer.ancho, alto = framebuffer.alto;
    std::vector<unsigned char> todo(4 * ancho * alto);
    variante("dibujar y leer la ventana", "", [&](const Clic &c) {
        dibuja(framebuffer, programa, malla, bolas);
        glReadPixels(0, 0, ancho, alto, GL_RGBA, GL_UNSIGNED_BYTE, todo.data());
        const std::size_t i = 4 * (c.y * ancho + c.x);
        return identificadorDe({todo[i], todo[i + 1], todo[i + 2]});
    });
}

static void mideSeleccion(Medidor &m) {
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_DITHER);
    const int ancho = m.elige(96, 960), alto = m.elige(72, 720);
    const Framebuffer framebuffer(ancho, alto);
    Azar al(4);
    Bolas bolas;
    oraculo::Escena escena;
    for (int i = 0; i < 40; ++i) {
        const glm::vec4 b = {1.4f * al(), 1.1f * al(), al(), 0.12f + 0.08f * al()};
        bolas.push_back(b);
        escena.push_back(
            oraculo::esfera(oraculo::traslada(exacto(glm::vec3(b))) * oraculo::escala(double(b.w))));
    }
    std::vector<Clic> clics;
    for (int i = 0; i < m.elige(25, 200); ++i)
        clics.push_back(
            {int(0.5f * (1 + al()) * float(ancho - 1)), int(0.5f * (1 + al()) * float(alto - 1))});
    const auto rayo = [&](const Clic &c) {
        return oraculo::rayo(camaraExacta(), ancho, alto, c.x + 0.5, c.y + 0.5);
    };
    const auto variante = [&](const std::string &nombre, const char *nota, const Elige &elige) {
        int mal = 0;
        for (const Clic &c : clics)
            mal += elige(c) != unsigned(oraculo::primerImpacto(escena, rayo(c)).objeto + 1);
        std::size_t k = 0;
        m.variante(nombre, nota, 100.0 * mal / double(clics.size()), 1,
                   [&] { usa(elige(clics[k++ % clics.size()])); });
    };
    m.grupo = "cualquier forma";
    mideDibujando(variante, framebuffer, bolas);
    m.grupo = "solo esferas";
    variante("rayo en double", "hay que saber cortar cada forma",
             [&](const Clic &c) { return cortaBolas(bolas, rayo(c)); });
}

static const Apunta APUNTA(
    {20, "seleccion", "Elegir con el ratón", "µs por clic, con 40 esferas en 960×720",
     "% de clics mal, frente al rayo en double con la forma exacta", "dibujar solo ese píxel, esferas de 64",
     "Los identificadores aciertan en lo que se ve, sea cual sea la forma; solo difieren en el contorno, "
     "donde la malla no es la esfera. "
     "seleccion, con glScissor, dibuja solo el píxel que va a leer. "
     "Un rayo cuesta mil veces menos, pero hay que saber cortar cada forma.",
     mideSeleccion});
