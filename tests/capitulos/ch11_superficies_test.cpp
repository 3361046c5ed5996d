// Las superficies del capítulo 11: superficies.h contra la definición (U·M·G·Mᵀ·Vᵀ con las matrices del libro) en cuádruple
// precisión, y superficie_hermite, superficie_bezier y superficie_bspline contra una imagen de referencia.
#include "ch11_curvas/hermite_trozos.h"
#include "ch11_curvas/lamina.h"
#include "colores.h"
#include "ejecuta.h"
#include "encima.h"
#include "oraculo/oraculo.h"
#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

/// Un número de cuádruple precisión que cabe en un glm::vec, que lo quiere trivial (el de Boost no lo es).
struct Cuadruple {
    __extension__ typedef __float128 Numero;
    Numero x;
    Cuadruple() = default;
    explicit Cuadruple(double d) : x(d) {
    }
    static Cuadruple de(const Numero &n) {
        Cuadruple c;
        c.x = n;
        return c;
    }
    Cuadruple &operator+=(const Cuadruple &b) {
        x += b.x;
        return *this;
    }
    Cuadruple &operator*=(const Cuadruple &b) {
        x *= b.x;
        return *this;
    }
    Cuadruple operator-() const {
        return de(-x);
    }
};
inline Cuadruple operator+(const Cuadruple &a, const Cuadruple &b) {
    return Cuadruple::de(a.x + b.x);
}
inline Cuadruple operator-(const Cuadruple &a, const Cuadruple &b) {
    return Cuadruple::de(a.x - b.x);
}
inline Cuadruple operator*(const Cuadruple &a, const Cuadruple &b) {
    return Cuadruple::de(a.x * b.x);
}
inline Cuadruple operator/(const Cuadruple &a, const Cuadruple &b) {
    return Cuadruple::de(a.x / b.x);
}
inline bool operator<(const Cuadruple &a, const Cuadruple &b) {
    return a.x < b.x;
}
inline bool operator>(const Cuadruple &a, const Cuadruple &b) {
    return a.x > b.x;
}
inline Cuadruple sqrt(const Cuadruple &a) { // dos pasos de Newton doblan dos veces las cifras de la raíz en double
    if (!(a.x > 0))
        return Cuadruple(0);
    Cuadruple r(std::sqrt(static_cast<double>(a.x)));
    for (int i = 0; i < 2; ++i)
        r = (r + a / r) / Cuadruple(2);
    return r;
}
template<>
struct std::numeric_limits<Cuadruple> {
    static Cuadruple epsilon() {
        return Cuadruple(std::ldexp(1.0, -112));
    }
};

namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;
using oraculo::Vec3;

// ---- Referencia: la definición, con las matrices del libro ----

template<class R>
using R3 = std::array<R, 3>;
template<class R>
using Red = std::array<std::array<R3<R>, 4>, 4>;

const Base BASES[] = {Base::HERMITE, Base::BEZIER, Base::BSPLINE};

/// M·(lo que divide a sus enteros): ecuaciones 11.10, 11.17 y 11.26.
int matriz(Base base, std::size_t fila, std::size_t columna) {
    static const int M[3][4][4] = {{{2, -2, 1, 1}, {-3, 3, -2, -1}, {0, 0, 1, 0}, {1, 0, 0, 0}},
                                   {{-1, 3, -3, 1}, {3, -6, 3, 0}, {-3, 3, 0, 0}, {1, 0, 0, 0}},
                                   {{-1, 3, -3, 1}, {3, -6, 3, 0}, {-3, 0, 3, 0}, {1, 4, 1, 0}}};
    return M[static_cast<int>(base)][fila][columna];
}

/// La derivada `d` de U·M.
template<class R>
std::array<R, 4> pesosRef(Base base, const R &u, int d) {
    std::array<R, 4> potencias, w;
    for (int k = 0; k < 4; ++k) { // u^(3−k)
        const int n = 3 - k;
        R p = n >= d ? R(1) : R(0);
        for (int i = 0; i < d; ++i)
            p *= n - i;
        for (int i = 0; i < n - d; ++i)
            p *= u;
        potencias[static_cast<std::size_t>(k)] = p;
    }
    for (std::size_t i = 0; i < 4; ++i) {
        w[i] = 0;
        for (std::size_t k = 0; k < 4; ++k)
            w[i] += potencias[k] * matriz(base, k, i);
        if (base == Base::BSPLINE)
            w[i] /= 6;
    }
    return w;
}

template<class R>
R3<R> exacta(Base base, const Red<R> &G, const R &u, const R &v, int du = 0, int dv = 0) {
    const std::array<R, 4> wu = pesosRef(base, u, du), wv = pesosRef(base, v, dv);
    R3<R> q = {R(0), R(0), R(0)};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t k = 0; k < 3; ++k)
                q[k] += wu[i] * wv[j] * G[i][j][k];
    return q;
}

template<class R>
R3<R> cruz(const R3<R> &a, const R3<R> &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template<class R>
R largo(const R3<R> &a) {
    using std::sqrt;
    return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}
template<class R>
R3<R> unitario(R3<R> a) {
    const R l = largo(a);
    for (R &x : a)
        x /= l;
    return a;
}
template<class R>
R3<R> normalRef(Base base, const Red<R> &G, const R &u, const R &v) {
    return unitario(cruz(exacta(base, G, u, v, 1, 0), exacta(base, G, u, v, 0, 1)));
}

template<class T>
Quad aQuad(const T &x) {
    return Quad(x);
}
Quad aQuad(const Cuadruple &c) { // en tres trozos, que caben en double
    const double alto = static_cast<double>(c.x);
    const Cuadruple resto = c - Cuadruple(alto);
    const double medio = static_cast<double>(resto.x);
    return Quad(alto) + Quad(medio) + Quad(static_cast<double>((resto - Cuadruple(medio)).x));
}

template<class R, class T>
Red<R> lleva(const Geometria2<T> &G) {
    Red<R> r;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            for (int k = 0; k < 3; ++k)
                if constexpr (std::is_same_v<R, Quad>)
                    r[i][j][static_cast<std::size_t>(k)] = aQuad(G[i][j][k]);
                else
                    r[i][j][static_cast<std::size_t>(k)] = R(G[i][j][k]);
    return r;
}
template<class T>
Geometria2<T> convierte(const Geometria2<double> &G) {
    Geometria2<T> r;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            r[i][j] = Punto<T>(T(G[i][j].x), T(G[i][j].y), T(G[i][j].z));
    return r;
}

/// La mayor diferencia de un componente.
template<class T>
double separacion(const Punto<T> &a, const R3<Quad> &b) {
    const Quad d[3] = {aQuad(a.x) - b[0], aQuad(a.y) - b[1], aQuad(a.z) - b[2]};
    return static_cast<double>(std::max({abs(d[0]), abs(d[1]), abs(d[2])}));
}

/// Números de −1 a 1, siempre los mismos.
Geometria2<double> alAzar(unsigned semilla) {
    std::mt19937 azar(semilla);
    Geometria2<double> G;
    for (auto &fila : G)
        for (glm::dvec3 &p : fila)
            for (int k = 0; k < 3; ++k) // un float exacto, el mismo en las tres precisiones
                p[k] = static_cast<double>(azar() % 2001) / 1024 - 1000.0 / 1024;
    return G;
}

const double PARAMETROS[] = {0, 1.0 / 1048576, 0.125, 0.3125, 0.5, 0.75, 1 - 1.0 / 1048576, 1};

/// Una red con un poco de forma y sus puntos de Bézier en (i, f, j).
Geometria2<double> loma() {
    static const double y[4][4] = {{0, 1, 0.5, -0.5}, {0.5, 1.5, 0, 0}, {0, -0.5, -1, 0.5}, {-0.5, 0, 0.5, 1}};
    Geometria2<double> G;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            G[i][j] = {static_cast<double>(i), y[i][j], -static_cast<double>(j)};
    return G;
}

template<class T>
double mayorError(int du, int dv) {
    double mayor = 0;
    for (const Base base : BASES)
        for (unsigned semilla = 1; semilla <= 20; ++semilla) {
            const Geometria2<T> G = convierte<T>(alAzar(semilla));
            const Red<Quad> R = lleva<Quad>(G);
            for (const double u : PARAMETROS)
                for (const double v : PARAMETROS)
                    mayor = std::max(mayor, separacion(superficie(base, G, T(u), T(v), du, dv),
                                                       exacta(base, R, Quad(u), Quad(v), du, dv)));
        }
    return mayor / static_cast<double>(aQuad(std::numeric_limits<T>::epsilon()));
}

} // namespace

// --- superficies.h: puntos y derivadas ---

// En épsilones del tipo, con puntos de coordenadas menores que 1. Medido: … en float y en double.
TEST(Superficies, ErrorFrenteACuadruplePrecision) {
    for (const auto &[du, dv, cota] :
         {std::tuple(0, 0, 2.0), {1, 0, 12.0}, {0, 1, 12.0}, {1, 1, 60.0}, {2, 0, 60.0}, {0, 2, 60.0}}) {
        const double f = mayorError<float>(du, dv), d = mayorError<double>(du, dv),
                     q = mayorError<Cuadruple>(du, dv);
        std::printf("derivada %d %d: float %.2f, double %.2f, cuádruple %.2f eps\n", du, dv, f, d, q);
        EXPECT_LT(f, cota) << du << dv;
        EXPECT_LT(d, cota) << du << dv;
        EXPECT_LT(q, 2 * cota) << du << dv; // la referencia también redondea
    }
}

// Lejos del origen las derivadas no pierden cifras: solo las que ya perdieron los puntos.
TEST(Superficies, LasDerivadasNoPierdenCifrasLejos) {
    for (const Base base : BASES) {
        Geometria2<double> G = loma();
        for (std::size_t i = 0; i < puntosDe(base); ++i)
            for (std::size_t j = 0; j < puntosDe(base); ++j)
                G[i][j] += glm::dvec3(1 << 20);
        const Red<Quad> R = lleva<Quad>(G);
        for (const double u : PARAMETROS)
            for (const double v : PARAMETROS)
                for (const auto &[du, dv] : {std::pair(1, 0), {0, 1}, {1, 1}, {2, 0}})
                    EXPECT_LT(separacion(superficie(base, G, u, v, du, dv),
                                         exacta(base, R, Quad(u), Quad(v), du, dv)),
                              1e-13);
    }
}

TEST(Superficies, PuntosDeBezierDeLaMismaSuperficie) {
    double mayor = 0;
    for (const Base base : BASES)
        for (unsigned semilla = 1; semilla <= 20; ++semilla) {
            const Geometria2<double> G = alAzar(semilla);
            const Red<Quad> B = lleva<Quad>(aBezier2(base, G));
            for (const double u : PARAMETROS)
                for (const double v : PARAMETROS)
                    mayor = std::max(mayor, separacion(superficie(base, G, u, v),
                                                       exacta(Base::BEZIER, B, Quad(u), Quad(v))));
        }
    EXPECT_LT(mayor, 8 * std::numeric_limits<double>::epsilon());
}

// Cada elemento de la matriz de geometría es lo que dice el libro en su esquina, bit a bit.
TEST(Superficies, HermiteEsquinasTangentesYTorsionExactas) {
    const Geometria2<double> G = alAzar(7);
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j) {
            const double u = static_cast<double>(i), v = static_cast<double>(j);
            EXPECT_EQ(superficie(Base::HERMITE, G, u, v), G[i][j]);
            EXPECT_EQ(superficie(Base::HERMITE, G, u, v, 1, 0), G[i + 2][j]);
            EXPECT_EQ(superficie(Base::HERMITE, G, u, v, 0, 1), G[i][j + 2]);
            EXPECT_EQ(superficie(Base::HERMITE, G, u, v, 1, 1), G[i + 2][j + 2]);
        }
}

TEST(Superficies, BezierPasaPorLasEsquinasConLasTangentesDeLaRed) {
    const Geometria2<double> G = alAzar(8);
    for (const std::size_t i : {0, 3})
        for (const std::size_t j : {0, 3}) {
            const double u = static_cast<double>(i) / 3, v = static_cast<double>(j) / 3;
            EXPECT_EQ(superficie(Base::BEZIER, G, u, v), G[i][j]);
            const std::size_t a = i == 0 ? 0 : 2, b = j == 0 ? 0 : 2;
            EXPECT_LT(glm::length(superficie(Base::BEZIER, G, u, v, 1, 0) - 3.0 * (G[a + 1][j] - G[a][j])),
                      1e-15);
            EXPECT_LT(glm::length(superficie(Base::BEZIER, G, u, v, 0, 1) - 3.0 * (G[i][b + 1] - G[i][b])),
                      1e-15);
        }
}

// En ninguna dirección llega la superficie más lejos que sus puntos.
TEST(Superficies, BezierNoSaleDelCascoConvexo) {
    std::mt19937 azar(3);
    std::normal_distribution<double> normal;
    for (unsigned semilla = 1; semilla <= 5; ++semilla) {
        const Geometria2<double> G = alAzar(semilla);
        for (int k = 0; k < 200; ++k) {
            const glm::dvec3 d = glm::normalize(glm::dvec3(normal(azar), normal(azar), normal(azar)));
            double tope = -10;
            for (const auto &fila : G)
                for (const glm::dvec3 &p : fila)
                    tope = std::max(tope, glm::dot(d, p));
            for (int i = 0; i <= 10; ++i)
                for (int j = 0; j <= 10; ++j)
                    ASSERT_LE(glm::dot(d, superficie(Base::BEZIER, G, i / 10.0, j / 10.0)), tope + 1e-15);
        }
    }
}

// Los trozos vecinos de una red de 5 × 5, en u y en v: el punto y las derivadas primera y segunda casan, y la tercera no. También
// con puntos duplicados, aunque el libro diga que no (§11.8): lo que se pierde es la tangente.
TEST(Superficies, BSplineC2EntreTrozos) {
    std::mt19937 azar(4);
    for (const bool duplicados : {false, true}) {
        std::vector<glm::dvec3> P;
        for (int k = 0; k < 25; ++k)
            P.push_back({static_cast<double>(azar() % 1024) / 512, static_cast<double>(azar() % 1024) / 512,
                         static_cast<double>(azar() % 1024) / 512});
        if (duplicados)
            P[8] = P[13] = P[7] = P[12];
        const auto trozo = [&](std::size_t i, std::size_t j) {
            Geometria2<double> G;
            for (std::size_t a = 0; a < 4; ++a)
                for (std::size_t b = 0; b < 4; ++b)
                    G[a][b] = P[5 * (i + a) + j + b];
            return G;
        };
        const Geometria2<double> A = trozo(0, 0), B = trozo(1, 0), C = trozo(0, 1);
        for (int k = 0; k <= 8; ++k) {
            const double t = k / 8.0;
            EXPECT_EQ(superficie(Base::BSPLINE, A, 1.0, t), superficie(Base::BSPLINE, B, 0.0, t));
            EXPECT_EQ(superficie(Base::BSPLINE, A, t, 1.0), superficie(Base::BSPLINE, C, t, 0.0));
            for (int d = 1; d <= 2; ++d) {
                EXPECT_LT(glm::length(superficie(Base::BSPLINE, A, 1.0, t, d, 0) -
                                      superficie(Base::BSPLINE, B, 0.0, t, d, 0)),
                          4e-15);
                EXPECT_LT(glm::length(superficie(Base::BSPLINE, A, t, 1.0, 0, d) -
                                      superficie(Base::BSPLINE, C, t, 0.0, 0, d)),
                          4e-15);
            }
            const R3<double> a = exacta(Base::BSPLINE, lleva<double>(A), 1.0, t, 3, 0),
                             b = exacta(Base::BSPLINE, lleva<double>(B), 0.0, t, 3, 0);
            EXPECT_GT(std::fabs(a[0] - b[0]) + std::fabs(a[1] - b[1]) + std::fabs(a[2] - b[2]), 0.01);
        }
    }
}

// §11.7: que los puntos de los dos lados del borde estén alineados con los del borde no basta para G1: la proporción ha de ser la misma
// en los cuatro.
TEST(Superficies, BezierAlineadosNoBastaParaG1) {
    const Geometria2<double> A = loma();
    const auto vecino = [&](const std::array<double, 4> &k) {
        Geometria2<double> B = A;
        for (std::size_t j = 0; j < 4; ++j) {
            B[0][j] = A[3][j];
            B[1][j] = A[3][j] + k[j] * (A[3][j] - A[2][j]);
        }
        return B;
    };
    const auto giro = [&](const Geometria2<double> &B) { // el mayor ángulo entre las normales del borde
        double mayor = 0;
        for (int i = 0; i <= 16; ++i) {
            const glm::dvec3 a = normalSuperficie(Base::BEZIER, A, 1.0, i / 16.0),
                             b = normalSuperficie(Base::BEZIER, B, 0.0, i / 16.0);
            mayor = std::max(mayor, std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
        }
        return mayor;
    };
    EXPECT_LT(giro(vecino({0.7, 0.7, 0.7, 0.7})), 1e-14);
    EXPECT_GT(giro(vecino({0.2, 1.5, 0.2, 1.5})), 0.1);
}

// --- superficies.h: normales ---

namespace {

/// El ángulo entre la normal y la de referencia, que es el límite camino del centro cuando en (u, v) no la hay.
template<class T>
double anguloNormal(Base base, const Geometria2<T> &G, double u, double v) {
    const Quad h("1e-17"), s = u + h * (Quad(0.5) - u), t = v + h * (Quad(0.5) - v);
    const Red<Quad> R = lleva<Quad>(G);
    const R3<Quad> aqui = cruz(exacta(base, R, Quad(u), Quad(v), 1, 0), exacta(base, R, Quad(u), Quad(v), 0, 1));
    const R3<Quad> n = largo(aqui) > Quad("1e-24") ? unitario(aqui) : normalRef(base, R, s, t);
    const Punto<T> m = normalSuperficie(base, G, T(u), T(v));
    const R3<Quad> mq = {aQuad(m.x), aQuad(m.y), aQuad(m.z)};
    EXPECT_LT(abs(largo(mq) - 1), 4 * aQuad(std::numeric_limits<T>::epsilon()));
    return static_cast<double>(atan2(largo(cruz(mq, n)), mq[0] * n[0] + mq[1] * n[1] + mq[2] * n[2]));
}

/// La loma con algo que le quita la normal en un borde o en una esquina.
struct Degenerada {
    const char *nombre;
    Geometria2<double> G;
};
std::vector<Degenerada> degeneradas() {
    const Geometria2<double> G = loma();
    std::vector<Degenerada> d = {{"borde u = 0", G},       {"borde u = 1", G},     {"borde v = 0", G},
                                 {"borde v = 1", G},       {"dos bordes", G},      {"sin tangente en u", G},
                                 {"sin tangente en v", G}, {"borde y esquina", G}, {"tangentes paralelas", G}};
    for (std::size_t k = 0; k < 4; ++k) {
        d[0].G[0][k] = G[0][0];
        d[1].G[3][k] = G[3][1];
        d[2].G[k][0] = G[1][0];
        d[3].G[k][3] = G[2][3];
        d[4].G[0][k] = G[0][1];
        d[4].G[3][k] = G[3][2];
        d[7].G[0][k] = G[0][0];
    }
    d[5].G[1][0] = G[0][0];
    d[6].G[3][2] = G[3][3];
    d[7].G[3][1] = G[3][0];
    d[8].G[0][1] = G[0][0] + 0.75 * (G[1][0] - G[0][0]);
    return d;
}

} // namespace

TEST(Normales, ContraCuadruplePrecision) {
    double f = 0, d = 0, q = 0;
    for (const Base base : BASES) {
        for (const double u : PARAMETROS)
            for (const double v : PARAMETROS) {
                f = std::max(f, anguloNormal(base, convierte<float>(loma()), u, v));
                d = std::max(d, anguloNormal(base, loma(), u, v));
                q = std::max(q, anguloNormal(base, convierte<Cuadruple>(loma()), u, v));
            }
    }
    std::printf("normales: float %.2g, double %.2g, cuádruple %.2g rad\n", f, d, q);
    EXPECT_LT(q, 1e-32);
    EXPECT_LT(f, 4e-6);
    EXPECT_LT(d, 8e-15);
}

// La talla y el sitio no cuentan.
TEST(Normales, DeCualquierTallaYEnCualquierSitio) {
    for (const double talla : {1e-9, 1e9}) {
        Geometria2<double> G = loma();
        for (auto &fila : G)
            for (glm::dvec3 &p : fila)
                p *= talla;
        for (const double u : PARAMETROS)
            EXPECT_LT(anguloNormal(Base::BEZIER, G, u, 0.3125), 8e-15) << talla;
    }
    Geometria2<double> G = loma();
    for (auto &fila : G)
        for (glm::dvec3 &p : fila)
            p += glm::dvec3(1 << 20, 0, -(1 << 20));
    for (const double u : PARAMETROS)
        EXPECT_LT(anguloNormal(Base::BEZIER, G, u, 0.3125), 8e-15);
}

TEST(Normales, UnBordeColapsadoLaTiene) {
    for (const Degenerada &caso : degeneradas()) {
        double d = 0, f = 0;
        for (int i = 0; i <= 8; ++i)
            for (int j = 0; j <= 8; ++j) {
                d = std::max(d, anguloNormal(Base::BEZIER, caso.G, i / 8.0, j / 8.0));
                f = std::max(f, anguloNormal(Base::BEZIER, convierte<float>(caso.G), i / 8.0, j / 8.0));
            }
        std::printf("%s: double %.2g, float %.2g rad\n", caso.nombre, d, f);
        EXPECT_LT(d, 1e-13) << caso.nombre;
        EXPECT_LT(f, 1e-4) << caso.nombre;
    }
}

// Al acercarse al borde colapsado la normal no salta.
TEST(Normales, JuntoAlBordeColapsadoNoSalta) {
    const Geometria2<double> G = degeneradas()[0].G;
    for (const double v : {0.0, 0.25, 0.5, 1.0})
        for (int k = 1; k < 50; ++k) {
            EXPECT_LT(anguloNormal(Base::BEZIER, G, std::ldexp(1.0, -k), v), 1e-6) << k;
            EXPECT_LT(anguloNormal(Base::BEZIER, convierte<float>(G), std::ldexp(1.0, -k), v), 2e-3) << k;
        }
}

// Puntos repetidos de todas las maneras: siempre hay una normal unitaria, y donde no hay superficie es +Z.
TEST(Normales, NuncaEsNaN) {
    const auto prueba = [](Base base, const Geometria2<float> &G) {
        for (int i = 0; i <= 8; ++i)
            for (int j = 0; j <= 8; ++j) {
                const glm::vec3 n = normalSuperficie(base, G, static_cast<float>(i) / 8, static_cast<float>(j) / 8);
                ASSERT_NEAR(glm::length(n), 1, 1e-6);
            }
    };
    std::mt19937 azar(5);
    for (const Base base : BASES)
        for (int k = 0; k < 300; ++k) {
            Geometria2<float> G = convierte<float>(loma());
            for (int veces = 0; veces < 1 + k / 10; ++veces)
                G[azar() % 4][azar() % 4] = G[azar() % 4][azar() % 4];
            prueba(base, G);
        }
    Geometria2<float> punto, recta;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
            punto[i][j] = {3, 4, 5};
            recta[i][j] = static_cast<float>(i + j) * glm::vec3(1, 2, 3);
        }
    for (const Base base : {Base::BEZIER, Base::BSPLINE})
        for (const Geometria2<float> &G : {punto, recta}) {
            prueba(base, G);
            EXPECT_EQ(normalSuperficie(base, G, 0.5f, 0.25f), glm::vec3(0, 0, 1));
        }
}

// --- superficies.h: triángulos ---

namespace {

/// Lo más que se separan la superficie y sus triángulos en el mismo (u, v), medido con `distancia`.
template<class Distancia>
double mayorSeparacion(Base base, const Geometria2<float> &G, const Malla &malla, const Distancia &distancia) {
    const Red<double> R = lleva<double>(G);
    const int n = 6;
    double mayor = 0;
    for (std::size_t t = 0; t < malla.indices.size(); t += 3) {
        const Vertice *v[3];
        for (std::size_t k = 0; k < 3; ++k)
            v[k] = &malla.vertices[malla.indices[t + k]];
        for (int i = 0; i <= n; ++i)
            for (int j = 0; i + j <= n; ++j) {
                const double b[3] = {static_cast<double>(i) / n, static_cast<double>(j) / n,
                                     static_cast<double>(n - i - j) / n};
                glm::dvec3 p(0);
                glm::dvec2 uv(0);
                for (int k = 0; k < 3; ++k) {
                    p += b[k] * glm::dvec3(v[k]->posicion);
                    uv += b[k] * glm::dvec2(v[k]->coordTextura);
                }
                const R3<double> q = exacta(base, R, uv.x, uv.y);
                mayor = std::max(mayor, distancia(Vec3{p.x, p.y, p.z}, Vec3{q[0], q[1], q[2]}));
            }
    }
    return mayor;
}
double enElMundo(const Vec3 &a, const Vec3 &b) {
    return oraculo::longitud(a - b);
}

} // namespace

// Nunca más de la tolerancia, y sin derrochar: con la cuarta parte de los triángulos se pasaría. Medido: de … a … de la tolerancia.
TEST(Triangulos, LoJustoParaLaTolerancia) {
    double menos = 1, mas = 0;
    for (const Base base : BASES)
        for (unsigned semilla = 0; semilla <= 12; ++semilla) {
            const Geometria2<float> G = convierte<float>(semilla ? alAzar(semilla) : loma());
            for (const double tolerancia : {0.1, 0.003}) {
                const Segmentos n = segmentosSuperficie(base, G, tolerancia);
                const double error = mayorSeparacion(base, G, mallaSuperficie(base, G, n), enElMundo);
                EXPECT_LE(error, tolerancia) << semilla;
                menos = std::min(menos, error / tolerancia);
                mas = std::max(mas, error / tolerancia);
                if (tolerancia < 0.01) {
                    EXPECT_GT(mayorSeparacion(base, G, mallaSuperficie(base, G, {n.u / 2, n.v / 2}), enElMundo),
                              tolerancia)
                        << semilla;
                }
            }
        }
    std::printf("separación: de %.2f a %.2f de la tolerancia\n", menos, mas);
}

// Un plano son dos triángulos; y si solo hay curva en u, solo se parte u.
TEST(Triangulos, SoloDondeHayCurva) {
    Geometria2<float> plano, canal;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
            const float x = static_cast<float>(i), z = static_cast<float>(j);
            plano[i][j] = {x, 0, z};
            canal[i][j] = {x, x * (3 - x), z};
        }
    for (const Base base : {Base::BEZIER, Base::BSPLINE}) {
        const Segmentos p = segmentosSuperficie(base, plano, 1e-3), c = segmentosSuperficie(base, canal, 1e-3);
        EXPECT_EQ(p.u, 1);
        EXPECT_EQ(p.v, 1);
        EXPECT_GT(c.u, 10);
        EXPECT_EQ(c.v, 1);
    }
}

TEST(Triangulos, GiranComoSuNormalYLlevanSusCoordenadas) {
    const Geometria2<float> G = convierte<float>(loma());
    const Malla malla = mallaSuperficie(Base::BEZIER, G, {5, 3});
    ASSERT_EQ(malla.vertices.size(), 24u);
    ASSERT_EQ(malla.indices.size(), 90u);
    double area = 0;
    for (std::size_t t = 0; t < 90; t += 3) {
        const Vertice &a = malla.vertices.at(malla.indices[t]), &b = malla.vertices.at(malla.indices[t + 1]),
                      &c = malla.vertices.at(malla.indices[t + 2]);
        const glm::vec3 n = glm::cross(b.posicion - a.posicion, c.posicion - a.posicion);
        for (const Vertice *v : {&a, &b, &c})
            EXPECT_GT(glm::dot(n, v->normal), 0);
        const glm::vec2 p = b.coordTextura - a.coordTextura, q = c.coordTextura - a.coordTextura;
        area += 0.5 * static_cast<double>(p.x * q.y - p.y * q.x);
    }
    EXPECT_NEAR(area, 1, 1e-6); // cubren todo (u, v), una vez
    for (const Vertice &v : malla.vertices) {
        const Red<Quad> R = lleva<Quad>(G);
        const Quad s = v.coordTextura.x, t = v.coordTextura.y;
        EXPECT_LT(separacion(v.posicion, exacta(Base::BEZIER, R, s, t)), 1e-6);
        EXPECT_LT(separacion(v.normal, normalRef(Base::BEZIER, R, s, t)), 4e-6);
    }
}

// Sin grietas: los vértices del borde que comparten dos trozos son los mismos, bit a bit.
TEST(Triangulos, LosTrozosVecinosCasan) {
    std::vector<glm::vec3> P;
    std::mt19937 azar(6);
    for (int k = 0; k < 25; ++k)
        P.push_back({static_cast<float>(azar() % 1000) / 77, static_cast<float>(azar() % 1000) / 77,
                     static_cast<float>(azar() % 1000) / 77});
    const auto bordes = [](Base base, const Geometria2<float> &A, const Geometria2<float> &B, bool enU) {
        const int n = 7;
        const Malla a = mallaSuperficie(base, A, {n, n}), b = mallaSuperficie(base, B, {n, n});
        for (std::size_t k = 0; k <= n; ++k)
            EXPECT_EQ(a.vertices[enU ? 8 * k + 7 : 56 + k].posicion, b.vertices[enU ? 8 * k : k].posicion);
    };
    bordes(Base::BSPLINE, geometriaDeRed(P, 5), geometriaDeRed(P, 5, 1, 0), true);
    bordes(Base::BSPLINE, geometriaDeRed(P, 5), geometriaDeRed(P, 5, 0, 1), false);
    bordes(Base::HERMITE, primerTrozo(ESQUINAS_INICIALES), segundoTrozo(ESQUINAS_INICIALES, 0.7f), true);
}

// --- Ejercicio 11.8 ---

// El borde coincide entero y las tangentes que lo cruzan son k veces las otras: la normal no cambia en toda la unión, y con k ≠ 1
// la derivada sí (G1 y no C1).
TEST(HermiteUnidas, G1EnTodoElBorde) {
    for (const float k : {0.2f, 0.7f, 1.0f, 3.0f}) {
        const Red<Quad> A = lleva<Quad>(primerTrozo(ESQUINAS_INICIALES)),
                        B = lleva<Quad>(segundoTrozo(ESQUINAS_INICIALES, k));
        for (int i = 0; i <= 16; ++i) {
            const Quad v = Quad(i) / 16;
            for (const int dv : {0, 1})
                EXPECT_EQ(exacta(Base::HERMITE, A, Quad(1), v, 0, dv), exacta(Base::HERMITE, B, Quad(0), v, 0, dv));
            const R3<Quad> a = exacta(Base::HERMITE, A, Quad(1), v, 1, 0),
                           b = exacta(Base::HERMITE, B, Quad(0), v, 1, 0);
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_LT(abs(b[c] - Quad(k) * a[c]), Quad(1e-6));
            EXPECT_GT(largo(a), Quad(0.1));
        }
    }
}
