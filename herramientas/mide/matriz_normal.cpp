// La matriz que transforma la normal, con matrices de todas clases.
#include "ch03_transformaciones/transformaciones.h"
#include "mide.h"
#include <glm/gtc/matrix_inverse.hpp>

using namespace mide;

// Grados entre N·n y la normal exacta, la de la traspuesta de la adjunta con el signo del determinante.
static double error(const glm::mat3 &N, const glm::mat3 &M, const glm::vec3 &n) {
    using V = glm::vec<3, long double>;
    const V a(M[0]), b(M[1]), c(M[2]), bc = glm::cross(b, c);
    const long double signo = glm::dot(a, bc) < 0 ? -1 : 1;
    const glm::dvec3 exacta(
        glm::normalize(signo * (bc * V(n).x + glm::cross(c, a) * V(n).y + glm::cross(a, b) * V(n).z)));
    const glm::vec3 r = N * n;
    const float mayor = std::max({std::fabs(r.x), std::fabs(r.y), std::fabs(r.z)});
    if (!(mayor > 0) || !std::isfinite(mayor))
        return 180; // sin normal: negro
    const glm::dvec3 d = glm::normalize(glm::dvec3(r / mayor));
    return glm::degrees(std::atan2(glm::length(glm::cross(d, exacta)), glm::dot(d, exacta)));
}

static glm::mat3 adjunta(const glm::mat3 &m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

static void mideMatrizNormal(Medidor &m) {
    Azar al(2);
    enum { RIGIDA, DEFORMA, DIFICIL, CLASES };
    std::vector<glm::mat3> clases[CLASES];
    for (int i = 0; i < m.elige(20, 200); ++i) {
        const glm::mat3 giro(giroEje({al(), al(), al()}, 3 * al()));
        const float e = std::pow(10.0f, 2 * al());
        const glm::mat3 deforma(escalado({e, std::pow(10.0f, al()), 1}));
        clases[RIGIDA].push_back(e * giro);
        clases[DEFORMA].push_back(giro * deforma * glm::mat3(giroX(al())));
        const glm::mat3 dificiles[5] = {1e-20f * giro, 1e20f * giro, giro * glm::mat3(escalado({-1, e, 1})),
                                        giro * glm::mat3(escalado({1, 1e-7f, 1})),
                                        glm::mat3(escalado({1, 0, 1}))};
        clases[DIFICIL].push_back(dificiles[i % 5]);
    }
    const auto variante = [&](const char *nombre, const auto &f) {
        double peor[CLASES] = {};
        for (int c = 0; c < CLASES; ++c)
            for (const glm::mat3 &M : clases[c])
                peor[c] = std::max(peor[c], error(f(M), M, glm::vec3(0.48f, 0.6f, 0.64f)));
        m.variante(
            nombre,
            formatea("giros y escalas iguales: %.2g°; escalas distintas: %.2g°; casos difíciles: %.2g°",
                     peor[0], peor[1], peor[2]),
            *std::max_element(peor, peor + CLASES), double(clases[DEFORMA].size()), [&] {
                for (const glm::mat3 &M : clases[DEFORMA])
                    usa(f(M));
            });
    };
    variante("mat3(M)", [](const glm::mat3 &M) { return M; });
    variante("par: glm::inverseTranspose", [](const glm::mat3 &M) { return glm::inverseTranspose(M); });
    variante("adjunta", adjunta);
    variante("adjunta en double con signo y escala",
             [](const glm::mat3 &M) { return matrizNormal(glm::mat4(M)); });
}

static const Apunta APUNTA({8, "matriz_normal", "La matriz de la normal", "ns por matriz",
                            "grados, la peor normal, frente a doble extendida",
                            "adjunta en double con signo y escala",
                            "Con giros y escalas iguales basta mat3(M). Solo la última vale siempre: "
                            "aplastado, diminuto, enorme o en un espejo. "
                            "Se calcula una vez por objeto, y lo que cuesta no se nota.",
                            mideMatrizNormal});
