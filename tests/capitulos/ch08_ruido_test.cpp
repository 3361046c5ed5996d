// El ruido de ch08_texturas_avanzadas: ruido.h contra su definición escrita aparte en doble, su gradiente contra
// diferencias, y ruido.glsl, ejecutado en un framebuffer en float, contra ruido.h.
#include "azar.h"
#include "ch08_oraculo.h"
#include "ch08_texturas_avanzadas/ruido.h"
#include "sonda.h"

namespace {

using glm::dvec3;
using glm::ivec3;

const ivec3 PERIODOS[] = {{0, 0, 0}, {4, 4, 4}, {1, 2, 3}, {0, 7, 0}, {5, 0, 16}};

} // namespace

// En float, el error es el de redondear: la quíntica resta números de hasta 10 (1e-6) que multiplican a rampas de hasta
// 2.
TEST(Ruido, ContraSuDefinicionEnDoble) {
    Azar azar(8);
    const double tallas[] = {3, 1000, 5e7}; // en la quinta octava, 8e8: a partir de 2³⁰ se acota
    for (const ivec3 &periodo : PERIODOS)
        for (int i = 0; i < 4000; ++i) {
            const dvec3 p = azar.punto(tallas[i % 3]);
            EXPECT_NEAR(ruido(p, periodo), definicion::ruido(p, periodo), 1e-12);
            EXPECT_NEAR(turbulencia(p, 5, periodo), definicion::turbulencia(p, 5, periodo), 1e-12);
            const glm::vec3 f(azar.punto(50)),
                g(azar.punto(4)); // al correr cada octava se pierde media cifra
            EXPECT_NEAR(double(ruido(f, periodo)), definicion::ruido(f, periodo), 3e-6);
            EXPECT_NEAR(double(turbulencia(g, 4, periodo)), definicion::turbulencia(g, 4, periodo), 6e-6);
        }
}

// Diferencias centradas con paso h: su error es de orden h² · 30 y el de cancelación, de 1e-16 / h.
TEST(Ruido, GradienteContraDiferenciasEnDoble) {
    Azar azar(8);
    const double h = 1e-5;
    for (const ivec3 &periodo : PERIODOS)
        for (int i = 0; i < 2000; ++i) {
            dvec3 p = azar.punto(20);
            if (i % 4 == 0)
                p[i % 3] = std::round(p[i % 3]); // sobre un plano de la rejilla
            const auto g = ruidoConGradiente(p, periodo), gt = turbulenciaConGradiente(p, 4, periodo);
            for (int k = 0; k < 3; ++k) {
                dvec3 antes = p, despues = p;
                antes[k] -= h;
                despues[k] += h;
                const double d = definicion::ruido(despues, periodo) - definicion::ruido(antes, periodo),
                             dt = definicion::turbulencia(despues, 4, periodo) -
                                  definicion::turbulencia(antes, 4, periodo);
                EXPECT_NEAR(g[k], d / (2 * h), 1e-8);
                EXPECT_NEAR(gt[k], dt / (2 * h), 1e-6);
            }
        }
}

TEST(SondaRuido, GlslDaLoMismoQueCpp) {
    const GLuint programa = creaSonda("tests/capitulos/ch08_sonda.frag");
    glUseProgram(programa);
    const auto compara = [&](const glm::vec3 &p, const ivec3 &periodo) {
        envia(programa, "p", p);
        envia(programa, "periodo", glm::vec3(periodo));
        envia(programa, "octavas", 0);
        EXPECT_LT(glm::distance(glm::dvec4(leeSonda()), ruidoConGradiente(dvec3(p), periodo)), 1e-5) << p.x;
        if (!std::isfinite(8 * p.x))
            return; // ni la cuarta octava
        envia(programa, "octavas", 4);
        EXPECT_LT(glm::distance(leeSonda(), turbulenciaConGradiente(p, 4, periodo)), 1e-5) << p.x;
    };
    Azar azar(8);
    for (const ivec3 &periodo : PERIODOS) {
        for (int i = 0; i < 1500; ++i)
            compara(glm::vec3(azar.punto(i % 3 ? 4 : 300)), periodo);
        for (const float x : {0.0f, -0.0f, -1.0f, -1e-9f, 5.0f, -8388609.0f, 16777216.0f, -16777218.0f,
                              2147483648.0f, 1e20f, -3e38f})
            compara({x, 0.3f, -7.6f}, periodo);
    }
}
