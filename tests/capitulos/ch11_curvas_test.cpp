// Comprobaciones independientes de las cabeceras de curvas del capítulo 11, contra las matrices del libro y los
// coeficientes binomiales exactos en cuádruple precisión.
#include "ch11_curvas/continuidad.h"
#include "ch11_curvas/solenoide.h"
#include "ch11_referencia.h"
#include <type_traits>

namespace {

/// Tantos redondeos de T; de la cuádruple, el doble, que la referencia también redondea.
template<typename T>
double redondeos(double n) {
    return n * ulp<T>() * (std::is_same_v<T, Cuadruple> ? 2 : 1);
}

/// Lo mayor de error(u), con una de cada tantas de 258 muestras: casi ninguna es exacta en binario, y todo redondea.
template<typename T, typename Error>
double peor(const Error &error, int cada = 1) {
    double peor = 0;
    for (int i = 0; i < 258; i += cada)
        peor = mayor(peor, double(error(T(i) / T(257))));
    return peor;
}
/// Lo mayor de error(G, u) con veinte vectores de geometría en el cubo de lado 2.
template<typename T, typename Error>
double peorCubica(const Error &error) {
    double peorDeTodas = 0;
    for (unsigned semilla = 0; semilla < 20; ++semilla) {
        const auto G = geometriaAlAzar<T>(semilla);
        peorDeTodas = mayor(peorDeTodas, peor<T>([&](const T &u) { return error(G, u); }, 4));
    }
    return peorDeTodas;
}

template<typename T>
Punto<Cuadruple> bezierRef(const std::vector<Punto<T>> &P, const T &u) {
    const std::vector<Cuadruple> b = bernsteinRef(P.size() - 1, Cuadruple(u));
    Punto<Cuadruple> p(Cuadruple(0));
    for (std::size_t k = 0; k < P.size(); ++k)
        p += b[k] * Punto<Cuadruple>(P[k]);
    return p;
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
            const auto G = geometriaAlAzar<float>(semilla);
            for (const float u : {0.0f, 0.125f, 0.4f, 0.75f, 1.0f})
                EXPECT_LT(lejos(Punto<float>(potencias(u) * M[int(base)] * enFilas(G)),
                                curvaRef(base, G, Cuadruple(u))),
                          redondeos<float>(20));
        }
    const auto P = geometriaAlAzar<float>();
    const glm::mat4x3 H = glm::transpose(M_HB * enFilas(P));
    EXPECT_EQ(H[0], P[0]);
    EXPECT_EQ(H[1], P[3]);
    EXPECT_LT(glm::distance(H[2], 3.0f * (P[1] - P[0])), 1e-6f);
    EXPECT_LT(glm::distance(H[3], 3.0f * (P[3] - P[2])), 1e-6f);
}

// En su base y, con los puntos de Bézier de la misma curva, con los pesos de Bernstein y con de Casteljau.
TYPED_TEST(Curvas, CubicasContraCuadruplePrecision) {
    using T = TypeParam;
    const double cota[] = {4, 40, 160}; // sumas de cuatro productos de hasta 1, 6 y 24
    for (const Base base : BASES) {
        for (int d = 0; d < 3; ++d) {
            const auto error = [&](const Geometria<T> &G, const T &u) {
                return lejos(cubica(base, G, u, d), curvaRef(base, G, Cuadruple(u), d));
            };
            EXPECT_LE(peorCubica<T>(error), redondeos<T>(cota[d]));
        }
        const auto enBezier = [&](const Geometria<T> &G, const T &u) {
            const Geometria<T> B = aBezier(base, G);
            const auto Q = curvaRef(base, G, Cuadruple(u));
            return mayor(lejos(cubica(Base::BEZIER, B, u), Q),
                         lejos(bezier(std::vector<Punto<T>>(B.begin(), B.end()), u), Q));
        };
        EXPECT_LE(peorCubica<T>(enBezier), redondeos<T>(8));
    }
}

// ---- Grado n ----

TYPED_TEST(Curvas, BezierDeGrado10_20_40_60) {
    using T = TypeParam;
    for (const std::size_t n : {1, 3, 10, 20, 40, 60}) {
        const auto P = puntosAlAzar<T>(n + 1);
        const auto curva = [&](const T &u) { return lejos(bezier(P, u), bezierRef(P, u)); };
        // cada nivel promedia y redondea: n niveles, tres redondeos en cada uno, de medio ulp y tres coordenadas
        const double cota = redondeos<T>(1.5 * std::sqrt(3.0) * double(n));
        EXPECT_LE(peor<T>(curva, 8), cota);
        // en cuádruple hacen falta los mismos segmentos que en doble
        const std::vector<glm::dvec3> enDoble(P.begin(), P.end());
        EXPECT_TRUE((std::is_same_v<T, float>) || polilineaBezier(P, 1e-3) == polilineaBezier(enDoble, 1e-3));
    }
}

// ---- B-Spline ----

// Errata de la ecuación 11.27: Q_i(u) con u entre los nudos i e i+1 es la fórmula en u − u_i; y en u = 1 vale también.
TEST(Erratas, ArgumentoDeLaEcuacion1127) {
    const auto G = geometriaAlAzar<double>();
    for (const double nudo : {0.0, 1.0, 5.0})
        for (const double u : {0.0, 0.25, 1.0}) {
            // U de la ecuación 11.24 con el parámetro global
            const auto Q = curvaRef(Base::BSPLINE, G, Cuadruple((nudo + u) - nudo));
            EXPECT_LT(lejos(cubica(Base::BSPLINE, G, u), Q), 1e-15);
            // la misma fórmula con el parámetro global, tal como se lee, no es la curva
            EXPECT_EQ(lejos(cubica(Base::BSPLINE, G, nudo + u), Q) > 0.1, nudo > 0);
        }
}

// ---- Teselación ----

/// Lo más que la curva se aparta de la polilínea de n cuerdas, tomando en ella el mismo parámetro.
double cuerda(const std::vector<glm::dvec3> &P, int n) {
    double peor = 0;
    for (int i = 0; i < n; ++i)
        for (int k = 1; k < 8; ++k) {
            const glm::dvec3 enCuerda =
                glm::mix(bezier(P, double(i) / n), bezier(P, double(i + 1) / n), k / 8.0);
            peor = mayor(peor, glm::distance(bezier(P, (i + k / 8.0) / n), enCuerda));
        }
    return peor;
}

// En una parábola la cota es exacta: ni un segmento de más. En las cúbicas no se pasa de la tolerancia, ni sobra mucho.
TEST(Teselacion, LaJusta) {
    const std::vector<glm::dvec3> P = {{0, 0, 0}, {1, 3, 0}, {2, 0, 0}};
    for (const double tolerancia : {0.3, 0.01, 1e-4}) {
        const int n = segmentosWang(P, tolerancia);
        EXPECT_LE(cuerda(P, n), tolerancia * (1 + 1e-9));
        EXPECT_GT(cuerda(P, n - 1), tolerancia);
        EXPECT_LT(polilineaBezier(P, tolerancia).size(), std::size_t(2 * n + 1)); // de mitad en mitad
    }
    EXPECT_EQ(segmentosDerivada(0, 0.1), 1);
    EXPECT_EQ(segmentosDerivada(INFINITY, 0.1), SEGMENTOS_MAXIMOS);
    double aprovechado = 0;
    for (const Base base : BASES)
        for (unsigned semilla = 0; semilla < 20; ++semilla) {
            const auto G = geometriaAlAzar<double>(semilla), B = aBezier(base, G);
            aprovechado =
                mayor(aprovechado, cuerda({B.begin(), B.end()}, segmentosCubica(base, G, 1e-3)) / 1e-3);
        }
    EXPECT_LE(aprovechado, 1);
    EXPECT_GT(aprovechado, 0.7);
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
        for (int k = 0; k <= 200; ++k) // el coche nunca se para, y siempre se sabe hacia dónde mira
            EXPECT_GT(glm::length(recorrido(c, float(k) / 100, 1)), 0.1f);
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
