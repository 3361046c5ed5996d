// Comprobaciones independientes de las cabeceras de curvas del capítulo 11, contra las matrices del libro y los coeficientes
// binomiales exactos en cuádruple precisión. Cada error que se mide se escribe.
#include "ch03_transformaciones/transformaciones.h"
#include "ch11_curvas/continuidad.h"
#include "ch11_curvas/curvas.h"
#include "ch11_curvas/solenoide.h"
#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace {

// la de Boost no cabe en un vector de GLM, que exige tipos triviales
#ifdef __SIZEOF_FLOAT128__
__extension__ typedef __float128 Quad;
#else
using Quad = long double;
#endif
using Entero = boost::multiprecision::cpp_int;
const Base BASES[] = {Base::HERMITE, Base::BEZIER, Base::BSPLINE};

template<typename T>
double ulp() {
    return static_cast<double>(std::numeric_limits<T>::epsilon());
}
template<typename T>
Punto<Quad> enQuad(const Punto<T> &p) {
    return {Quad(p.x), Quad(p.y), Quad(p.z)};
}
double lejos(const Punto<Quad> &a, const Punto<Quad> &b) {
    const Punto<Quad> d = a - b;
    return glm::length(glm::dvec3(d));
}
template<typename T>
double lejosDe(const Punto<T> &a, const Punto<Quad> &b) {
    return lejos(enQuad(a), b);
}

// ---- La referencia: U·M con las matrices de las ecuaciones 11.10, 11.17 y 11.26 ----

std::array<Quad, 4> pesosExactos(Base base, const Quad &u, int derivada) {
    static const int M[3][4][4] = {{{2, -2, 1, 1}, {-3, 3, -2, -1}, {0, 0, 1, 0}, {1, 0, 0, 0}},
                                   {{-1, 3, -3, 1}, {3, -6, 3, 0}, {-3, 3, 0, 0}, {1, 0, 0, 0}},
                                   {{-1, 3, -3, 1}, {3, -6, 3, 0}, {-3, 0, 3, 0}, {1, 4, 1, 0}}};
    const std::array<Quad, 4> U = derivada == 0   ? std::array<Quad, 4>{u * u * u, u * u, u, 1}
                                  : derivada == 1 ? std::array<Quad, 4>{3 * u * u, 2 * u, 1, 0}
                                                  : std::array<Quad, 4>{6 * u, 2, 0, 0};
    std::array<Quad, 4> w;
    for (std::size_t j = 0; j < 4; ++j) {
        w[j] = 0;
        for (std::size_t i = 0; i < 4; ++i)
            w[j] += U[i] * M[static_cast<int>(base)][i][j];
        if (base == Base::BSPLINE)
            w[j] /= 6;
    }
    return w;
}
template<typename T>
Punto<Quad> cubicaExacta(Base base, const Geometria<T> &G, const T &u, int derivada = 0) {
    const auto w = pesosExactos(base, Quad(u), derivada);
    Punto<Quad> p(Quad(0));
    for (std::size_t i = 0; i < 4; ++i)
        p += w[i] * enQuad(G[i]);
    return p;
}

Entero binomial(unsigned n, unsigned k) {
    Entero c = 1;
    for (unsigned i = 1; i <= k; ++i)
        c = c * (n - k + i) / i;
    return c;
}
std::vector<Quad> bernsteinExactos(std::size_t n, const Quad &u) {
    std::vector<Quad> b;
    Quad C = 1; // exacto: a grado 67, C(n,k) no llega a 2^64
    for (std::size_t k = 0; k <= n; C = C * Quad(n - k) / Quad(k + 1), ++k) {
        Quad producto = C;
        for (std::size_t i = 0; i < n; ++i)
            producto *= i < k ? u : 1 - u;
        b.push_back(producto);
    }
    return b;
}
template<typename T>
Punto<Quad> bezierExacta(const std::vector<Punto<T>> &P, const T &u) {
    const std::vector<Quad> b = bernsteinExactos(P.size() - 1, Quad(u));
    Punto<Quad> p(Quad(0));
    for (std::size_t k = 0; k < P.size(); ++k)
        p += b[k] * enQuad(P[k]);
    return p;
}

template<typename T>
struct Azar {
    std::mt19937 motor{11};
    std::uniform_real_distribution<double> en{-1, 1};
    T numero() {
        return static_cast<T>(en(motor));
    }
    Punto<T> punto(double lejano = 0) {
        const auto uno = [&] { return static_cast<T>(lejano + en(motor)); };
        const T x = uno(), y = uno(), z = uno();
        return {x, y, z};
    }
    Geometria<T> geometria(double lejano = 0) {
        Geometria<T> G;
        for (auto &p : G)
            p = punto(lejano);
        return G;
    }
    std::vector<Punto<T>> puntos(std::size_t n, double lejano = 0) {
        std::vector<Punto<T>> P;
        for (std::size_t i = 0; i < n; ++i)
            P.push_back(punto(lejano));
        return P;
    }
};

const int MUESTRAS = 257;
template<typename T>
T enMuestra(int i) {
    return static_cast<T>(i) / static_cast<T>(MUESTRAS - 1);
}

template<typename T>
class Curvas : public testing::Test {};
using Reales = testing::Types<float, double>;
TYPED_TEST_SUITE(Curvas, Reales);

// ---- Las tres bases ----

// Ningún peso pierde cifras: el error es de unos pocos redondeos de sí mismo, y no de los sumandos de la matriz, que se anulan.
TYPED_TEST(Curvas, PesosContraLasMatricesDelLibro) {
    using T = TypeParam;
    double peor = 0, peorDerivada = 0;
    for (const Base base : BASES)
        for (int d = 0; d < 3; ++d)
            for (int i = 0; i < MUESTRAS; ++i) {
                const T u = enMuestra<T>(i);
                const auto w = pesos(base, u, d);
                const auto exactos = pesosExactos(base, Quad(u), d);
                for (std::size_t k = 0; k < 4; ++k) {
                    const double e = std::fabs(static_cast<double>(Quad(w[k]) - exactos[k])),
                                 valor = std::fabs(static_cast<double>(exactos[k]));
                    if (d == 0 && valor > 0)
                        peor = std::max(peor, e / valor);
                    else
                        peorDerivada = std::max(peorDerivada, e);
                }
            }
    std::printf("pesos: error relativo %.2f ulp; de las derivadas, absoluto %.2f ulp\n", peor / ulp<T>(),
                peorDerivada / ulp<T>());
    EXPECT_LT(peor, 6 * ulp<T>());
    EXPECT_LT(peorDerivada, 12 * ulp<T>());
}

TYPED_TEST(Curvas, PesosQueSuman1YDerivadasQueSuman0) {
    using T = TypeParam;
    for (const Base base : BASES)
        for (int d = 0; d < 3; ++d)
            for (int i = 0; i < MUESTRAS; ++i) {
                const auto w = pesos(base, enMuestra<T>(i), d);
                T suma = 0;
                for (std::size_t k = 0; k < puntosDe(base); ++k)
                    suma += w[k];
                EXPECT_NEAR(static_cast<double>(suma), d == 0 ? 1 : 0, 12 * ulp<T>());
            }
}

// Puntos en el cubo de lado 2: error de la curva y de sus dos derivadas.
TYPED_TEST(Curvas, CubicasContraCuadruplePrecision) {
    using T = TypeParam;
    const char *const nombres[] = {"Hermite", "Bézier", "B-Spline"};
    const double COTA[] = {4, 40, 160}; // en ulp: sumas de cuatro productos de hasta 1, 6 y 24
    Azar<T> azar;
    for (const Base base : BASES)
        for (int d = 0; d < 3; ++d) {
            double peor = 0;
            for (int vez = 0; vez < 20; ++vez) {
                const Geometria<T> G = azar.geometria();
                for (int i = 0; i < MUESTRAS; i += 4)
                    peor = std::max(peor, lejosDe(cubica(base, G, enMuestra<T>(i), d),
                                                  cubicaExacta(base, G, enMuestra<T>(i), d)));
            }
            std::printf("%s, derivada %d: error máximo %.3g (%.2f ulp)\n", nombres[static_cast<int>(base)], d,
                        peor, peor / ulp<T>());
            EXPECT_LT(peor, COTA[d] * ulp<T>());
        }
}

// A 1e8 del origen, en float los puntos están a 8 unidades unos de otros. La curva se separa unos redondeos de 1e8; sus
// derivadas, solo lo que las de esos mismos puntos traídos al origen: la resta es exacta.
TYPED_TEST(Curvas, PuntosA1e8DelOrigen) {
    using T = TypeParam;
    Azar<T> azar;
    for (const Base base : {Base::BEZIER, Base::BSPLINE}) {
        double peor = 0, peorDerivada = 0;
        for (int vez = 0; vez < 20; ++vez) {
            Geometria<T> G;
            for (auto &p : G)
                p = Punto<T>(T(1e8)) + T(1000) * azar.punto();
            for (int i = 0; i < MUESTRAS; i += 4) {
                const T u = enMuestra<T>(i);
                peor = std::max(peor, lejosDe(cubica(base, G, u), cubicaExacta(base, G, u)));
                for (int d = 1; d < 3; ++d)
                    peorDerivada =
                        std::max(peorDerivada, lejosDe(cubica(base, G, u, d), cubicaExacta(base, G, u, d)));
            }
        }
        std::printf("a 1e8: la curva, %.2f ulp de 1e8; sus derivadas, %.3g de 1000\n",
                    peor / (1e8 * ulp<T>()), peorDerivada / 1000);
        EXPECT_LT(peor, 6 * 1e8 * ulp<T>());
        EXPECT_LT(peorDerivada, 200 * 1000 * ulp<T>());
    }
    // y una curva de grado 60
    std::vector<Punto<T>> P;
    for (int i = 0; i <= 60; ++i)
        P.push_back(Punto<T>(T(1e8)) + T(1000) * azar.punto());
    double peor = 0;
    for (int i = 0; i < MUESTRAS; i += 16)
        peor = std::max(peor, lejosDe(bezier(P, enMuestra<T>(i)), bezierExacta(P, enMuestra<T>(i))));
    std::printf("a 1e8, grado 60: %.2f ulp de 1e8\n", peor / (1e8 * ulp<T>()));
    EXPECT_LT(peor, 60 * 1e8 * ulp<T>());
}

TYPED_TEST(Curvas, ExtremosYTangentesExactos) {
    using T = TypeParam;
    Azar<T> azar;
    for (int vez = 0; vez < 50; ++vez) {
        const Geometria<T> G = azar.geometria();
        EXPECT_EQ(cubica(Base::HERMITE, G, T(0)), G[0]);
        EXPECT_EQ(cubica(Base::HERMITE, G, T(1)), G[1]);
        EXPECT_EQ(cubica(Base::HERMITE, G, T(0), 1), G[2]);
        EXPECT_EQ(cubica(Base::HERMITE, G, T(1), 1), G[3]);
        EXPECT_EQ(cubica(Base::BEZIER, G, T(0)), G[0]);
        EXPECT_EQ(cubica(Base::BEZIER, G, T(1)), G[3]);
        // ecuación 11.12
        EXPECT_LT(lejosDe(cubica(Base::BEZIER, G, T(0), 1), Quad(3) * (enQuad(G[1]) - enQuad(G[0]))),
                  20 * ulp<T>());
        EXPECT_LT(lejosDe(cubica(Base::BEZIER, G, T(1), 1), Quad(3) * (enQuad(G[3]) - enQuad(G[2]))),
                  20 * ulp<T>());
        for (const std::size_t n : {1u, 2u, 4u, 11u, 21u, 41u, 61u}) {
            const std::vector<Punto<T>> P = azar.puntos(n);
            EXPECT_EQ(bezier(P, T(0)), P.front());
            EXPECT_EQ(bezier(P, T(1)), P.back());
        }
    }
}

// Puntos repetidos y tangentes nulas: la curva es el punto, y su curvatura, 0; nunca un NaN.
TYPED_TEST(Curvas, PuntosCoincidentesYTangentesNulas) {
    using T = TypeParam;
    const Punto<T> p(T(0.3), T(-0.7), T(1.1)), cero(T(0));
    for (int i = 0; i < MUESTRAS; ++i) {
        const T u = enMuestra<T>(i);
        for (const Base base : BASES) {
            const Geometria<T> G =
                base == Base::HERMITE ? Geometria<T>{p, p, cero, cero} : Geometria<T>{p, p, p, p};
            EXPECT_LT(lejosDe(cubica(base, G, u), enQuad(p)), 4 * ulp<T>());
            EXPECT_EQ(cubica(base, G, u, 1), cero);
            EXPECT_EQ(cubica(base, G, u, 2), cero);
            EXPECT_EQ(curvatura(cubica(base, G, u, 1), cubica(base, G, u, 2)), cero);
            EXPECT_EQ(segmentosCubica(base, G, 1e-3), 1);
        }
        EXPECT_LT(lejosDe(bezier(std::vector<Punto<T>>(61, p), u), enQuad(p)), 61 * ulp<T>());
    }
    EXPECT_EQ(polilineaBezier(std::vector<Punto<T>>(61, p), 1e-3).size(), 2u);
    // P1 = P2: la curva arranca parada, y la tangente que se ve es la de la segunda derivada
    const Geometria<T> G = {p, p, p + Punto<T>(T(1), T(0), T(0)), p + Punto<T>(T(1), T(1), T(0))};
    EXPECT_EQ(cubica(Base::BEZIER, G, T(0), 1), cero);
    EXPECT_LT(lejosDe(cubica(Base::BEZIER, G, T(0), 2), {Quad(6), Quad(0), Quad(0)}), 20 * ulp<T>());
    const Punto<T> k = curvatura(cubica(Base::BEZIER, G, T(0), 1), cubica(Base::BEZIER, G, T(0), 2));
    EXPECT_EQ(k, cero);
}

// Q(u) de una parábola y = x²/2 tiene en x radio (1 + x²)^(3/2).
TYPED_TEST(Curvas, CurvaturaDeUnaParabola) {
    using T = TypeParam;
    for (int i = 0; i < MUESTRAS; ++i) {
        const double x = 4.0 * i / (MUESTRAS - 1) - 2;
        const T d = static_cast<T>(x);
        const Punto<T> k = curvatura(Punto<T>(T(7), T(7) * d, T(0)), Punto<T>(T(5), T(5) * d + T(49), T(0)));
        EXPECT_NEAR(static_cast<double>(glm::length(k)), std::pow(1 + x * x, -1.5), 20 * ulp<T>());
        EXPECT_GT(k.y, 0); // hacia dentro
        EXPECT_NEAR(static_cast<double>(k.x + d * k.y), 0, 20 * ulp<T>());
    }
}

// T(Q(u)) = Q(T)(u) para T afín: las tangentes, que son vectores, no se trasladan (ejercicio 11.6).
TEST(Hermite, TransformarLasRestriccionesOLosPuntos) {
    Azar<float> azar;
    const glm::mat4 T = traslacion({0.3f, -0.2f, 0.7f}) * giroZ(-0.5f) * escalado({0.75f, 0.5f, 1.5f});
    double peor = 0, trasladadas = 0;
    for (int vez = 0; vez < 20; ++vez) {
        const Geometria<float> G = azar.geometria();
        Geometria<float> GT, mal;
        for (std::size_t i = 0; i < 4; ++i) {
            GT[i] = T * glm::vec4(G[i], i < 2 ? 1 : 0);
            mal[i] = T * glm::vec4(G[i], 1);
        }
        for (int i = 0; i < MUESTRAS; ++i) {
            const float u = enMuestra<float>(i);
            const glm::vec3 Q = T * glm::vec4(cubica(Base::HERMITE, G, u), 1);
            peor = std::max(peor, static_cast<double>(glm::distance(Q, cubica(Base::HERMITE, GT, u))));
            trasladadas =
                std::max(trasladadas, static_cast<double>(glm::distance(Q, cubica(Base::HERMITE, mal, u))));
        }
    }
    std::printf("T(Q) y Q(T) se separan %.2g; trasladando también las tangentes, %.2g\n", peor, trasladadas);
    EXPECT_LT(peor, 2e-6);
    EXPECT_GT(trasladadas, 0.05);
}

// El segundo tramo G1 del ejercicio 11.6: (P4, P4', k·R4, R4').
TEST(Hermite, DosTramosG1) {
    Azar<float> azar;
    for (const float k : {0.2f, 0.5f, 1.0f, 3.0f}) {
        const Geometria<float> G = azar.geometria(), G2 = {G[1], azar.punto(), k * G[3], azar.punto()};
        EXPECT_EQ(cubica(Base::HERMITE, G, 1.0f), cubica(Base::HERMITE, G2, 0.0f));
        EXPECT_EQ(k * cubica(Base::HERMITE, G, 1.0f, 1), cubica(Base::HERMITE, G2, 0.0f, 1));
    }
}

TYPED_TEST(Curvas, LaMismaCurvaEnBezier) {
    using T = TypeParam;
    Azar<T> azar;
    double peor = 0;
    for (const Base base : BASES)
        for (int vez = 0; vez < 20; ++vez) {
            const Geometria<T> G = azar.geometria(), B = aBezier(base, G);
            const std::vector<Punto<T>> P(B.begin(), B.end());
            for (int i = 0; i < MUESTRAS; i += 8) {
                const T u = enMuestra<T>(i);
                peor = std::max(peor, lejosDe(cubica(Base::BEZIER, B, u), cubicaExacta(base, G, u)));
                peor = std::max(peor, lejosDe(bezier(P, u), cubicaExacta(base, G, u)));
            }
        }
    std::printf("pasada a Bézier: %.2f ulp\n", peor / ulp<T>());
    EXPECT_LT(peor, 8 * ulp<T>());
}

// La curva no sale del casco: está al lado de dentro de cada recta que deja a un lado todos los puntos de control.
TYPED_TEST(Curvas, CascoConvexo) {
    using T = TypeParam;
    Azar<T> azar;
    for (const std::size_t n : {4u, 11u, 61u})
        for (int vez = 0; vez < 5; ++vez) {
            std::vector<Punto<T>> P = azar.puntos(n);
            for (int i = 0; i < MUESTRAS; i += 8) {
                const Punto<T> Q = bezier(P, enMuestra<T>(i));
                for (int direccion = 0; direccion < 64; ++direccion) {
                    const double a = 2 * M_PI * direccion / 64;
                    const auto sombra = [&](const Punto<T> &p) {
                        return std::cos(a) * static_cast<double>(p.x) +
                               std::sin(a) * static_cast<double>(p.y);
                    };
                    double mayor = -10;
                    for (const Punto<T> &p : P)
                        mayor = std::max(mayor, sombra(p));
                    EXPECT_LE(sombra(Q), mayor + 4 * ulp<T>());
                }
            }
        }
}

// ---- Grado n ----

TYPED_TEST(Curvas, BezierDeGrado10_20_40_60) {
    using T = TypeParam;
    Azar<T> azar;
    for (const std::size_t n : {1u, 3u, 10u, 20u, 40u, 60u}) {
        const std::vector<Punto<T>> P = azar.puntos(n + 1);
        double peor = 0, peorDerivada = 0, peorPeso = 0, peorSuma = 0;
        for (int i = 0; i < MUESTRAS; i += 8) {
            const T u = enMuestra<T>(i);
            const Punto<Quad> exacto = bezierExacta(P, u);
            peor = std::max(peor, lejosDe(bezier(P, u), exacto));
            // la derivada, con la ecuación 11.20: b'_{k,n} = n·(b_{k−1,n−1} − b_{k,n−1})
            const std::vector<Quad> b = bernsteinExactos(n - 1, Quad(u));
            Punto<Quad> d(Quad(0));
            for (std::size_t k = 0; k <= n; ++k)
                d += Quad(n) * ((k > 0 ? b[k - 1] : Quad(0)) - (k < n ? b[k] : Quad(0))) * enQuad(P[k]);
            peorDerivada =
                std::max(peorDerivada, lejosDe(bezier(derivadaBezier(P), u), d) / static_cast<double>(n));
            const std::vector<T> pesosN = bernstein(n, u);
            ASSERT_EQ(pesosN.size(), n + 1);
            const std::vector<Quad> exactos = bernsteinExactos(n, Quad(u));
            T suma = 0;
            for (std::size_t k = 0; k <= n; ++k) {
                suma += pesosN[k];
                peorPeso = std::max(peorPeso, std::fabs(static_cast<double>(Quad(pesosN[k]) - exactos[k])));
            }
            peorSuma = std::max(peorSuma, std::fabs(static_cast<double>(suma) - 1));
        }
        std::printf("grado %zu: curva %.3g (%.1f ulp), derivada/n %.1f ulp, Bernstein %.1f ulp, su suma − 1, "
                    "%.1f ulp\n",
                    n, peor, peor / ulp<T>(), peorDerivada / ulp<T>(), peorPeso / ulp<T>(),
                    peorSuma / ulp<T>());
        // cada nivel promedia y redondea: n niveles, tres redondeos en cada uno, de medio ulp y tres coordenadas
        const double cota = 1.5 * std::sqrt(3.0) * static_cast<double>(n) * ulp<T>();
        EXPECT_LE(peor, cota);
        EXPECT_LE(peorDerivada, 4 * cota);
        EXPECT_LE(peorPeso, cota);
        EXPECT_LE(peorSuma, cota);
    }
}

// La curva entera en cuádruple precisión da lo mismo que los coeficientes exactos: las plantillas valen para los tres tipos.
TEST(CurvasN, ElMismoCodigoEnCuadruplePrecision) {
    Azar<double> azar;
    for (const std::size_t n : {3u, 60u}) {
        const std::vector<Punto<double>> P = azar.puntos(n + 1);
        std::vector<Punto<Quad>> Q;
        for (const auto &p : P)
            Q.push_back(enQuad(p));
        for (int i = 0; i < MUESTRAS; i += 16)
            EXPECT_LT(lejos(bezier(Q, enMuestra<Quad>(i)), bezierExacta(Q, enMuestra<Quad>(i))), 1e-31);
        EXPECT_EQ(polilineaBezier(Q, 1e-3).size(), polilineaBezier(P, 1e-3).size());
    }
    const Geometria<Quad> G = {Punto<Quad>(1), Punto<Quad>(2), Punto<Quad>(-1), Punto<Quad>(3)};
    for (const Base base : BASES) {
        EXPECT_LT(lejos(cubica(base, G, Quad(0.3)), cubicaExacta(base, G, Quad(0.3))), 1e-32);
        EXPECT_GE(segmentosCubica(base, G, 1e-3), 1);
    }
    EXPECT_EQ(curvatura(Punto<Quad>(Quad(0)), Punto<Quad>(Quad(1))), Punto<Quad>(Quad(0)));
}

// Los factoriales de la ecuación 11.21 no caben; la recurrencia y de Casteljau no los usan.
TEST(CurvasN, FactorialesQueNoCaben) {
    const auto factorial = [](int n) {
        Entero f = 1;
        for (int i = 2; i <= n; ++i)
            f *= i;
        return f;
    };
    EXPECT_LE(factorial(12), Entero(INT32_MAX));
    EXPECT_GT(factorial(13), Entero(INT32_MAX));
    EXPECT_LE(factorial(20), Entero(INT64_MAX));
    EXPECT_GT(factorial(21), Entero(INT64_MAX));
    float f = 1;
    for (int i = 2; i <= 34; ++i)
        f *= static_cast<float>(i);
    EXPECT_TRUE(std::isfinite(f));
    EXPECT_TRUE(std::isinf(f * 35)); // 35!
    EXPECT_LE(binomial(66, 33), Entero(INT64_MAX));
    EXPECT_GT(binomial(67, 33), Entero(INT64_MAX));
    for (const std::size_t n : {13u, 21u, 35u, 67u}) {
        const std::vector<float> b = bernstein(n, 0.5f);
        const std::vector<Quad> exactos = bernsteinExactos(n, Quad(0.5));
        double peor = 0;
        for (std::size_t k = 0; k <= n; ++k)
            peor = std::max(peor, std::fabs(static_cast<double>((Quad(b[k]) - exactos[k]) / exactos[k])));
        std::printf("grado %zu, u = 0.5: error relativo del peor Bernstein %.2g\n", n, peor);
        EXPECT_LT(peor, static_cast<double>(n) * ulp<float>());
    }
}

// Los extremos: en u = 0 y 1 un solo polinomio vale 1 y los demás 0, exactos.
TEST(CurvasN, BernsteinEnLosExtremos) {
    for (const std::size_t n : {0u, 1u, 3u, 60u})
        for (const float u : {0.0f, 1.0f}) {
            const std::vector<float> b = bernstein(n, u);
            for (std::size_t k = 0; k <= n; ++k)
                EXPECT_EQ(b[k], (u == 0 ? k == 0 : k == n) ? 1.0f : 0.0f);
        }
    EXPECT_EQ(derivadaBezier(std::vector<glm::vec3>{glm::vec3(1)})[0], glm::vec3(0));
}

// Errata de §11.3: con k puntos la curva es de grado k − 1 (orden k), y la suma de la ecuación 11.22 tiene n + 1 sumandos.
TEST(Erratas, GradoYOrden) {
    const std::vector<glm::dvec3> P = Azar<double>().puntos(4);
    auto grado = derivadaBezier(P);
    std::size_t derivadas = 1;
    for (; glm::length(grado[0]) > 0 && grado.size() > 1; ++derivadas)
        grado = derivadaBezier(grado);
    EXPECT_EQ(derivadas, 3u); // cuatro puntos: la tercera derivada es constante y la cuarta, 0
    EXPECT_EQ(derivadaBezier(grado)[0], glm::dvec3(0));
    EXPECT_EQ(bernstein(4 - 1, 0.5).size(), 4u);
}

// Lo que dice el pie de bezier_n con 40 puntos.
TEST(CurvasN, ConCuarentaPuntosElDelCentroNoPesaNi013) {
    float mayor = 0;
    for (int i = 0; i < MUESTRAS; ++i)
        mayor = std::max(mayor, bernstein(39, enMuestra<float>(i))[19]);
    EXPECT_LT(mayor, 0.13f);
    EXPECT_GT(mayor, 0.12f);
}

// De Casteljau, nivel a nivel.
TEST(CurvasN, NivelesDeCasteljau) {
    const std::vector<glm::vec3> P = {{0, 0, 0}, {4, 0, 0}, {4, 8, 0}, {0, 8, 4}};
    const auto niveles = casteljau(P, 0.25f);
    ASSERT_EQ(niveles.size(), 4u);
    EXPECT_EQ(niveles[0], P);
    EXPECT_EQ(niveles[1], (std::vector<glm::vec3>{{1, 0, 0}, {4, 2, 0}, {3, 8, 1}}));
    EXPECT_EQ(niveles[2], (std::vector<glm::vec3>{{1.75f, 0.5f, 0}, {3.75f, 3.5f, 0.25f}}));
    EXPECT_EQ(niveles[3], (std::vector<glm::vec3>{{2.25f, 1.25f, 0.0625f}}));
}

// ---- B-Spline ----

TEST(BSpline, TramosAbiertaYCerrada) {
    for (const bool cerrada : {false, true})
        for (std::size_t n = 0; n < 4; ++n)
            EXPECT_EQ(tramosBSpline(n, cerrada), 0u);
    for (std::size_t m = 3; m < 12; ++m) {
        EXPECT_EQ(tramosBSpline(m + 1, false), m - 2); // los que dice el libro
        // cerrada: la abierta de P0 … Pm, P0, P1, P2
        EXPECT_EQ(tramosBSpline(m + 1, true), tramosBSpline(m + 1 + 3, false));
    }
    std::vector<glm::vec3> P = Azar<float>().puntos(9), repetidos = P;
    repetidos.insert(repetidos.end(), P.begin(), P.begin() + 3);
    for (std::size_t i = 0; i < 9; ++i)
        EXPECT_EQ(geometriaBSpline(P, i), geometriaBSpline(repetidos, i));
    EXPECT_EQ(geometriaBSpline(P, 2), (Geometria<float>{P[2], P[3], P[4], P[5]}));
}

TYPED_TEST(Curvas, BSplineC2EnLosNudos) {
    using T = TypeParam;
    const std::vector<Punto<T>> P = Azar<T>().puntos(9);
    double peor[3] = {}, salto = 0;
    for (std::size_t i = 0; i < 9; ++i) { // cerrada: también el último con el primero
        const Geometria<T> A = geometriaBSpline(P, i), B = geometriaBSpline(P, (i + 1) % 9);
        for (int d = 0; d < 3; ++d) {
            const Punto<T> a = cubica(Base::BSPLINE, A, T(1), d), b = cubica(Base::BSPLINE, B, T(0), d);
            peor[d] = std::max(peor[d], static_cast<double>(glm::distance(a, b)));
        }
        const auto tercera = [](const Geometria<T> &G) { // constante en cada tramo
            return cubica(Base::BSPLINE, G, T(1), 2) - cubica(Base::BSPLINE, G, T(0), 2);
        };
        salto = std::max(salto, static_cast<double>(glm::distance(tercera(A), tercera(B))));
        // el nudo: (P0 + 4·P1 + P2)/6
        EXPECT_LT(lejosDe(cubica(Base::BSPLINE, A, T(0)),
                          (enQuad(A[0]) + Quad(4) * enQuad(A[1]) + enQuad(A[2])) / Quad(6)),
                  4 * ulp<T>());
    }
    std::printf("saltos en los nudos: %.2g, %.2g y %.2g; de la tercera derivada, %.2g\n", peor[0], peor[1],
                peor[2], salto);
    for (const double s : peor)
        EXPECT_LT(s, 30 * ulp<T>());
    EXPECT_GT(salto, 0.1); // C2 y no C3
}

// Ejercicio 11.7: mover un punto cambia cuatro tramos, y los demás quedan iguales bit a bit.
TEST(BSpline, MoverUnPuntoCambiaCuatroTramos) {
    const std::vector<glm::vec3> P = Azar<float>().puntos(12);
    for (const bool cerrada : {false, true})
        for (std::size_t movido = 0; movido < P.size(); ++movido) {
            std::vector<glm::vec3> Q = P;
            Q[movido] += glm::vec3(0.5f, 0.25f, 0);
            std::set<std::size_t> cambian, esperados;
            for (std::size_t i = 0; i < tramosBSpline(P.size(), cerrada); ++i)
                for (int k = 1; k < 8; ++k)
                    if (cubica(Base::BSPLINE, geometriaBSpline(P, i), static_cast<float>(k) / 8) !=
                        cubica(Base::BSPLINE, geometriaBSpline(Q, i), static_cast<float>(k) / 8))
                        cambian.insert(i);
            for (int i = static_cast<int>(movido) - 3; i <= static_cast<int>(movido); ++i)
                if (cerrada)
                    esperados.insert(static_cast<std::size_t>((i + 12) % 12));
                else if (i >= 0 && i < 9)
                    esperados.insert(static_cast<std::size_t>(i));
            EXPECT_EQ(cambian, esperados);
            EXPECT_LE(cambian.size(), 4u);
        }
}

// Errata de la ecuación 11.27: Q_i(u) con u entre los nudos i e i+1 es la fórmula en u − u_i; y en u = 1 vale también.
TEST(Erratas, ArgumentoDeLaEcuacion1127) {
    const Geometria<double> G = Azar<double>().geometria();
    for (const double nudo : {0.0, 1.0, 5.0})
        for (const double u : {0.0, 0.25, 1.0}) {
            // U de la ecuación 11.24 con el parámetro global
            const double t = (nudo + u) - nudo;
            const auto U = pesosExactos(Base::BSPLINE, Quad(t), 0);
            Punto<Quad> Q(Quad(0));
            for (std::size_t k = 0; k < 4; ++k)
                Q += U[k] * enQuad(G[k]);
            EXPECT_LT(lejosDe(cubica(Base::BSPLINE, G, u), Q), 1e-15);
            // la misma fórmula con el parámetro global, tal como se lee, no es la curva
            if (nudo > 0) {
                EXPECT_GT(lejosDe(cubica(Base::BSPLINE, G, nudo + u), Q), 0.1);
            }
        }
}

// Errata de §11.4: Q_i va de u_i a u_{i+1}, así que con Q_{i+1} se une en u_{i+1}, y no en u_i.
TEST(Erratas, NudoEntreDosTramos) {
    const std::vector<glm::dvec3> P = Azar<double>().puntos(7);
    const auto tramo = [&](int i, int u) { // u_3 = 0 y de nudo a nudo hay 1
        return cubica(Base::BSPLINE, geometriaBSpline(P, static_cast<std::size_t>(i - 3)),
                      double(u - (i - 3)));
    };
    for (int i = 3; i < 6; ++i) {
        EXPECT_LT(glm::distance(tramo(i, i + 1 - 3), tramo(i + 1, i + 1 - 3)), 1e-14);
        EXPECT_GT(glm::distance(tramo(i, i - 3), tramo(i + 1, i - 3)), 0.01);
    }
}

// ---- Teselación ----

/// Lo más que la curva se aparta de la polilínea, tomando en ella el mismo parámetro.
double cuerda(const std::vector<glm::dvec3> &P, int n) {
    double peor = 0;
    for (int i = 0; i < n; ++i)
        for (int k = 1; k < 8; ++k) {
            const double t = k / 8.0, a = double(i) / n, b = double(i + 1) / n;
            peor = std::max(
                peor, glm::distance(bezier(P, a + t * (b - a)), (1 - t) * bezier(P, a) + t * bezier(P, b)));
        }
    return peor;
}

// En una parábola la cota es exacta: ni un segmento de más.
TEST(Teselacion, LaJustaEnUnaParabola) {
    const std::vector<glm::dvec3> P = {{0, 0, 0}, {1, 3, 0}, {2, 0, 0}};
    for (const double tolerancia : {0.3, 0.01, 1e-4}) {
        const int n = segmentosWang(P, tolerancia);
        EXPECT_LE(cuerda(P, n), tolerancia * (1 + 1e-9));
        EXPECT_GT(cuerda(P, n - 1), tolerancia);
        const std::vector<glm::vec3> linea = polilineaBezier(P, tolerancia);
        EXPECT_LT(linea.size(), 2u * static_cast<unsigned>(n) + 1u); // de mitad en mitad, hasta el doble
    }
    EXPECT_EQ(segmentosDerivada(0, 0.1), 1);
    EXPECT_EQ(segmentosDerivada(INFINITY, 0.1), SEGMENTOS_MAXIMOS);
    EXPECT_EQ(segmentosDerivada(8, 1), 1);
    EXPECT_EQ(segmentosDerivada(32, 1), 2);
}

TEST(Teselacion, CubicasDentroDeLaTolerancia) {
    Azar<double> azar;
    double aprovechado = 0;
    for (const Base base : BASES)
        for (int vez = 0; vez < 20; ++vez) {
            const Geometria<double> G = azar.geometria(), B = aBezier(base, G);
            const std::vector<glm::dvec3> P(B.begin(), B.end());
            const int n = segmentosCubica(base, G, 1e-3);
            EXPECT_LE(cuerda(P, n), 1e-3);
            EXPECT_LE(n, segmentosWang(P, 1e-3) + 1);
            aprovechado = std::max(aprovechado, cuerda(P, n) / 1e-3);
        }
    EXPECT_GT(aprovechado, 0.7); // la cota no es de sobra
}

// Lo que bezier_n dibuja: se mide la distancia de la curva a la polilínea.
TEST(Teselacion, GradoNAdaptativa) {
    for (const std::size_t n : {1u, 2u, 3u, 10u, 40u, 60u}) {
        std::vector<glm::dvec3> P;
        for (std::size_t i = 0; i <= n; ++i)
            P.push_back({double(i) / double(n), i % 2 ? 0.8 : -0.8, 0});
        const double tolerancia = 1e-3;
        const std::vector<glm::vec3> linea = polilineaBezier(P, tolerancia);
        EXPECT_EQ(linea.front(), glm::vec3(P.front()));
        EXPECT_EQ(linea.back(), glm::vec3(P.back()));
        double peor = 0;
        for (int k = 0; k <= 1000; ++k) {
            const glm::dvec3 Q = bezier(P, k / 1000.0);
            double cerca = 1e9;
            for (std::size_t i = 0; i + 1 < linea.size(); ++i) {
                const glm::dvec3 a(linea[i]), d = glm::dvec3(linea[i + 1]) - a;
                const double t = glm::clamp(glm::dot(Q - a, d) / glm::dot(d, d), 0.0, 1.0);
                cerca = std::min(cerca, glm::distance(Q, a + t * d));
            }
            peor = std::max(peor, cerca);
        }
        const int iguales = segmentosWang(P, tolerancia);
        std::printf("grado %zu: %zu segmentos (de igual largo, %d); se aparta %.2g de %.2g\n", n,
                    linea.size() - 1, iguales, peor, tolerancia);
        EXPECT_LE(peor, tolerancia + 1e-7);
        EXPECT_LE(linea.size(), static_cast<std::size_t>(2 * iguales));
        if (n >= 40) {
            EXPECT_LT(linea.size() * 8, static_cast<std::size_t>(iguales));
        }
    }
}

// ---- Los cuatro tipos de unión de continuidad ----

TEST(Continuidades, DerivadasALosDosLadosDeLaUnion) {
    for (int c = C0; c < CONTINUIDADES; ++c) {
        const Geometria<float> G = segundoTramo(static_cast<Continuidad>(c));
        glm::dvec3 antes[3], despues[3];
        for (int d = 0; d < 3; ++d) {
            const auto a = cubicaExacta(Base::HERMITE, PRIMER_TRAMO, 1.0f, d),
                       b = cubicaExacta(Base::HERMITE, G, 0.0f, d);
            antes[d] = {static_cast<double>(a.x), static_cast<double>(a.y), static_cast<double>(a.z)};
            despues[d] = {static_cast<double>(b.x), static_cast<double>(b.y), static_cast<double>(b.z)};
        }
        const double giro = std::acos(
                         glm::dot(glm::normalize(antes[1]), glm::normalize(despues[1]) * (1 - 1e-12))),
                     velocidad = glm::distance(antes[1], despues[1]),
                     aceleracion = glm::distance(antes[2], despues[2]);
        std::printf("%s: giro %.3g rad, salto de Q' %.3g, de Q'' %.3g\n",
                    c == C0   ? "C0"
                    : c == G1 ? "G1"
                    : c == C1 ? "C1"
                              : "C2",
                    giro, velocidad, aceleracion);
        EXPECT_EQ(antes[0], despues[0]);
        EXPECT_EQ(giro < 1e-5, c != C0);
        EXPECT_EQ(velocidad < 1e-6, c >= C1);
        EXPECT_EQ(aceleracion < 1e-5, c == C2);
        if (c == C0) {
            EXPECT_GT(giro, 0.5);
        } // que se vea
        if (c <= G1) {
            EXPECT_GT(velocidad, 0.5);
        }
        if (c == C1) {
            EXPECT_GT(aceleracion, 1);
        }
        if (c == G1) {
            EXPECT_NEAR(glm::length(despues[1]) / glm::length(antes[1]), static_cast<double>(FACTOR_G1),
                        1e-6);
        }
        // el recorrido entero: continuo, y de 0 a 2
        EXPECT_EQ(recorrido(static_cast<Continuidad>(c), 0), PRIMER_TRAMO[0]);
        EXPECT_EQ(recorrido(static_cast<Continuidad>(c), 1), PRIMER_TRAMO[1]);
        EXPECT_EQ(recorrido(static_cast<Continuidad>(c), 2), FINAL);
        EXPECT_LT(glm::distance(recorrido(static_cast<Continuidad>(c), 0.9999f), PRIMER_TRAMO[1]), 1e-3f);
        for (int i = 0; i <= 200; ++i) // el coche nunca se para, y siempre se sabe hacia dónde mira
            EXPECT_GT(glm::length(recorrido(static_cast<Continuidad>(c), static_cast<float>(i) / 100, 1)),
                      0.1f);
    }
}

// ---- El solenoide ----

/// El punto de la hélice de ángulo a.
glm::dvec3 helice(int vueltas, double a) {
    return {5.2 * a / (2 * M_PI * vueltas) - 2.6, 1.25 * std::cos(a), 1.25 * std::sin(a)};
}
/// Lo que dista de la hélice un punto cuyo ángulo es más o menos a.
double lejosDeLaHelice(int vueltas, const glm::dvec3 &p, double a) {
    double mejor = 1e9;
    for (double paso = 0.2; paso > 1e-9; paso /= 3) {
        const double centro = a;
        for (int k = -6; k <= 6; ++k)
            if (const double d = glm::distance(p, helice(vueltas, centro + k * paso / 3)); d < mejor) {
                mejor = d;
                a = centro + k * paso / 3;
            }
    }
    return mejor;
}

TEST(Solenoide, PuntosContraLaHelice) {
    for (const int vueltas : {2, 7, 16}) {
        double peor = 0, salto = 0, tangente = 0;
        for (int i = 0; i < 4 * vueltas; ++i) {
            const Geometria<float> G = segmentoSolenoide(vueltas, i);
            for (int k = 0; k <= 16; ++k)
                peor = std::max(peor,
                                lejosDeLaHelice(vueltas, cubica(Base::HERMITE, G, static_cast<float>(k) / 16),
                                                (i + k / 16.0) * M_PI / 2));
            EXPECT_LT(glm::distance(glm::dvec3(G[0]), helice(vueltas, i * M_PI / 2)), 1e-5);
            EXPECT_LT(glm::distance(glm::dvec3(G[1]), helice(vueltas, (i + 1) * M_PI / 2)), 1e-5);
            const double e = 1e-5, a = i * M_PI / 2;
            const glm::dvec3 derivada = (helice(vueltas, a + e) - helice(vueltas, a - e)) / (2 * e);
            tangente =
                std::max(tangente, glm::distance(glm::normalize(derivada), glm::normalize(glm::dvec3(G[2]))));
            if (i > 0) {
                const Geometria<float> previo = segmentoSolenoide(vueltas, i - 1);
                salto = std::max(salto, static_cast<double>(glm::distance(previo[1], G[0]) +
                                                            glm::distance(previo[3], G[2])));
            }
        }
        std::printf("%d vueltas: la curva se separa %.2g de la hélice; las tangentes, %.2g\n", vueltas, peor,
                    tangente);
        EXPECT_LT(peor, 1e-3);     // 0.2 píxeles a 720 líneas
        EXPECT_LT(tangente, 1e-5); // en float, un ángulo de 100 radianes tiene un error de 4e-6
        EXPECT_EQ(salto, 0);
    }
}

TEST(Solenoide, TuboAlrededorDeLaHelice) {
    for (const int vueltas : {2, 7, 16}) {
        const Malla mallas[2] = {tuboSolenoide(vueltas, 0), tuboSolenoide(vueltas, 1)};
        std::set<std::array<unsigned, 3>> triangulos;
        const int trozos = TROZOS_SEGMENTO, lados = LADOS_TUBO;
        for (int resto = 0; resto < 2; ++resto) {
            const Malla &m = mallas[resto];
            ASSERT_EQ(m.vertices.size(), static_cast<std::size_t>((4 * vueltas * trozos + 1) * (lados + 1)));
            ASSERT_EQ(m.indices.size(), static_cast<std::size_t>(2 * vueltas * trozos * lados * 6));
            for (std::size_t i = 0; i < m.indices.size(); i += 3) {
                EXPECT_TRUE(triangulos.insert({m.indices[i], m.indices[i + 1], m.indices[i + 2]}).second);
                const Vertice &a = m.vertices[m.indices[i]], &b = m.vertices[m.indices[i + 1]],
                              &c = m.vertices[m.indices[i + 2]];
                const glm::vec3 n = glm::cross(b.posicion - a.posicion, c.posicion - a.posicion);
                ASSERT_GT(glm::dot(n, a.normal), 0) << i; // hacia fuera
                const int segmento =
                    static_cast<int>(std::min({m.indices[i], m.indices[i + 1], m.indices[i + 2]})) /
                    (lados + 1) / trozos;
                ASSERT_EQ(segmento % 2, resto);
            }
        }
        double peor = 0;
        for (std::size_t v = 0; v < mallas[0].vertices.size(); v += 7) {
            const Vertice &x = mallas[0].vertices[v];
            const double a = 2 * M_PI * vueltas *
                             static_cast<double>(v / (static_cast<std::size_t>(lados) + 1)) /
                             (4 * vueltas * trozos);
            peor = std::max(
                peor, std::fabs(lejosDeLaHelice(vueltas, x.posicion, a) - static_cast<double>(GRUESO_TUBO)));
            EXPECT_NEAR(glm::length(x.normal), 1, 1e-5);
            EXPECT_LT(lejosDeLaHelice(vueltas, x.posicion - GRUESO_TUBO * x.normal, a), 2e-3);
        }
        std::printf("%d vueltas: el radio del tubo, con error de %.2g\n", vueltas, peor);
        EXPECT_LT(peor, 2e-3);
    }
    // medio píxel en 1080 líneas en lo más cercano, a 8 unidades: las flechas de la vuelta y del tubo
    const double pixel = 2 * std::tan(0.225) * 8 / 1080;
    EXPECT_LT((1.25 + 0.13) * (1 - std::cos(M_PI / (4 * TROZOS_SEGMENTO))), 0.5 * pixel);
    EXPECT_LT(0.13 * (1 - std::cos(M_PI / LADOS_TUBO)), 0.5 * pixel);
    EXPECT_GT((1.25 + 0.13) * (1 - std::cos(M_PI / (3 * TROZOS_SEGMENTO))),
              0.5 * pixel); // y no más de lo que hace falta
    EXPECT_GT(0.13 * (1 - std::cos(M_PI / (0.75 * LADOS_TUBO))), 0.5 * pixel);
}

} // namespace
