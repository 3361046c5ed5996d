// Comprobaciones independientes de las cabeceras de curvas del capítulo 11, contra las matrices del libro y los
// coeficientes binomiales exactos en cuádruple precisión.
#include "ch11_curvas/continuidad.h"
#include "ch11_curvas/solenoide.h"
#include "ch11_referencia.h"

namespace {

/// Lo mayor de error(u): en los extremos y en medio, donde ninguna es exacta en binario y todo redondea.
template<typename T, typename Error>
double peor(const Error &error) {
    double peor = 0;
    for (int i = 0; i <= 65; ++i)
        peor = mayor(peor, double(error(T(i) / T(65))));
    return peor;
}

template<typename T>
class Curvas : public testing::Test {};
using Reales = testing::Types<float, double, Cuadruple>;
TYPED_TEST_SUITE(Curvas, Reales);

// ---- Las tres bases ----

// Las del libro, y Q(u) = U·M·G escrito con ellas, que es la misma curva; G_H = M_HB·G_B (ecuaciones 11.12 y 11.14).
TEST(Matrices, ComoEnElLibro) {
    const glm::mat4 M[] = {M_H, M_B, M_BS};
    for (const Base base : BASES)
        for (unsigned semilla = 0; semilla < 20; ++semilla) {
            const auto G = redAlAzar<float>(semilla)[0];
            for (const float u : {0.0f, 0.125f, 0.4f, 0.75f, 1.0f})
                EXPECT_LT(lejos(Punto<float>(potencias(u) * M[int(base)] * enFilas(G)),
                                curvaRef(base, G, Cuadruple(u))),
                          redondeos<float>(20));
        }
    const auto P = redAlAzar<float>()[0];
    const glm::mat4x3 H = glm::transpose(M_HB * enFilas(P));
    EXPECT_EQ(H[0], P[0]);
    EXPECT_EQ(H[1], P[3]);
    EXPECT_LT(glm::distance(H[2], 3.0f * (P[1] - P[0])), 1e-6f);
    EXPECT_LT(glm::distance(H[3], 3.0f * (P[3] - P[2])), 1e-6f);
}

// En su base y, con los puntos de Bézier de la misma curva, con los pesos de Bernstein y con de Casteljau. Va justo de
// punta a punta, y lejos del origen sus derivadas son las mismas.
TYPED_TEST(Curvas, CubicasContraCuadruplePrecision) {
    using T = TypeParam;
    const double cota[] = {4, 40, 160}; // sumas de cuatro productos de hasta 1, 6 y 24
    for (const Base base : BASES)
        for (unsigned semilla = 0; semilla < 20; ++semilla) {
            const auto G = redAlAzar<T>(semilla)[0], B = aBezier(base, G);
            auto lejana = G;
            for (std::size_t i = 0; i < puntosDe(base); ++i)
                lejana[i] += Punto<T>(T(1024));
            for (int d = 0; d < 3; ++d) {
                const auto error = [&](const T &u) {
                    return lejos(cubica(base, G, u, d), curvaRef(base, G, Cuadruple(u), d));
                };
                const auto mueve = [&](const T &u) {
                    return lejos(cubica(base, lejana, u, d), cubica(base, G, u, d));
                };
                EXPECT_LE(peor<T>(error), redondeos<T>(cota[d]));
                EXPECT_TRUE(d == 0 || peor<T>(mueve) == 0);
            }
            const std::vector<Punto<T>> P(B.begin(), B.end());
            const auto enBezier = [&](const T &u) {
                const auto Q = curvaRef(base, G, Cuadruple(u));
                return mayor(lejos(cubica(Base::BEZIER, B, u), Q), lejos(bezier(P, u), Q));
            };
            EXPECT_LE(peor<T>(enBezier), redondeos<T>(8));
            EXPECT_TRUE(base == Base::BSPLINE ||
                        (cubica(base, G, T(0)) == B[0] && cubica(base, G, T(1)) == B[3]));
        }
}

// Donde se para no hay tal circunferencia.
TEST(Curvatura, NulaConTangentesNulas) {
    const Geometria<float> parada = {Punto<float>(-3, 1, 0.5f), Punto<float>(4, 2, 1), {}, {}};
    const auto derivada = [&](int d) { return cubica(Base::HERMITE, parada, 0.0f, d); };
    EXPECT_EQ(derivada(1), Punto<float>(0));
    EXPECT_EQ(curvatura(derivada(1), derivada(2)), Punto<float>(0));
}

// ---- Grado n ----

TYPED_TEST(Curvas, BezierDeGrado10_20_40_60) {
    using T = TypeParam;
    for (const std::size_t n : {1, 3, 10, 20, 40, 60}) {
        const RedBezier<T> red = {n, 0, puntosAlAzar<T>(n + 1)};
        const std::vector<Punto<T>> &P = red.P;
        const auto curva = [&](const T &u) {
            return lejos(bezier(P, u), superficieRef(red, Cuadruple(u), Cuadruple(0)));
        };
        // cada nivel promedia y redondea: n niveles, tres redondeos en cada uno, de medio ulp y tres coordenadas
        EXPECT_LE(peor<T>(curva), redondeos<T>(1.5 * std::sqrt(3.0) * double(n)));
        EXPECT_TRUE(bezier(P, T(0)) == P.front() && bezier(P, T(1)) == P.back());
        // en cuádruple hacen falta los mismos segmentos que en doble
        const std::vector<glm::dvec3> enDoble(P.begin(), P.end());
        EXPECT_TRUE((std::is_same_v<T, float>) || polilineaBezier(P, 1e-3) == polilineaBezier(enDoble, 1e-3));
    }
}

// ---- B-Spline ----

// Errata de la ecuación 11.27: Q_i(u) con u entre los nudos i e i+1 es la fórmula en u − u_i; y en u = 1 vale también.
TEST(Erratas, ArgumentoDeLaEcuacion1127) {
    const auto G = redAlAzar<double>()[0];
    for (const double nudo : {0.0, 1.0, 5.0})
        for (const double u : {0.0, 0.25, 1.0}) {
            // U de la ecuación 11.24 con el parámetro global
            const auto Q = curvaRef(Base::BSPLINE, G, Cuadruple((nudo + u) - nudo));
            EXPECT_LT(lejos(cubica(Base::BSPLINE, G, u), Q), 1e-15);
            // la misma fórmula con el parámetro global, tal como se lee, no es la curva
            EXPECT_EQ(lejos(cubica(Base::BSPLINE, G, nudo + u), Q) > 0.1, nudo > 0);
        }
}

// ---- Los cuatro tipos de unión de continuidad ----

TEST(Continuidades, DerivadasALosDosLadosDeLaUnion) {
    for (const Continuidad c : {C0, G1, C1, C2}) {
        SCOPED_TRACE(c);
        const auto salto = [&](int d, bool unitarias = false) {
            const auto antes = curvaRef(Base::HERMITE, PRIMER_TRAMO, Cuadruple(1), d),
                       despues = curvaRef(Base::HERMITE, segundoTramo(c), Cuadruple(0), d);
            const auto k = [=](const auto &v) { return unitarias ? Cuadruple(1) / largo(v) : Cuadruple(1); };
            return lejos(k(antes) * antes, k(despues) * despues);
        };
        EXPECT_EQ(salto(0), 0);
        EXPECT_EQ(salto(1, true) > 1e-6, c == C0);
        EXPECT_EQ(salto(1) > 1e-6, c <= G1);
        EXPECT_EQ(salto(2) > 1e-5, c <= C1);
    }
}

// ---- El solenoide ----

/// Lo que dista de la hélice, en su plano normal, un punto que está casi en el del ángulo a.
double lejosDeLaHelice(int vueltas, const glm::dvec3 &p, double a) {
    const double x = 5.2 / (2 * M_PI * vueltas), seno = 1.25 * std::sin(a), coseno = 1.25 * std::cos(a);
    const glm::dvec3 d = p - glm::dvec3(x * a - 2.6, coseno, seno),
                     T = glm::normalize(glm::dvec3(x, -seno, coseno));
    return glm::length(d - glm::dot(d, T) * T);
}

// El tubo va alrededor de la hélice; cada mitad son los segmentos pares o los impares.
TEST(Solenoide, TuboAlrededorDeLaHelice) {
    const std::size_t anillo = LADOS_TUBO + 1;
    for (const std::size_t vueltas : {2, 7, 16})
        for (const std::size_t resto : {0, 1}) {
            const Malla m = tuboSolenoide(int(vueltas), int(resto));
            ASSERT_EQ(m.indices.size(), 2 * vueltas * TROZOS_SEGMENTO * LADOS_TUBO * 6);
            for (std::size_t i = 0; i < m.indices.size(); i += 3)
                ASSERT_EQ(*std::min_element(&m.indices[i], &m.indices[i] + 3) / anillo / TROZOS_SEGMENTO % 2,
                          resto);
            for (std::size_t v = 0; v < m.vertices.size(); ++v) {
                const glm::dvec3 p(m.vertices[v].posicion), n(m.vertices[v].normal);
                const double a = M_PI / 2 * double(v / anillo) / TROZOS_SEGMENTO;
                ASSERT_NEAR(lejosDeLaHelice(int(vueltas), p, a), 0.13, 2e-3);
                ASSERT_LT(lejosDeLaHelice(int(vueltas), p - 0.13 * n, a), 2e-3);
            }
        }
}

} // namespace
