// Cuántos segmentos para que una polilínea no se separe de su curva más de medio píxel.
#include "ch11_curvas/curvas.h"
#include "mide.h"

using namespace mide;

// Una cúbica casi con pico, una suave y una de grado 24, en píxeles.
static const std::vector<std::vector<glm::vec3>> CURVAS = [] {
    std::vector<std::vector<glm::vec3>> c = {{{100, 100, 0}, {1500, 900, 0}, {380, 900, 0}, {1780, 120, 0}},
                                             {{80, 400, 0}, {600, 900, 0}, {1200, 100, 0}, {1800, 600, 0}},
                                             {}};
    for (int k = 0; k <= 24; ++k)
        c[2].push_back({80.0f * float(k), k % 2 ? 900 : 150, 0});
    return c;
}();

static double aSegmento(const glm::dvec2 &p, const glm::dvec2 &a, const glm::dvec2 &b) {
    const glm::dvec2 ab = b - a;
    const double l = glm::dot(ab, ab), t = l > 0 ? glm::clamp(glm::dot(p - a, ab) / l, 0.0, 1.0) : 0;
    return glm::length(p - a - t * ab);
}

// Lo más que se separa la curva exacta de la polilínea, que la recorre en el mismo sentido.
static double error(const std::vector<glm::vec3> &curva, const std::vector<glm::vec3> &linea) {
    const std::vector<glm::dvec3> exacta(curva.begin(), curva.end());
    double mayor = 0;
    for (int i = 0; i <= 4000; ++i) {
        const glm::dvec2 p(bezier(exacta, i / 4000.0));
        double menor = INFINITO;
        for (std::size_t k = 0; k + 1 < linea.size(); ++k)
            menor = std::min(menor, aSegmento(p, glm::dvec2(linea[k]), glm::dvec2(linea[k + 1])));
        mayor = std::max(mayor, menor);
    }
    return mayor;
}

static void mideAplanado(Medidor &m) {
    const auto variante = [&](const std::string &nombre, const auto &aplana) {
        double mayor = 0;
        std::size_t segmentos = 0;
        for (const auto &curva : CURVAS) {
            const std::vector<glm::vec3> linea = aplana(curva);
            mayor = std::max(mayor, error(curva, linea));
            segmentos += linea.size() - 1;
        }
        m.variante(nombre, std::to_string(segmentos) + " segmentos", mayor, 1, [&] {
            for (const auto &curva : CURVAS)
                usa(aplana(curva));
        });
    };
    const auto uniforme = [](const auto &c, int n) {
        return polilinea([&](float u) { return bezier(c, u); }, n);
    };
    for (const int n : m.elige<std::vector<int>>({16, 128}, {8, 16, 32, 64, 128, 256}))
        variante(std::to_string(n) + " iguales", [&](const auto &c) { return uniforme(c, n); });
    variante("cota de Wang, 0.5 px", [&](const auto &c) { return uniforme(c, segmentosWang(c, 0.5)); });
    variante("por mitades, 0.5 px", [&](const auto &c) { return polilineaBezier(c, 0.5); });
    variante("por mitades, 0.1 px", [&](const auto &c) { return polilineaBezier(c, 0.1); });
}

static const Apunta
    APUNTA({3, "aplanado", "Segmentos de una curva", "µs por las tres curvas",
            "píxeles que se separa la polilínea de la curva", "por mitades, 0.5 px",
            "Un número fijo o sobra en la curva suave o falta en la de pico. La cota de Wang nunca falla, "
            "pero en grado alto "
            "pide de más en toda la curva; partir por mitades pone los segmentos donde se curva.",
            mideAplanado});
