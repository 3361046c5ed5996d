// Cuántos segmentos necesita una esfera o un toro para que su contorno no se separe del exacto, con 250 píxeles de
// radio.
#include "escena.h"
#include <glm/gtc/constants.hpp>

using namespace mide;

static const double RADIO_PX = 250;

static double cruz(const glm::dvec2 &o, const glm::dvec2 &a, const glm::dvec2 &b) {
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

// Lo que se hunde el contorno de un convexo de radio 1, centrado, visto a lo largo de Z tras girarlo: el lado de
// su envolvente que pasa más cerca del centro.
static double hundimiento(const Malla &malla, const glm::mat4 &giro) {
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
    double cerca = 1;
    for (std::size_t i = 0; i < h.size(); ++i) {
        const glm::dvec2 &a = h[i], &b = h[(i + 1) % h.size()];
        cerca = std::min(cerca, cruz(glm::dvec2(0), a, b) / glm::length(b - a));
    }
    return 1 - cerca;
}

static void mideEsferas(Medidor &m) {
    glEnable(GL_DEPTH_TEST);
    const int lado = m.elige(60, 600);
    const Framebuffer framebuffer(lado, lado);
    const GLuint programa = creaSombreado("phong");
    const glm::mat4 M = escalado(1.08f); // unos 250 px de radio en 600
    const auto variante = [&](const std::string &nombre, const Malla &malla, bool convexo) {
        double mayor = 0;
        for (const glm::vec2 g : {glm::vec2(0), glm::vec2(0.7f, 0.4f), glm::vec2(1.57f, 0.1f)})
            if (convexo || g == glm::vec2(0)) // el toro, de frente
                mayor = std::max(mayor, hundimiento(malla, giroX(g.x) * giroY(g.y)));
        mideIluminada({m, framebuffer, [=](const Imagen &) { return RADIO_PX * mayor; }}, framebuffer, nombre,
                      std::to_string(malla.indices.size() / 3) + " triángulos", programa, malla, M);
    };
    m.referencia = oraculo::enBytes(trazaEsfera(framebuffer, 1.08));
    m.grupo = "esfera";
    for (const int n : m.elige<std::vector<int>>({16, 64}, {16, 32, 64, 128, 256}))
        variante(formatea("esfera de %d", n), esfera(n), true);
    variante("esfera, segmentosEsfera", esfera(segmentosEsfera(RADIO_PX)), true);
    m.referencia = {};
    m.grupo = "toro";
    for (const int n : m.elige<std::vector<int>>({32}, {32, 64, 128}))
        variante(formatea("toro de %d×%d", n, n / 2), toro(0.7f, 0.3f, n, n / 2), false);
    const int n = segmentosPara(RADIO_PX, 0.5f);
    variante("toro, segmentosPara", toro(0.7f, 0.3f, n, n / 2), false);
}

static const Apunta APUNTA({5, "esferas", "Esferas y toros", "ms por imagen de 600×600 con Phong",
                            "píxeles que se hunde el contorno, con 250 de radio", "esfera, segmentosEsfera",
                            "El tiempo casi no depende de los segmentos hasta que los triángulos son más "
                            "pequeños que unos pocos píxeles: los "
                            "programas piden los justos para un cuarto de píxel.",
                            mideEsferas});
