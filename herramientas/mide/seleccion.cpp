// Saber qué objeto hay bajo el ratón: dibujar sus identificadores y leerlos, o cortar un rayo.
#include "ch03_transformaciones/transformaciones.h"
#include "ch10_interaccion/identificador.h"
#include "escena.h"
#include "mide.h"
#include <random>

using namespace mide;

/// El primer corte del rayo con las esferas, en el tipo que se pida; 0 si no hay ninguno.
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

static const std::size_t DIBUJADOS = 40; // clics que se comprueban dibujando: los demás, con lo dibujado

static void mideSeleccion(Medidor &m) {
    abreContexto();
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_DITHER);
    const Framebuffer framebuffer(m.elige(96, 960), m.elige(72, 720));
    std::mt19937 azar(4);
    const auto al = [&] { return float(double(azar()) / 2147483648.0 - 1); };
    std::vector<glm::vec4> bolas; // centro y radio
    for (int i = 0; i < 40; ++i)
        bolas.push_back({1.4f * al(), 1.1f * al(), al(), 0.12f + 0.08f * al()});
    const GLuint programa =
        creaPrograma("ch03_transformaciones/objeto.vert", "ch10_interaccion/identificador.frag");
    glUseProgram(programa);
    envia(programa, "proyeccion", proyeccionEscena(framebuffer));
    envia(programa, "camara", camaraEscena());
    const oraculo::Camara camara = camaraExacta();
    oraculo::Escena escena;
    for (const glm::vec4 &b : bolas)
        escena.push_back(
            oraculo::esfera(oraculo::traslada(exacto(glm::vec3(b))) * oraculo::escala(double(b.w))));
    std::vector<glm::ivec2> clics;
    for (int i = 0; i < m.elige(50, 2000); ++i)
        clics.push_back({int(0.5f * (1 + al()) * float(framebuffer.ancho - 1)),
                         int(0.5f * (1 + al()) * float(framebuffer.alto - 1))});
    std::vector<unsigned> verdad;
    for (const glm::ivec2 &c : clics)
        verdad.push_back(oraculo::primerImpacto(escena, oraculo::rayo(camara, framebuffer.ancho,
                                                                      framebuffer.alto, c.x + 0.5, c.y + 0.5))
                             .objeto +
                         1);

    const auto leePixel = [](const glm::ivec2 &c) {
        unsigned char p[4];
        glReadPixels(c.x, c.y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, p);
        return identificadorDe({p[0], p[1], p[2]});
    };
    using Elige = std::function<unsigned(const glm::ivec2 &)>;
    // el error, con todos los clics; los últimos con `sinDibujar`, que da lo mismo que `elige` con lo que ya está
    // dibujado
    const auto variante = [&](const std::string &nombre, const Elige &elige, const Elige &sinDibujar,
                              const Rango &espera, const char *nota = "") {
        std::size_t mal = 0, k = 0;
        elige(clics[0]);
        for (std::size_t i = 0; i < clics.size(); ++i)
            mal += (i < DIBUJADOS ? elige : sinDibujar)(clics[i]) != verdad[i];
        m.variante(
            nombre, 100.0 * double(mal) / double(clics.size()), 1,
            [&] { usa(elige(clics[k++ % clics.size()])); }, espera, nota);
    };
    const auto dibuja = [&](const Buferes &b) {
        framebuffer.borra(0, 0, 0);
        for (std::size_t i = 0; i < bolas.size(); ++i) {
            envia(programa, "M", traslacion(glm::vec3(bolas[i])) * escalado(bolas[i].w));
            envia(programa, "identificador", colorDe(unsigned(i + 1)));
            ::dibuja(b);
        }
    };
    m.grupo = "cualquier forma";
    for (const int n : {12, 64}) {
        const Buferes b = creaBuferes(esfera(n));
        const std::string malla = ", esferas de " + std::to_string(n);
        variante("dibujar y leer un píxel" + malla,
                 [&](const auto &c) {
                     dibuja(b);
                     return leePixel(c);
                 },
                 leePixel, {0, n == 12 ? 20 : 1.5});
        const Elige soloUno = [&](const glm::ivec2 &c) { // tras dibujarlo entero: es el mismo píxel
            if (&c == &clics[DIBUJADOS])
                dibuja(b);
            return leePixel(c);
        };
        framebuffer.borra(0, 0, 0); // que no acierte por lo que había
        variante(
            "dibujar solo ese píxel" + malla,
            [&](const auto &c) {
                glEnable(GL_SCISSOR_TEST);
                glScissor(c.x, c.y, 1, 1);
                dibuja(b);
                glDisable(GL_SCISSOR_TEST);
                return leePixel(c);
            },
            soloUno, {0, n == 12 ? 20 : 1.5}, "glScissor");
        if (n == 12) {
            borraBuferes(b);
            continue;
        }
        std::vector<unsigned char> todo(4 * framebuffer.ancho * framebuffer.alto);
        variante("dibujar y leer la ventana",
                 [&](const auto &c) {
                     dibuja(b);
                     glReadPixels(0, 0, framebuffer.ancho, framebuffer.alto, GL_RGBA, GL_UNSIGNED_BYTE,
                                  todo.data());
                     const std::size_t i = 4 * (c.y * framebuffer.ancho + c.x);
                     return identificadorDe({todo[i], todo[i + 1], todo[i + 2]});
                 },
                 leePixel, {0, 1.5});
        dibuja(b);
        m.grupo = "sin dibujar";
        variante("leer un píxel ya dibujado", leePixel, leePixel, {0, 1.5}, "mientras nada se mueva");
        borraBuferes(b);
    }
    m.grupo = "solo esferas";
    const auto conRayo = [&](auto cero) {
        using T = decltype(cero);
        return [&](const glm::ivec2 &c) {
            const oraculo::Rayo r =
                oraculo::rayo(camara, framebuffer.ancho, framebuffer.alto, c.x + 0.5, c.y + 0.5);
            return cortaEsferas<T>(bolas, {r.origen.x, r.origen.y, r.origen.z},
                                   {r.direccion.x, r.direccion.y, r.direccion.z});
        };
    };
    variante("rayo en float", conRayo(0.0f), conRayo(0.0f), {0, 0.5}, "hay que saber cortar cada forma");
    variante("rayo en double", conRayo(0.0), conRayo(0.0), {0, 0}, "hay que saber cortar cada forma");
}

static const Apunta APUNTA(
    {20, "seleccion", "Elegir con el ratón", "µs por clic, con 40 esferas en 960×720",
     "% de clics mal, frente al rayo en double con la forma exacta", "dibujar solo ese píxel, esferas de 64",
     "Los identificadores aciertan en lo que se ve, sea cual sea la forma; solo difieren en el contorno, "
     "donde la malla no es la esfera. "
     "seleccion sigue el listado y dibuja la escena entera; con glScissor bastaría su píxel. "
     "Un rayo cuesta mil veces menos, pero hay que saber cortar cada forma.",
     mideSeleccion});
