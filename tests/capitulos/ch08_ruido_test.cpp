// El ruido de ch08_texturas_avanzadas: ruido.h contra su definición escrita aparte en doble, su gradiente contra
// diferencias, y ruido.glsl, ejecutado en un framebuffer en float, contra ruido.h.
#include "ch08_oraculo.h"
#include "ch08_texturas_avanzadas/ruido.h"
#include "shader.h"
#include "sonda.h"
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <random>
#include <set>

namespace {

using glm::dvec3;
using glm::ivec3;

class Azar {
    std::mt19937 motor{8};

public:
    dvec3 punto(double r) {
        std::uniform_real_distribution<double> d(-r, r);
        const double x = d(motor), y = d(motor), z = d(motor);
        return {x, y, z};
    }
};

const ivec3 PERIODOS[] = {{0, 0, 0}, {4, 4, 4}, {1, 2, 3}, {0, 7, 0}, {5, 0, 16}};

} // namespace

TEST(Ruido, ContraSuDefinicionEnDoble) {
    Azar azar;
    for (const ivec3 &periodo : PERIODOS)
        for (int i = 0; i < 4000; ++i) {
            const dvec3 p = azar.punto(i % 2 ? 3 : 1000);
            EXPECT_NEAR(ruido(p, periodo), definicion::ruido(p, periodo), 1e-12);
            EXPECT_NEAR(turbulencia(p, 5, periodo), definicion::turbulencia(p, 5, periodo), 1e-12);
        }
}

// En float, el error es el de redondear: la quíntica resta números de hasta 10 (1e-6) que multiplican a rampas de hasta 2.
TEST(Ruido, EnFloat) {
    Azar azar;
    for (int i = 0; i < 4000; ++i) {
        const glm::vec3 p(azar.punto(50)),
            q(azar.punto(4)); // al correr cada octava se pierde media cifra de p
        EXPECT_NEAR(double(ruido(p)), definicion::ruido(dvec3(p)), 3e-6);
        EXPECT_NEAR(double(turbulencia(q, 4)), definicion::turbulencia(dvec3(q), 4), 6e-6);
    }
}

// Diferencias centradas con paso h: su error es de orden h² · 30 y el de cancelación, de 1e-16 / h.
TEST(Ruido, GradienteContraDiferenciasEnDoble) {
    Azar azar;
    const double h = 1e-5;
    for (const ivec3 &periodo : PERIODOS)
        for (int i = 0; i < 2000; ++i) {
            dvec3 p = azar.punto(20);
            if (i % 4 == 0)
                p[i % 3] = std::round(p[i % 3]); // sobre un plano de la rejilla
            const auto g = ruidoConGradiente(p, periodo), gt = turbulenciaConGradiente(p, 4, periodo);
            for (int k = 0; k < 3; ++k) {
                dvec3 d(0);
                d[k] = h;
                EXPECT_NEAR(g[k],
                            (definicion::ruido(p + d, periodo) - definicion::ruido(p - d, periodo)) / (2 * h),
                            1e-8);
                EXPECT_NEAR(gt[k],
                            (definicion::turbulencia(p + d, 4, periodo) -
                             definicion::turbulencia(p - d, 4, periodo)) /
                                (2 * h),
                            1e-6);
            }
        }
}

// A los dos lados de un plano de la rejilla, valor, gradiente y su derivada son casi iguales: no hay costura.
TEST(Ruido, SinCosturaEnLosPlanosDeLaRejilla) {
    Azar azar;
    const double d = 1e-6;
    for (int i = 0; i < 3000; ++i) {
        dvec3 p = azar.punto(9), q = p;
        const int eje = i % 3;
        q[eje] = (p[eje] = std::round(p[eje])) + d;
        p[eje] -= d;
        const auto a = ruidoConGradiente(p), b = ruidoConGradiente(q);
        EXPECT_NEAR(a.w, b.w, 4 * d);
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(a[k], b[k], 40 * d);
    }
    // el mayor float por debajo de 0 y los que tiene al lado un entero
    for (const float x : {-1e-30f, -1e-9f, std::nextafter(3.0f, 0.0f), std::nextafter(-3.0f, 0.0f)})
        EXPECT_NEAR(ruido(glm::vec3(x, 0.3f, 0.7f)), ruido(glm::vec3(std::round(x), 0.3f, 0.7f)), 2e-6f);
}

TEST(Ruido, ValeCeroEnLosNodosYNoEsConstante) {
    std::set<double> valores;
    for (int i = -50; i < 50; ++i) {
        EXPECT_EQ(ruido(dvec3(i, 3 * i + 1, -7 * i)), 0);
        valores.insert(ruido(dvec3(i + 0.4, 0.2, 0.7)));
    }
    EXPECT_GT(valores.size(), 20u);
}

TEST(Ruido, Periodo) {
    Azar azar;
    for (const ivec3 &periodo : PERIODOS)
        for (int i = 0; i < 500; ++i) {
            const dvec3 p = azar.punto(10);
            const dvec3 salto = dvec3(periodo) * glm::floor(azar.punto(4));
            EXPECT_NEAR(ruido(p, periodo), ruido(p + salto, periodo), 1e-12);
            EXPECT_NEAR(turbulencia(p, 3, periodo), turbulencia(p + salto, 3, periodo), 1e-12);
        }
    // sin periodo no se repite, ni es simétrico
    int distintos = 0;
    for (int i = 0; i < 100; ++i) {
        const dvec3 p = azar.punto(10);
        distintos += std::fabs(ruido(p) - ruido(p + dvec3(4, 0, 0))) > 1e-3 &&
                     std::fabs(ruido(p) - ruido(-p)) > 1e-3 &&
                     std::fabs(ruido(p) - ruido(dvec3(p.y, p.x, p.z))) > 1e-3;
    }
    EXPECT_GT(distintos, 90);
}

// Lo más que puede valer en un punto de una celda es la media ponderada de la rampa más alta de cada esquina: la de un
// gradiente que anula la menor de las tres distancias. Su máximo en la celda es la cota que dice ruido.glsl.
TEST(Ruido, CotaDelValor) {
    double cota = 0;
    const int n = 64;
    for (int x = 0; x <= n; ++x)
        for (int y = 0; y <= n; ++y)
            for (int z = 0; z <= n; ++z) {
                double suma = 0;
                for (int i = 0; i < 8; ++i) {
                    const dvec3 e(i & 1, i >> 1 & 1, i >> 2), f = dvec3(x, y, z) / double(n),
                                                              d = glm::abs(f - e);
                    double peso = 1;
                    for (int k = 0; k < 3; ++k)
                        peso *= definicion::quintica(e[k] > 0 ? f[k] : 1 - f[k]);
                    suma += peso * (d.x + d.y + d.z - std::min({d.x, d.y, d.z}));
                }
                cota = std::max(cota, suma);
            }
    EXPECT_LT(cota, 1.04);
    EXPECT_GT(cota, 1.03); // y no es una cota holgada
    Azar azar;
    double mayor = 0, menor = 0, suma = 0, cuadrados = 0;
    const int muestras = 200000;
    for (int i = 0; i < muestras; ++i) {
        const double r = ruido(azar.punto(500));
        mayor = std::max(mayor, r), menor = std::min(menor, r);
        suma += r, cuadrados += r * r;
    }
    EXPECT_LT(mayor, 1.04);
    EXPECT_GT(menor, -1.04);
    EXPECT_GT(mayor, 0.8);
    EXPECT_LT(menor, -0.8);
    EXPECT_NEAR(suma / muestras, 0, 0.005);
    EXPECT_NEAR(std::sqrt(cuadrados / muestras), 0.28, 0.03);
}

// Donde un float ya no tiene decimales todo son nodos: 0, y el gradiente es finito.
TEST(Ruido, CoordenadasEnormes) {
    for (const float x : {8388608.0f, 16777216.0f, -16777218.0f, 2147483648.0f, -4e9f, 1e20f, -3e38f})
        for (const ivec3 &periodo : PERIODOS) {
            EXPECT_EQ(ruido(glm::vec3(x, -x, x), periodo), 0) << x;
            const glm::vec4 r = ruidoConGradiente(glm::vec3(x, 0.3f, -0.7f), periodo);
            for (int k = 0; k < 4; ++k)
                EXPECT_LE(std::fabs(r[k]), 4) << x;
        }
    // en los ejes que sí tienen decimales sigue valiendo lo que debe
    EXPECT_NEAR(double(ruido(glm::vec3(16777216, 0.3f, 0.7f))),
                definicion::ruido({16777216, double(0.3f), double(0.7f)}), 1e-6);
}

// --- GLSL ---

class SondaRuido : public testing::Test {
protected:
    static GLuint programa;

    static void SetUpTestSuite() {
        programa = creaSonda("tests/capitulos/ch08_sonda.frag");
        glUseProgram(programa);
    }

    /// Con 0 octavas, el ruido.
    static glm::vec4 glsl(const glm::vec3 &p, const ivec3 &periodo, int octavas = 0) {
        envia(programa, "p", p);
        envia(programa, "periodoX", periodo.x);
        envia(programa, "periodoY", periodo.y);
        envia(programa, "periodoZ", periodo.z);
        envia(programa, "octavas", octavas);
        return leeSonda();
    }
};
GLuint SondaRuido::programa = 0;

TEST_F(SondaRuido, GlslDaLoMismoQueCpp) {
    Azar azar;
    double maximo = 0, maximoTurbulencia = 0;
    const auto compara = [&](const glm::vec3 &p, const ivec3 &periodo) {
        const glm::vec4 a = glsl(p, periodo), b = glsl(p, periodo, 4);
        const glm::dvec4 r = ruidoConGradiente(dvec3(p), periodo), t = turbulenciaConGradiente(p, 4, periodo);
        for (int k = 0; k < 4; ++k) {
            maximo = std::max(maximo, std::fabs(double(a[k]) - r[k]));
            maximoTurbulencia = std::max(maximoTurbulencia, std::fabs(double(b[k]) - t[k]));
        }
    };
    for (const ivec3 &periodo : PERIODOS)
        for (int i = 0; i < 1500; ++i)
            compara(glm::vec3(azar.punto(i % 3 ? 4 : 300)), periodo);
    for (const float x : {0.0f, -1.0f, -1e-9f, 5.0f, -8388609.0f, 16777216.0f, -16777218.0f, 1e20f, -3e38f})
        for (const ivec3 &periodo : PERIODOS)
            compara({x, 0.3f, -7.6f}, periodo);
    RecordProperty("maximo", std::to_string(maximo));
    RecordProperty("maximoTurbulencia", std::to_string(maximoTurbulencia));
    EXPECT_LT(maximo, 1e-5);
    EXPECT_LT(maximoTurbulencia, 1e-5);
}
