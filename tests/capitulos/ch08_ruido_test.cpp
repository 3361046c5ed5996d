// El ruido de ch08_texturas_avanzadas: ruido.h contra su definición escrita aparte en doble, su gradiente contra
// diferencias, y ruido.glsl, ejecutado en un framebuffer en float, contra ruido.h.
#include "azar.h"
#include "ch08_oraculo.h"
#include "ch08_texturas_avanzadas/ruido.h"
#include "sonda.h"
#include <gtest/gtest.h>
#include <set>

namespace {

using glm::dvec3;
using glm::ivec3;

const ivec3 PERIODOS[] = {{0, 0, 0}, {4, 4, 4}, {1, 2, 3}, {0, 7, 0}, {5, 0, 16}};

} // namespace

// En float, el error es el de redondear: la quíntica resta números de hasta 10 (1e-6) que multiplican a rampas de hasta
// 2.
TEST(Ruido, ContraSuDefinicionEnDoble) {
    Azar azar(8);
    for (const ivec3 &periodo : PERIODOS)
        for (int i = 0; i < 4000; ++i) {
            const dvec3 p = azar.punto(i % 2 ? 3 : 1000);
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

// Vale 0 en los nodos, no es constante y sin periodo no se repite ni es simétrico.
TEST(Ruido, NoEsConstanteNiSimetrico) {
    std::set<double> valores;
    for (int i = -50; i < 50; ++i) {
        EXPECT_EQ(ruido(dvec3(i, 3 * i + 1, -7 * i)), 0);
        valores.insert(ruido(dvec3(i + 0.4, 0.2, 0.7)));
    }
    EXPECT_GT(valores.size(), 20u);
    Azar azar(8);
    int iguales = 0;
    for (int i = 0; i < 100; ++i) {
        const dvec3 p = azar.punto(10);
        for (const dvec3 &q : {p + dvec3(4, 0, 0), -p, dvec3(p.y, p.x, p.z)})
            iguales += std::fabs(ruido(p) - ruido(q)) <= 1e-3;
    }
    EXPECT_LT(iguales, 10);
}

// Lo más que puede valer en un punto de una celda es la media ponderada de la rampa más alta de cada esquina: la de un
// gradiente que anula la menor de las tres distancias. Su máximo en la celda es la cota que dice ruido.glsl.
TEST(Ruido, CotaDelValor) {
    double cota = 0;
    const int n = 64;
    for (int i = 0; i < (n + 1) * (n + 1) * (n + 1); ++i) {
        const dvec3 f = dvec3(i % (n + 1), i / (n + 1) % (n + 1), i / (n + 1) / (n + 1)) / double(n);
        double suma = 0;
        for (int k = 0; k < 8; ++k) {
            const dvec3 e(k & 1, k >> 1 & 1, k >> 2), d = glm::abs(f - e);
            const double peso =
                definicion::quintica(1 - d.x) * definicion::quintica(1 - d.y) * definicion::quintica(1 - d.z);
            suma += peso * (d.x + d.y + d.z - std::min({d.x, d.y, d.z}));
        }
        cota = std::max(cota, suma);
    }
    EXPECT_LT(cota, 1.04);
    EXPECT_GT(cota, 1.03); // y no es una cota holgada
    Azar azar(8);
    double mayor = 0, menor = 0, suma = 0, cuadrados = 0;
    const int muestras = 200000;
    for (int i = 0; i < muestras; ++i) {
        const double r = ruido(azar.punto(500));
        mayor = std::max(mayor, r);
        menor = std::min(menor, r);
        suma += r;
        cuadrados += r * r;
    }
    EXPECT_NEAR(mayor, 0.92, 0.12); // de 0.8 a 1.04
    EXPECT_NEAR(menor, -0.92, 0.12);
    EXPECT_NEAR(suma / muestras, 0, 0.005);
    EXPECT_NEAR(std::sqrt(cuadrados / muestras), 0.28, 0.03);
}

// Donde un float ya no tiene decimales todo son nodos: 0, y el gradiente es finito.
TEST(Ruido, CoordenadasEnormes) {
    for (const float x : {8388608.0f, 16777216.0f, -16777218.0f, 2147483648.0f, -4e9f, 1e20f, -3e38f})
        for (const ivec3 &periodo : PERIODOS) {
            EXPECT_EQ(ruido(glm::vec3(x, -x, x), periodo), 0) << x;
            EXPECT_LE(glm::length(ruidoConGradiente(glm::vec3(x, 0.3f, -0.7f), periodo)), 4) << x;
        }
    // en los ejes que sí tienen decimales sigue valiendo lo que debe
    const glm::vec3 p(16777216, 0.3f, 0.7f);
    EXPECT_NEAR(double(ruido(p)), definicion::ruido(p), 1e-6);
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
        for (const float x :
             {0.0f, -1.0f, -1e-9f, 5.0f, -8388609.0f, 16777216.0f, -16777218.0f, 1e20f, -3e38f})
            compara({x, 0.3f, -7.6f}, periodo);
    }
}
