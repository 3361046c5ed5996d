// Cuántos segmentos necesita una esfera o un toro para que su contorno no se separe del exacto, con 250 píxeles de
// radio.
#include "escena.h"
#include "mide.h"
#include <glm/gtc/constants.hpp>

using namespace mide;

static const double RADIO_PX = 250;

static double cruz(const glm::dvec2 &o, const glm::dvec2 &a, const glm::dvec2 &b) {
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

// Lo que se hunde el contorno de un convexo de radio `radio`, centrado, visto a lo largo de Z tras girarlo: el lado de
// su envolvente que pasa más cerca del centro.
static double hundimiento(const Malla &malla, const glm::mat4 &giro, double radio) {
    std::vector<glm::dvec2> p, h;
    for (const Vertice &v : malla.vertices)
        p.push_back(glm::dvec2(giro * glm::vec4(v.posicion, 1)));
    std::sort(p.begin(), p.end(),
              [](const auto &a, const auto &b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
    for (int vuelta = 0; vuelta < 2; ++vuelta) { // la mitad de abajo y la de arriba
        const std::size_t base = h.size();
        for (const glm::dvec2 &q : p) {
            while (h.size() > base + 1 && cruz(h[h.size() - 2], h.back(), q) <= 0)
                h.pop_back();
            h.push_back(q);
        }
        h.pop_back();
        std::reverse(p.begin(), p.end());
    }
    double cerca = radio;
    for (std::size_t i = 0; i < h.size(); ++i) {
        const glm::dvec2 &a = h[i], &b = h[(i + 1) % h.size()];
        cerca = std::min(cerca, cruz(glm::dvec2(0), a, b) / glm::length(b - a));
    }
    return radio - cerca;
}

static void mideEsferas(Medidor &m) {
    abreContexto();
    const int lado = m.elige(60, 600);
    const Framebuffer framebuffer(lado, lado);
    const GLuint programa = creaSombreado("phong");
    enviaEscena(programa, framebuffer);
    glEnable(GL_DEPTH_TEST);
    const glm::mat4 M = escalado(1.08f); // unos 250 px de radio en 600
    const auto variante = [&](const std::string &nombre, const Malla &malla, double radio, bool convexo,
                              const Rango &espera) {
        double mayor = 0;
        for (const glm::vec2 g : {glm::vec2(0), glm::vec2(0.7f, 0.4f), glm::vec2(1.57f, 0.1f)})
            if (convexo || g == glm::vec2(0)) // el toro, de frente
                mayor = std::max(mayor, hundimiento(malla, giroX(g.x) * giroY(g.y), radio));
        const Buferes b = creaBuferes(malla);
        m.variante(nombre, RADIO_PX / radio * mayor, 1, yEspera([&] {
                       framebuffer.borra(0.95f, 0.96f, 0.98f);
                       dibujaIluminado(programa, b, M, camaraEscena(), CORAL);
                   }),
                   espera, std::to_string(malla.indices.size() / 3) + " triángulos", framebuffer.lee());
        borraBuferes(b);
    };
    const auto flecha =
        [](int n) { // la de un arco de 2π/n; los meridianos de esfera() tienen la mitad de segmentos
            const double f = RADIO_PX * (1 - std::cos(glm::pi<double>() / n));
            return Rango{0.9 * f, 2.1 * f};
        };
    const Malla fina = esfera(m.elige(64, 512));
    {
        const Buferes b = creaBuferes(fina);
        framebuffer.borra(0.95f, 0.96f, 0.98f);
        dibujaIluminado(programa, b, M, camaraEscena(), CORAL);
        m.referencia = framebuffer.lee();
        borraBuferes(b);
    }
    m.grupo = "esfera";
    for (const int n : {16, 32, 64, 128, 256})
        variante("esfera de " + std::to_string(n), esfera(n), 1, true, flecha(n));
    const int justos = segmentosEsfera(RADIO_PX);
    variante("esfera, segmentosEsfera", esfera(justos), 1, true, {0, 0.25});
    m.referencia = {};
    m.grupo = "toro";
    for (const int n : {32, 64, 128}) {
        const float tubo = 0.3f, radio = 1 - tubo;
        variante("toro de " + std::to_string(n) + "×" + std::to_string(n / 2), toro(radio, tubo, n, n / 2), 1,
                 false, flecha(n));
    }
    const int n = segmentosPara(RADIO_PX, 0.5f);
    variante("toro, segmentosPara", toro(0.7f, 0.3f, n, n / 2), 1, false, {0, 0.501});
}

static const Apunta APUNTA({5, "esferas", "Esferas y toros", "ms por imagen de 600×600 con Phong",
                            "píxeles que se hunde el contorno, con 250 de radio", "esfera, segmentosEsfera",
                            "El tiempo casi no depende de los segmentos hasta que los triángulos son más "
                            "pequeños que unos pocos píxeles: los "
                            "programas piden los justos para un cuarto de píxel.",
                            mideEsferas});
