// Saber qué objeto hay bajo el ratón: dibujar sus identificadores y leerlos, o cortar un rayo.
#include "ch03_transformaciones/transformaciones.h"
#include "ch10_interaccion/identificador.h"
#include "escena.h"

using namespace mide;

// El primer corte del rayo con las esferas, en el tipo que se pida; 0 si no hay ninguno.
template<class T>
static unsigned cortaEsferas(const std::vector<glm::vec4> &bolas, const glm::vec<3, T> &o,
                             const glm::vec<3, T> &d) {
    T cerca = std::numeric_limits<T>::max();
    unsigned cual = 0;
    for (std::size_t i = 0; i < bolas.size(); ++i) {
        const glm::vec<3, T> v = o - glm::vec<3, T>(glm::vec3(bolas[i]));
        const T r = T(bolas[i].w), b = glm::dot(v, d), disc = b * b - glm::dot(v, v) + r * r;
        const T t = disc > 0 ? -b - std::sqrt(disc) : T(-1);
        if (t > 0 && t < cerca) {
            cerca = t;
            cual = unsigned(i + 1);
        }
    }
    return cual;
}

using Clic = glm::ivec2;
using Elige = std::function<unsigned(const Clic &)>;

static const std::size_t DIBUJADOS = 40; // clics que se comprueban dibujando: los demás, con lo dibujado

// Unas bolas al azar, unos clics sobre ellas y la que hay en cada uno.
struct Escenario {
    const Framebuffer &framebuffer;
    const oraculo::Camara camara = camaraExacta();
    std::vector<glm::vec4> bolas; // centro y radio
    std::vector<Clic> clics;
    std::vector<unsigned> verdad;

    Escenario(const Framebuffer &donde, int cuantosClics) : framebuffer(donde) {
        Azar al(4);
        oraculo::Escena escena;
        for (int i = 0; i < 40; ++i) {
            const glm::vec4 b = {1.4f * al(), 1.1f * al(), al(), 0.12f + 0.08f * al()};
            bolas.push_back(b);
            escena.push_back(
                oraculo::esfera(oraculo::traslada(exacto(glm::vec3(b))) * oraculo::escala(double(b.w))));
        }
        for (int i = 0; i < cuantosClics; ++i) {
            clics.push_back({int(0.5f * (1 + al()) * float(framebuffer.ancho - 1)),
                             int(0.5f * (1 + al()) * float(framebuffer.alto - 1))});
            verdad.push_back(unsigned(oraculo::primerImpacto(escena, rayo(clics.back())).objeto + 1));
        }
    }
    oraculo::Rayo rayo(const Clic &c) const {
        return oraculo::rayo(camara, framebuffer.ancho, framebuffer.alto, c.x + 0.5, c.y + 0.5);
    }
    // El error, con todos los clics; los últimos con `sinDibujar`, que da lo mismo que `elige` con lo ya dibujado.
    void variante(Medidor &m, const std::string &nombre, const Elige &elige, const Elige &sinDibujar,
                  const char *nota = "") const {
        std::size_t mal = 0, k = 0;
        elige(clics[0]);
        for (std::size_t i = 0; i < clics.size(); ++i)
            mal += (i < DIBUJADOS ? elige : sinDibujar)(clics[i]) != verdad[i];
        m.variante(
            nombre, 100.0 * double(mal) / double(clics.size()), 1,
            [&] { usa(elige(clics[k++ % clics.size()])); }, nota);
    }
};

// Las bolas, cada una de su identificador y con una malla de n.
class Identificadores {
    const Escenario &escenario;
    const GLuint programa;
    const Buferes malla;

public:
    Identificadores(const Escenario &deQue, GLuint conQue, int n)
        : escenario(deQue), programa(conQue), malla(creaBuferes(esfera(n))) {
    }
    ~Identificadores() {
        borraBuferes(malla);
    }
    void dibuja() const {
        escenario.framebuffer.borra({0, 0, 0});
        for (std::size_t i = 0; i < escenario.bolas.size(); ++i) {
            const glm::vec4 &b = escenario.bolas[i];
            envia(programa, "M", traslacion(glm::vec3(b)) * escalado(b.w));
            envia(programa, "identificador", colorDe(unsigned(i + 1)));
            dibujaMalla(malla);
        }
    }
};

static unsigned leePixel(const Clic &c) {
    unsigned char p[4];
    glReadPixels(c.x, c.y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, p);
    return identificadorDe({p[0], p[1], p[2]});
}

static void midePixel(Medidor &m, const Escenario &e, const Identificadores &bolas,
                      const std::string &malla) {
    e.variante(
        m, "dibujar y leer un píxel" + malla,
        [&](const Clic &c) {
            bolas.dibuja();
            return leePixel(c);
        },
        leePixel);
    const Elige soloUno = [&](const Clic &c) { // tras dibujarlo entero: es el mismo píxel
        if (&c == &e.clics[DIBUJADOS])
            bolas.dibuja();
        return leePixel(c);
    };
    e.framebuffer.borra({0, 0, 0}); // que no acierte por lo que había
    e.variante(
        m, "dibujar solo ese píxel" + malla,
        [&](const Clic &c) {
            glEnable(GL_SCISSOR_TEST);
            glScissor(c.x, c.y, 1, 1);
            bolas.dibuja();
            glDisable(GL_SCISSOR_TEST);
            return leePixel(c);
        },
        soloUno, "glScissor");
}

static void mideVentana(Medidor &m, const Escenario &e, const Identificadores &bolas) {
    const int ancho = e.framebuffer.ancho, alto = e.framebuffer.alto;
    std::vector<unsigned char> todo(4 * ancho * alto);
    e.variante(
        m, "dibujar y leer la ventana",
        [&](const Clic &c) {
            bolas.dibuja();
            glReadPixels(0, 0, ancho, alto, GL_RGBA, GL_UNSIGNED_BYTE, todo.data());
            const std::size_t i = 4 * (c.y * ancho + c.x);
            return identificadorDe({todo[i], todo[i + 1], todo[i + 2]});
        },
        leePixel);
    bolas.dibuja();
    m.grupo = "sin dibujar";
    e.variante(m, "leer un píxel ya dibujado", leePixel, leePixel, "mientras nada se mueva");
}

template<class T>
static void mideRayo(Medidor &m, const Escenario &e, const char *nombre) {
    const Elige corta = [&](const Clic &c) {
        const oraculo::Rayo r = e.rayo(c);
        return cortaEsferas<T>(e.bolas, {r.origen.x, r.origen.y, r.origen.z},
                               {r.direccion.x, r.direccion.y, r.direccion.z});
    };
    e.variante(m, nombre, corta, corta, "hay que saber cortar cada forma");
}

static void mideSeleccion(Medidor &m) {
    abreContexto();
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_DITHER);
    const Framebuffer framebuffer(m.elige(96, 960), m.elige(72, 720));
    const GLuint programa =
        creaPrograma("ch03_transformaciones/objeto.vert", "ch10_interaccion/identificador.frag");
    usaPrograma(programa, camaraEscena(), proyeccionEscena(framebuffer));
    const Escenario e(framebuffer, m.elige(50, 2000));
    m.grupo = "cualquier forma";
    midePixel(m, e, Identificadores(e, programa, 12), ", esferas de 12");
    const Identificadores finas(e, programa, 64);
    midePixel(m, e, finas, ", esferas de 64");
    mideVentana(m, e, finas);
    m.grupo = "solo esferas";
    mideRayo<float>(m, e, "rayo en float");
    mideRayo<double>(m, e, "rayo en double");
}

static const Apunta APUNTA(
    {20, "seleccion", "Elegir con el ratón", "µs por clic, con 40 esferas en 960×720",
     "% de clics mal, frente al rayo en double con la forma exacta", "dibujar solo ese píxel, esferas de 64",
     "Los identificadores aciertan en lo que se ve, sea cual sea la forma; solo difieren en el contorno, "
     "donde la malla no es la esfera. "
     "seleccion sigue el listado y dibuja la escena entera; con glScissor bastaría su píxel. "
     "Un rayo cuesta mil veces menos, pero hay que saber cortar cada forma.",
     mideSeleccion});
