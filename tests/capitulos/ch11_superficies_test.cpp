// Las superficies del capítulo 11: superficies.h contra la definición en cuádruple precisión, y sus programas contra una
// imagen de referencia y la lista de lo que pintan encima.
#include "ch11_curvas/bezier_trozos.h"
#include "ch11_curvas/hermite_trozos.h"
#include "ch11_curvas/lamina.h"
#include "ch11_lista.h"
#include "ch11_referencia.h"
#include "pintado.h"

namespace {

// ---- Referencia ----

template<typename T>
Geometria2<T> redAlAzar(unsigned semilla) {
    const auto P = puntosAlAzar<T>(16, semilla);
    Geometria2<T> G;
    std::copy(P.begin(), P.end(), &G[0][0]);
    return G;
}
/// La misma red en otra precisión, con cada punto en f(punto).
using Cambio = std::function<glm::dvec3(const glm::dvec3 &)>;
template<typename T, typename Otro>
Geometria2<T> lleva(
    const Geometria2<Otro> &G, const Cambio &f = [](const glm::dvec3 &p) { return p; }) {
    Geometria2<T> r;
    for (std::size_t k = 0; k < 16; ++k)
        r[k / 4][k % 4] = Punto<T>(f(G[k / 4][k % 4]));
    return r;
}

template<typename R>
Punto<R> cruz(const Punto<R> &a, const Punto<R> &b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// La normal, o su límite camino del centro donde no la hay. `Q(u, v, du, dv)` es la superficie o una derivada suya.
template<typename R, typename Derivada>
Punto<R> normalDe(const Derivada &Q, const R &u, const R &v) {
    Punto<R> n(R(0));
    for (const double h : {0.0, 1e-17}) {
        const R s = u + R(h) * (R(0.5) - u), t = v + R(h) * (R(0.5) - v);
        n = cruz<R>(Q(s, t, 1, 0), Q(s, t, 0, 1));
        if (double(largo(n)) > 1e-24)
            break;
    }
    return (R(1) / largo(n)) * n;
}
template<typename R, typename T>
Punto<R> normalRef(Base base, const Geometria2<T> &G, const R &u, const R &v) {
    return normalDe(
        [&](const R &s, const R &t, int du, int dv) { return superficieRef(base, G, s, t, du, dv); }, u, v);
}

const std::vector<double> PARAMETROS = {0, 0x1p-20, 0.125, 0.3125, 0.5, 0.75, 1 - 0x1p-20, 1},
                          OCTAVOS = {0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1};
/// Lo mayor de error(u, v).
template<typename Error>
double peor(const Error &error, const std::vector<double> &parametros = PARAMETROS) {
    double peor = 0;
    for (const double u : parametros)
        for (const double v : parametros)
            peor = mayor(peor, error(u, v));
    return peor;
}

/// Una red con un poco de forma y sus puntos de Bézier en (i, f, j).
Geometria2<double> loma() {
    const double y[] = {0, 1, 0.5, -0.5, 0.5, 1.5, 0, 0, 0, -0.5, -1, 0.5, -0.5, 0, 0.5, 1};
    Geometria2<double> G;
    for (std::size_t k = 0; k < 16; ++k)
        G[k / 4][k % 4] = {double(k / 4), y[k], -double(k % 4)};
    return G;
}

/// Los 16 puntos de una red de n×n que empiezan en una fila y una columna.
using Red = std::vector<glm::dvec3>;
Geometria2<double> trozoDe(const Red &P, std::size_t n, std::size_t i = 0, std::size_t j = 0) {
    Geometria2<double> G;
    for (std::size_t k = 0; k < 16; ++k)
        G[k / 4][k % 4] = P[n * (i + k / 4) + j + k % 4];
    return G;
}

// ---- superficies.h: puntos y derivadas ----

/// El mayor error de la superficie o de una derivada suya.
template<typename T>
double peorError(Base base, const Geometria2<T> &G, int du = 0, int dv = 0) {
    return peor([&](double u, double v) {
        const T s = T(u), t = T(v);
        const glm::dvec3 d = glm::abs(glm::dvec3(Punto<Cuadruple>(superficie(base, G, s, t, du, dv)) -
                                                 superficieRef(base, G, Cuadruple(s), Cuadruple(t), du, dv)));
        return std::max({d.x, d.y, d.z});
    });
}

// En épsilones del tipo, con puntos de coordenadas menores que 1 y diez cifras binarias. La referencia de la cuádruple
// también redondea.
TEST(Superficies, ErrorFrenteACuadruplePrecision) {
    const struct {
        int du, dv;
        double cota;
    } casos[] = {{0, 0, 2}, {1, 0, 12}, {0, 1, 12}, {1, 1, 60}, {2, 0, 60}, {0, 2, 60}};
    const auto redondo = [](const glm::dvec3 &p) { return glm::round(1024.0 * p) / 1024.0; };
    for (const auto &[du, dv, cota] : casos)
        for (const Base base : BASES)
            for (unsigned semilla = 0; semilla < 20; ++semilla) {
                const auto G = lleva<double>(redAlAzar<double>(semilla), redondo);
                EXPECT_LT(peorError(base, lleva<float>(G), du, dv), cota * ulp<float>()) << du << dv;
                EXPECT_LT(peorError(base, G, du, dv), cota * ulp<double>()) << du << dv;
                EXPECT_LT(peorError(base, lleva<Cuadruple>(G), du, dv), 2 * cota * ulp<Cuadruple>())
                    << du << dv;
            }
}

/// Una red de esos grados, con el grado más alto en u o en v.
template<typename T>
RedBezier<T> redAlAzar(std::size_t n, std::size_t m, unsigned semilla) {
    return {n, m, puntosAlAzar<T>((n + 1) * (m + 1), semilla)};
}

// Ecuación 11.41, con (n + 1)×(m + 1) puntos: la superficie y sus derivadas, que también se anulan cuando el grado no da
// para más; y con 4×4 es la de la ecuación 11.40. Cada peso se equivoca en unos redondeos por grado.
TEST(Superficies, BezierDeGradoNxM) {
    for (const auto &[n, m] :
         {std::pair<std::size_t, std::size_t>{1, 1}, {0, 2}, {3, 3}, {5, 2}, {1, 7}, {12, 9}}) {
        const auto red = redAlAzar<double>(n, m, 7);
        for (const auto &[du, dv] : {std::pair<int, int>{0, 0}, {1, 0}, {0, 1}, {1, 1}, {2, 0}, {0, 2}}) {
            const double sumandos = std::pow(2.0 * double(n + 1), du) * std::pow(2.0 * double(m + 1), dv);
            const double error = peor([&, i = du, j = dv](double u, double v) {
                return lejos(superficie(red, u, v, i, j),
                             superficieRef(red, Cuadruple(u), Cuadruple(v), i, j));
            });
            EXPECT_LT(error, 2 * double(n + m + 1) * sumandos * ulp<double>()) << n << m << du << dv;
        }
    }
    const auto G = redAlAzar<double>(3);
    const auto red = redDe(Base::BEZIER, G);
    EXPECT_LT(peor([&](double u, double v) {
                  return std::max(lejos(superficie(red, u, v), superficieRef(Base::BEZIER, G, u, v)),
                                  lejos(normalSuperficie(red, u, v), normalRef(Base::BEZIER, G, u, v)));
              }),
              1e-13);
}

// §11.5: la superficie en v es la curva de Bézier de los puntos G(v), y cada uno va por la curva de su fila.
TEST(Superficies, UnaFamiliaDeCurvas) {
    const auto red = redAlAzar<double>(4, 6, 5);
    EXPECT_LT(peor([&](double u, double v) {
                  return lejos(bezier(geometriaEn(red, v), u),
                               superficieRef(red, Cuadruple(u), Cuadruple(v)));
              }),
              4e-15);
    for (std::size_t i = 0; i <= red.n; ++i)
        EXPECT_EQ(geometriaEn(red, 1.0)[i], red.en(i, red.m));
}

// Los trozos vecinos de una red de 5 × 5, en u y en v: el punto y las derivadas primera y segunda casan, y la tercera
// no. También con puntos duplicados, aunque el libro diga que no (§11.8): lo que se pierde es la tangente…
TEST(Superficies, BSplineC2EntreTrozos) {
    const auto enDoble = [](auto... a) { return superficie<double>(a...); };
    const auto exacta = [](auto... a) { return superficieRef<double, double>(a...); };
    for (const bool duplicados : {false, true}) {
        auto P = puntosAlAzar<double>(25);
        if (duplicados)
            P[8] = P[13] = P[7] = P[12];
        const auto A = trozoDe(P, 5), B = trozoDe(P, 5, 1, 0), C = trozoDe(P, 5, 0, 1);
        const auto salto = [&](double t, int d, const auto &Q) {
            return std::max(lejos(Q(Base::BSPLINE, A, 1.0, t, d, 0), Q(Base::BSPLINE, B, 0.0, t, d, 0)),
                            lejos(Q(Base::BSPLINE, A, t, 1.0, 0, d), Q(Base::BSPLINE, C, t, 0.0, 0, d)));
        };
        for (int k = 0; k <= 8; ++k) {
            EXPECT_EQ(salto(k / 8.0, 0, enDoble), 0);
            EXPECT_LT(salto(k / 8.0, 1, enDoble), 4e-15);
            EXPECT_LT(salto(k / 8.0, 2, enDoble), 4e-15);
            EXPECT_GT(salto(k / 8.0, 3, exacta), 0.01);
        }
    }
}

// … como con una fila repetida tres veces: Q_u se anula en todo un borde.
TEST(Superficies, BSplineConFilasRepetidasPierdeLaTangente) {
    Geometria2<double> G = loma();
    G[1] = G[2] = G[0];
    for (const double v : OCTAVOS)
        EXPECT_LT(glm::length(superficie(Base::BSPLINE, G, 0.0, v, 1, 0)), 1e-15);
}

// §11.7: que los puntos de los dos lados del borde estén alineados con los del borde no basta para G1: la proporción ha
// de ser la misma en los cuatro.
TEST(Superficies, BezierAlineadosNoBastaParaG1) {
    const Geometria2<double> A = loma();
    const auto giro = [&](const std::array<double, 4> &k) { // el mayor seno entre las normales del borde
        Geometria2<double> B = A;
        for (std::size_t j = 0; j < 4; ++j) {
            B[0][j] = A[3][j];
            B[1][j] = A[3][j] + k[j] * (A[3][j] - A[2][j]);
        }
        double mayorSeno = 0;
        for (const double v : OCTAVOS)
            mayorSeno = mayor(mayorSeno, glm::length(glm::cross(normalSuperficie(Base::BEZIER, A, 1.0, v),
                                                                normalSuperficie(Base::BEZIER, B, 0.0, v))));
        return mayorSeno;
    };
    EXPECT_LT(giro({0.7, 0.7, 0.7, 0.7}), 1e-14);
    EXPECT_GT(giro({0.2, 1.5, 0.2, 1.5}), 0.1);
}

// ---- superficies.h: normales ----

/// El ángulo entre la normal y la de referencia.
template<typename T>
double angulo(Base base, const Geometria2<double> &enDoble, double u, double v) {
    const auto G = lleva<T>(enDoble);
    const Punto<Cuadruple> m(normalSuperficie(base, G, T(u), T(v))),
        n = normalRef(base, G, Cuadruple(u), Cuadruple(v));
    EXPECT_LT(std::fabs(double(largo(m) - Cuadruple(1))), 4 * ulp<T>());
    return std::atan2(double(largo(cruz(m, n))), glm::dot(glm::dvec3(m), glm::dvec3(n)));
}
template<typename T>
double peorAngulo(Base base, const Geometria2<double> &G,
                  const std::vector<double> &parametros = PARAMETROS) {
    return peor([&](double u, double v) { return angulo<T>(base, G, u, v); }, parametros);
}

TEST(Normales, ContraCuadruplePrecision) {
    for (const Base base : BASES) {
        EXPECT_LT(peorAngulo<Cuadruple>(base, loma()), 1e-32);
        EXPECT_LT(peorAngulo<double>(base, loma()), 8e-15);
        EXPECT_LT(peorAngulo<float>(base, loma()), 4e-6);
    }
}

// La talla y el sitio no cuentan.
TEST(Normales, DeCualquierTallaYEnCualquierSitio) {
    const std::pair<double, glm::dvec3> casos[] = {
        {1e-9, glm::dvec3(0)}, {1e9, glm::dvec3(0)}, {1, {1 << 20, 0, -(1 << 20)}}};
    for (const auto &c : casos) {
        const auto G = lleva<double>(loma(), [&](const glm::dvec3 &p) { return c.first * p + c.second; });
        EXPECT_LT(peorAngulo<double>(Base::BEZIER, G), 8e-15);
    }
}

/// La loma con algo que le quita la normal en un borde o en una esquina.
std::vector<Geometria2<double>> degeneradas() {
    const Geometria2<double> G = loma();
    std::vector<Geometria2<double>> d(9, G);
    for (std::size_t k = 0; k < 4; ++k) { // los cuatro bordes, dos a la vez y un borde y una esquina
        d[0][0][k] = d[7][0][k] = G[0][0];
        d[1][3][k] = G[3][1];
        d[2][k][0] = G[1][0];
        d[3][k][3] = G[2][3];
        d[4][0][k] = G[0][1];
        d[4][3][k] = G[3][2];
    }
    d[5][1][0] = G[0][0]; // sin tangente en u y en v
    d[6][3][2] = G[3][3];
    d[7][3][1] = G[3][0];
    d[8][0][1] = G[0][0] + 0.75 * (G[1][0] - G[0][0]); // con las dos paralelas
    return d;
}

TEST(Normales, UnBordeColapsadoLaTiene) {
    for (const Geometria2<double> &G : degeneradas()) {
        EXPECT_LT(peorAngulo<double>(Base::BEZIER, G, OCTAVOS), 1e-13);
        EXPECT_LT(peorAngulo<float>(Base::BEZIER, G, OCTAVOS), 1e-4);
    }
    for (int k = 1; k < 50; ++k) // ni salta al acercarse a él
        for (const double v : {0.0, 0.25, 0.5, 1.0}) {
            EXPECT_LT(angulo<double>(Base::BEZIER, degeneradas()[0], std::ldexp(1.0, -k), v), 1e-6) << k;
            EXPECT_LT(angulo<float>(Base::BEZIER, degeneradas()[0], std::ldexp(1.0, -k), v), 2e-3) << k;
        }
    Geometria2<double> G = loma(); // sin ninguna de las dos tangentes, la de cerca de la esquina
    G[0][1] = G[1][0] = G[0][0];
    EXPECT_LT(angulo<double>(Base::BEZIER, G, 0, 0), 0.1);
    EXPECT_LT(angulo<float>(Base::BEZIER, G, 0, 0), 0.1);
}

// ---- superficies.h: triángulos ----

/// Lo más que se separan la superficie y sus triángulos en el mismo (u, v), medido con `distancia`.
template<typename Distancia>
double mayorSeparacion(Base base, const Geometria2<float> &G, const Segmentos &segmentos,
                       const Distancia &distancia) {
    const Malla malla = mallaSuperficie(base, G, segmentos);
    double mayor = 0;
    for (std::size_t t = 0; t < malla.indices.size(); t += 3)
        for (int i = 0; i <= 6; ++i)
            for (int j = 0; i + j <= 6; ++j) {
                const double b[3] = {i / 6.0, j / 6.0, (6 - i - j) / 6.0};
                glm::dvec3 p(0);
                glm::dvec2 uv(0);
                for (std::size_t k = 0; k < 3; ++k) {
                    const Vertice &v = malla.vertices[malla.indices[t + k]];
                    p += b[k] * glm::dvec3(v.posicion);
                    uv += b[k] * glm::dvec2(v.coordTextura);
                }
                mayor = std::max(mayor, distancia(p, superficieRef(base, G, uv.x, uv.y)));
            }
    return mayor;
}
double separacion(Base base, const Geometria2<float> &G, const Segmentos &n) {
    return mayorSeparacion(base, G, n, lejos<double, double>);
}

// Nunca más de la tolerancia, y sin derrochar: con la cuarta parte de los triángulos se pasaría.
TEST(Triangulos, LoJustoParaLaTolerancia) {
    for (const Base base : BASES)
        for (unsigned vez = 0; vez <= 12; ++vez) {
            const auto G = vez ? redAlAzar<float>(vez) : lleva<float>(loma());
            for (const double tolerancia : {0.1, 0.003}) {
                const Segmentos n = segmentosSuperficie(base, G, tolerancia);
                EXPECT_LE(separacion(base, G, n), tolerancia) << vez;
                EXPECT_TRUE(tolerancia > 0.01 || separacion(base, G, {n.u / 2, n.v / 2}) > tolerancia) << vez;
            }
        }
}

// Un plano son dos triángulos; si solo hay curva en u, solo se parte u.
TEST(Triangulos, SoloDondeHayCurva) {
    const auto red = [](const auto &f) {
        return lleva<float>(loma(), [&](const glm::dvec3 &p) { return glm::dvec3(p.x, f(p.x, p.z), p.z); });
    };
    const auto plano = red([](double, double) { return 0.0; }),
               canal = red([](double x, double) { return x * (3 - x); });
    for (const Base base : {Base::BEZIER, Base::BSPLINE}) {
        const Segmentos p = segmentosSuperficie(base, plano, 1e-3),
                        c = segmentosSuperficie(base, canal, 1e-3);
        EXPECT_EQ(glm::ivec3(p.u, p.v, c.v), glm::ivec3(1));
        EXPECT_GT(c.u, 10);
    }
}

// Sin grietas: los vértices del borde que comparten dos trozos son los mismos, bit a bit.
TEST(Triangulos, LosTrozosVecinosCasan) {
    const auto P = puntosAlAzar<float>(25);
    const auto bordes = [](Base base, const Geometria2<float> &A, const Geometria2<float> &B, bool enU) {
        const Malla a = mallaSuperficie(base, A, {7, 7}), b = mallaSuperficie(base, B, {7, 7});
        for (std::size_t k = 0; k <= 7; ++k)
            EXPECT_EQ(a.vertices[enU ? 8 * k + 7 : 56 + k].posicion, b.vertices[enU ? 8 * k : k].posicion);
    };
    bordes(Base::BSPLINE, geometriaDeRed(P, 5), geometriaDeRed(P, 5, 1, 0), true);
    bordes(Base::BSPLINE, geometriaDeRed(P, 5), geometriaDeRed(P, 5, 0, 1), false);
    bordes(Base::HERMITE, primerTrozo(ELEMENTOS_INICIALES), segundoTrozo(ELEMENTOS_INICIALES, 0.7f), true);
}

// ---- Ejercicio 11.8 ----

// El borde coincide entero y las tangentes que lo cruzan son k veces las otras: la normal no cambia en toda la unión, y
// con k ≠ 1 la derivada sí (G1 y no C1).
TEST(HermiteUnidas, G1EnTodoElBorde) {
    for (const float k : {0.2f, 0.7f, 1.0f, 3.0f}) {
        const auto A = primerTrozo(ELEMENTOS_INICIALES), B = segundoTrozo(ELEMENTOS_INICIALES, k);
        const auto borde = [](const Geometria2<float> &G, int u, double v, int du, int dv) {
            return superficieRef(Base::HERMITE, G, Cuadruple(u), Cuadruple(v), du, dv);
        };
        for (const double v : OCTAVOS) {
            EXPECT_EQ(borde(A, 1, v, 0, 0), borde(B, 0, v, 0, 0));
            EXPECT_EQ(borde(A, 1, v, 0, 1), borde(B, 0, v, 0, 1));
            const Punto<Cuadruple> a = borde(A, 1, v, 1, 0), b = borde(B, 0, v, 1, 0);
            EXPECT_LT(lejos(b, Cuadruple(k) * a), 1e-6);
            EXPECT_GT(double(largo(a)), 0.1);
        }
    }
}

// ---- Los programas: la superficie, píxel a píxel, y lo que pintan encima ----

const glm::ivec2 NORMAL{480, 360};

oraculo::Camara camara(double azimut, double elevacion, double distancia, const oraculo::Vec3 &centro,
                       double angulo = 0.5) {
    return oraculo::perspectiva(oraculo::orbita(azimut, elevacion, distancia, centro), angulo, 1, 100);
}
const oraculo::Camara CAMARA_BEZIER = camara(0.55, 0.65, 8, {0, -0.35, 0}),
                      CAMARA_BSPLINE = camara(0.55, 0.6, 9.4, {0, -0.1, 0}),
                      CAMARA_HERMITE = camara(0.45, 0.6, 8.4, {0, -0.2, 0}),
                      CAMARA_UNION = camara(0.45, 0.6, 8.4, {1.25, -0.1, 0}, 0.65);

/// Lo que debe verse: unas superficies, de dos colores, y lo que va encima.
struct Escena : Lista {
    const oraculo::Camara c;
    using Superficie = std::function<glm::dvec3(double, double, int, int)>;
    struct Trozo {
        Superficie Q;
        bool naranja = false;
        Segmentos n = {48, 48}; // tantos, que da igual
    };
    std::vector<Trozo> trozos;
    void anade(Base base, const Geometria2<double> &G, bool naranja = false) {
        trozos.push_back(
            {[=](double u, double v, int du, int dv) { return superficieRef(base, G, u, v, du, dv); },
             naranja});
    }
    void anade(const RedBezier<double> &red, bool naranja = false) {
        trozos.push_back(
            {[=](double u, double v, int du, int dv) { return superficieRef(red, u, v, du, dv); }, naranja});
    }

    Escena(const oraculo::Camara &camara, const glm::ivec2 &laVentana) : Lista(laVentana), c(camara) {
    }
    glm::dvec2 px(const glm::dvec3 &p) const {
        return enPixeles(c, exacto(p), ventana.x, ventana.y);
    }
    Puntos px(const Red &P) const {
        Puntos r;
        std::transform(P.begin(), P.end(), std::back_inserter(r), [&](const glm::dvec3 &p) { return px(p); });
        return r;
    }
    /// El punto llevado a un píxel sin acercarse ni alejarse.
    glm::dvec3 llevado(const glm::dvec3 &p, const glm::dvec2 &sitio) const {
        const oraculo::Rayo r = oraculo::rayo(c, ventana.x, ventana.y, sitio.x, sitio.y);
        const oraculo::Vec3 eje = oraculo::ejes(c).z;
        const double t = escalar(exacto(p) - r.origen, eje) / escalar(r.direccion, eje);
        const oraculo::Vec3 q = r.origen + t * r.direccion;
        return {q.x, q.y, q.z};
    }

    /// Cada superficie, en triángulos con su normal exacta; cada cara, con su luz.
    oraculo::ImagenRef referencia() const {
        oraculo::Escena objetos;
        for (const Trozo &t : trozos) {
            const auto n = std::size_t(t.n.u), m = std::size_t(t.n.v);
            std::vector<oraculo::VerticeRef> vertices;
            std::vector<oraculo::Triangulos::Indices> indices;
            for (std::size_t i = 0; i <= n; ++i)
                for (std::size_t j = 0; j <= m; ++j) {
                    const double u = double(i) / double(n), v = double(j) / double(m);
                    const std::size_t a = i * (m + 1) + j, b = a + m + 1;
                    vertices.push_back({exacto(t.Q(u, v, 0, 0)), exacto(normalDe(t.Q, u, v))});
                    if (i < n && j < m)
                        indices.insert(indices.end(), {{a, b, b + 1}, {a, b + 1, a + 1}});
                }
            objetos.push_back(oraculo::malla(oraculo::Mat4(), vertices, indices));
        }
        return oraculo::render(objetos, c, ventana.x, ventana.y, [&](const oraculo::Impacto &i) {
            if (!i)
                return oraculo::Tono(exacto(FONDO_CLARO));
            const Material &m = trozos[std::size_t(i.objeto)].naranja ? LAMINA_NARANJA : LAMINA_AZUL;
            const double cara = i.frente ? 1 : -1;
            const oraculo::Luz luz = direccional(cara * oraculo::Vec3{-0.6, 0.85, 0.3});
            return oraculo::Tono(oraculo::phong({exacto(m.Ka), exacto(m.Kd), exacto(m.Ks), double(m.alfa)},
                                                {1, 1, 1}, {luz}, i.punto, cara * i.normal,
                                                oraculo::haciaOjo(i)),
                                 i.frente);
        });
    }
    void compruebaEscena(const Imagen &escena) const {
        ::comprueba("la superficie", escena, referencia(), {2, 100});
    }
};
using Pasos = std::vector<Paso<Escena>>;

/// De cada punto de una red al siguiente de su fila y al de su columna.
Red ladosDeRed(const Red &P, std::size_t columnas) {
    Red lados;
    for (std::size_t i = 0, filas = P.size() / columnas; i < filas; ++i)
        for (std::size_t j = 0; j < columnas; ++j) {
            const glm::dvec3 &p = P[columnas * i + j];
            if (j + 1 < columnas)
                lados.insert(lados.end(), {p, P[columnas * i + j + 1]});
            if (i + 1 < filas)
                lados.insert(lados.end(), {p, P[columnas * (i + 1) + j]});
        }
    return lados;
}
std::string nombre(std::size_t k, std::size_t columnas) {
    return "P" + std::to_string(k / columnas) + std::to_string(k % columnas);
}
// ---- superficie_bezier ----

/// Los 16 puntos o, con otros grados, los de su red en los mismos sitios.
RedBezier<double> redBezier(std::size_t n = 3, std::size_t m = 3) {
    const double y[] = {0.1, 0.8, 0.5, -0.1, 0.5, 1.5, 0.3, -0.3, -0.2, -0.2, -1.3, 0.2, -0.5, 0.2, 0.3, 0.7};
    RedBezier<double> red{n, m, {}};
    for (std::size_t k = 0; k < (n + 1) * (m + 1); ++k) {
        const double a = 3.0 * double(k / (m + 1)) / double(n), b = 3.0 * double(k % (m + 1)) / double(m);
        double altura = 0;
        for (int q = 0; q < 16; ++q) // lo que pesa cada uno baja hasta 0 en los que lo rodean
            altura +=
                y[q] * std::max(0.0, 1 - std::fabs(a - q / 4)) * std::max(0.0, 1 - std::fabs(b - q % 4));
        red.P.push_back({a - 1.5, altura, 1.5 - b});
    }
    return red;
}
using RedD = RedBezier<double>;
/// La superficie sola.
Escena lamina(const RedD &red, const oraculo::Camara &c = CAMARA_BEZIER, const glm::ivec2 &ventana = NORMAL) {
    Escena e(c, ventana);
    e.anade(red);
    return e;
}
void anadeRotulo(Escena &e, const std::string &texto, double x = 0.5, double y = 0.94) {
    e.rotulo(texto, {x * e.ventana.x, y * e.ventana.y}, OSCURO, Lado::CENTRO);
}
/// Su red, entera, y los nombres de las esquinas.
void anadeRed(Escena &e, const RedD &red, bool esquinas = true) {
    e.trazo("segmentos", e.px(ladosDeRed(red.P, red.m + 1)), GRIS, 0.7 * GROSOR);
    e.trazo("puntos", e.px(red.P), ROJO, 3.5 * GROSOR);
    for (std::size_t k = 0; k < red.P.size(); ++k) {
        const std::size_t i = k / (red.m + 1), j = k % (red.m + 1);
        if (esquinas && i % red.n == 0 && j % red.m == 0)
            e.rotulo(nombre(k, red.m + 1), e.px(red.P[k]), OSCURO, j == 0 ? Lado::DEBAJO : Lado::ENCIMA);
    }
}
Escena conRed(const RedD &red, const oraculo::Camara &c = CAMARA_BEZIER, const glm::ivec2 &ventana = NORMAL) {
    Escena e = lamina(red, c, ventana);
    anadeRed(e, red);
    anadeRotulo(e, "n = " + std::to_string(red.n) + ", m = " + std::to_string(red.m), 0.2, 0.06);
    return e;
}

TEST(SuperficieBezier, PixelAPixel) {
    compruebaPasos<Escena>(
        "superficie_bezier",
        {{"", conRed(redBezier())}, {"tamano 360 480", conRed(redBezier(), CAMARA_BEZIER, {360, 480})}});
    compruebaPasos<Escena>("superficie_bezier", {{"", conRed(redBezier(), CAMARA_BEZIER, {640, 320})}});
}

// Sube primero el grado en u. Los puntos son otros: no queda ninguno elegido.
TEST(SuperficieBezier, DeCualquierGrado) {
    compruebaPasos<Escena>("superficie_bezier", {{"tecla n ×3; tecla +", conRed(redBezier(4, 3))},
                                                 {"tecla +; especial ARRIBA", conRed(redBezier(4, 4))},
                                                 {"tecla + ×9", conRed(redBezier(7, 7))},
                                                 {"tecla -", conRed(redBezier(7, 6))},
                                                 {"tecla - ×10", conRed(redBezier(2, 1))},
                                                 {"tecla - ×4", conRed(redBezier(1, 1))},
                                                 {"tecla + ×4", conRed(redBezier(3, 3))}});
}

/// La superficie con sus triángulos, los que bastan para no separarse de ellos más de esos píxeles de la ventana.
Escena conMalla(double tolerancia, const std::string &texto, double acercada = 1,
                const glm::ivec2 &ventana = NORMAL) {
    const RedD red = redBezier();
    Escena e = lamina(red, camara(0.55, 0.65, 8 / acercada, {0, -0.35, 0}), ventana);
    double cerca = 100;
    for (const glm::dvec3 &p : red.P)
        cerca = std::min(cerca, oraculo::tallaPixel(e.c, ventana.x, ventana.y, exacto(p)));
    const auto G = lleva<float>(trozoDe(red.P, 4));
    const Segmentos n = segmentosSuperficie(Base::BEZIER, G, tolerancia * cerca);
    const double error = mayorSeparacion(Base::BEZIER, G, n, [&](const glm::dvec3 &a, const glm::dvec3 &b) {
        return glm::distance(e.px(a), e.px(b));
    });
    e.trozos[0].n = n;
    EXPECT_LE(error, tolerancia);
    EXPECT_GE(error, tolerancia < 10 ? 0.15 * tolerancia : 0);
    Red lados;
    for (int k = 0; k < n.u * n.v; ++k) {
        const auto esquina = [&, i = k % n.u, j = k / n.u](int di, int dj) {
            return superficieRef(red, double(i + di) / n.u, double(j + dj) / n.v);
        };
        const glm::dvec3 a = esquina(0, 0), b = esquina(1, 0), c = esquina(1, 1), d = esquina(0, 1);
        lados.insert(lados.end(), {a, b, b, c, c, a, a, c, c, d, d, a});
    }
    e.conProfundidad = true;
    e.trazo("segmentos", e.px(lados), BLANCO, 0.7 * GROSOR);
    e.conProfundidad = false;
    anadeRotulo(e, "hasta " + texto + " px: " + std::to_string(2 * n.u * n.v) + " triángulos");
    return e;
}

// Los triángulos que dice el rótulo son los que bastan, y la malla blanca va por sus lados; no hay red ni puntos.
TEST(SuperficieBezier, LaToleranciaEsEnPixeles) {
    compruebaPasos<Escena>("superficie_bezier",
                           {{"tecla m", conMalla(32, "32")},
                            {"tecla + ×9", conMalla(0.125, "0.125")},
                            {"tecla - ×6", conMalla(8, "8")},
                            {"tecla - ×9", conMalla(64, "64")},
                            {"tecla + ×6; rueda 1 9 9 ×4", conMalla(1, "1", std::pow(1.1, 4))},
                            {"tamano 300 400", conMalla(1, "1", std::pow(1.1, 4), {300, 400})},
                            {"tecla m; tamano 480 360",
                             conRed(redBezier(), camara(0.55, 0.65, 8 / std::pow(1.1, 4), {0, -0.35, 0}))}});
}

/// Las curvas en que v es constante, por la superficie; y los puntos de control de una, en las curvas de las filas.
Escena conFamilia(const RedD &red, double v, const std::string &texto) {
    Escena e = lamina(red);
    const double tolerancia = 0.001 / oraculo::tallaPixel(e.c, NORMAL.x, NORMAL.y, exacto({0, 0, 1.5}));
    const auto curva = [&](double laV, const glm::vec3 &color, double grosor) {
        e.curva([&](double u) { return e.px(superficieRef(red, u, laV)); }, color, grosor, tolerancia);
    };
    e.conProfundidad = true;
    for (int k = 0; k <= 10; ++k)
        curva(k / 10.0, BLANCO, 0.6 * GROSOR);
    e.conProfundidad = false;
    Red G;
    for (std::size_t i = 0; i <= red.n; ++i) {
        const auto fila = [&](double t) {
            const auto b = bernsteinRef(red.m, t);
            glm::dvec3 suma(0);
            for (std::size_t j = 0; j <= red.m; ++j)
                suma += b[j] * red.P[(red.m + 1) * i + j];
            return suma;
        };
        e.curva([&](double t) { return e.px(fila(t)); }, GRIS, GROSOR, tolerancia);
        G.push_back(fila(v));
    }
    curva(v, ROJO, 1.7 * GROSOR);
    e.trazo("polilinea", e.px(G), NARANJA, 0.8 * GROSOR);
    e.trazo("puntos", e.px(G), NARANJA, 4 * GROSOR);
    for (std::size_t i = 0; i < G.size(); ++i)
        e.rotulo("G" + std::to_string(i + 1), e.px(G[i]), OSCURO, Lado::ENCIMA);
    anadeRotulo(e, "Q(u, v), con v = " + texto);
    return e;
}

TEST(SuperficieBezier, LaFamiliaDeCurvas) {
    compruebaPasos<Escena>("superficie_bezier",
                           {{"tecla f", conFamilia(redBezier(), 0.4, "0.40")},
                            {"tecla +", conFamilia(redBezier(), 0.45, "0.45")},
                            {"tecla + ×20", conFamilia(redBezier(), 1, "1.00")},
                            {"tecla - ×30", conFamilia(redBezier(), 0, "0.00")},
                            {"tecla f", conRed(redBezier())},
                            {"tecla +; tecla f; tecla + ×14", conFamilia(redBezier(4, 3), 0.7, "0.70")}});
}

/// Con el trozo que se une: con los puntos de después del borde reflejados o, si se dan, a k veces lo que distan de él
/// los de antes. `grados`, los que se separan las normales.
Escena conUnion(const RedD &A, const std::vector<double> &k, const std::string &texto, double grados) {
    RedD B = A;
    const std::size_t columnas = A.m + 1;
    for (std::size_t q = 0; q < A.P.size(); ++q) {
        const std::size_t i = q / columnas, j = q % columnas;
        const glm::dvec3 borde = A.en(A.n, j), p = A.en(A.n - i, j);
        B.P[q] = i == 1 && !k.empty() ? borde + k[j] * (borde - p) : glm::dvec3(2 * borde.x - p.x, p.y, p.z);
    }
    Escena e(camara(0.55, 0.65, 8, {1.5, -0.2, 0}, 0.68), NORMAL);
    e.anade(A);
    e.anade(B, true);
    e.trozos[1].n = {192, 48}; // con proporciones distintas se curva mucho junto al borde
    anadeRed(e, A, false);
    for (std::size_t j = 0; j < columnas; ++j) {
        e.trazo("polilinea", e.px(Red{A.en(A.n - 1, j), A.en(A.n, j), B.en(1, j)}), OSCURO);
        e.trazo("puntos", {e.px(B.en(1, j))}, MORADO, 3.5 * GROSOR);
    }
    double separadas = 0;
    for (int v = 0; v <= 12; ++v) {
        const glm::dvec3 Q = superficieRef(A, 1.0, v / 12.0), a = normalDe(e.trozos[0].Q, 1.0, v / 12.0),
                         b = normalDe(e.trozos[1].Q, 0.0, v / 12.0);
        e.trazo("flecha", e.px(Red{Q, Q + 0.55 * a}), AZUL, 0.8 * GROSOR);
        e.trazo("flecha", e.px(Red{Q, Q + 0.55 * b}), NARANJA, 0.8 * GROSOR);
        separadas = std::max(separadas, 2 * std::asin(0.5 * glm::distance(a, b)) * 180 / M_PI);
    }
    EXPECT_NEAR(separadas, grados, 0.5) << texto;
    anadeRotulo(e, texto + ": normales a " + std::to_string(std::lround(grados)) + "°");
    return e;
}

// §11.7: C0, G1 y, con los puntos solo alineados, ni lo uno ni lo otro. De cualquier grado.
TEST(SuperficieBezier, DosTrozosUnidos) {
    const std::vector<double> iguales(9, 0.8), desiguales = {0.15, 2.2, 0.15, 2.2, 0.15};
    compruebaPasos<Escena>("superficie_bezier",
                           {{"tecla u", conUnion(redBezier(), {}, "C0", 84)},
                            {"tecla u", conUnion(redBezier(), iguales, "G1", 0)},
                            {"tecla u", conUnion(redBezier(), desiguales, "alineados", 19)},
                            {"tecla u", conRed(redBezier())},
                            {"tecla u ×2; tecla + ×2", conUnion(redBezier(4, 4), iguales, "G1", 0)},
                            {"tecla f; tecla m; tecla m", conRed(redBezier(4, 4))}});
}

// ---- superficie_bspline ----

Red redBSpline() {
    Red P;
    for (int k = 0; k < 36; ++k) {
        const double x = 0.8 * (k / 6) - 2, z = 2 - 0.8 * (k % 6);
        const auto monte = [&](double c) {
            return std::exp(-1.6 * (std::pow(x - c, 2) + std::pow(z - c, 2)));
        };
        P.push_back({x, 2 * monte(-0.5) - 1.5 * monte(0.6), z});
    }
    return P;
}
Escena nueveTrozos(const Red &P, bool red = true, const oraculo::Camara &c = CAMARA_BSPLINE,
                   const glm::ivec2 &ventana = NORMAL) {
    Escena e(c, ventana);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            e.anade(Base::BSPLINE, trozoDe(P, 6, i, j), (i + j) % 2 == 1);
    if (red) {
        e.conProfundidad = true;
        e.trazo("segmentos", e.px(ladosDeRed(P, 6)), GRIS, 0.6 * GROSOR);
        e.conProfundidad = false;
        e.trazo("puntos", e.px(P), ROJO, 3 * GROSOR);
    }
    return e;
}

TEST(SuperficieBSpline, PixelAPixel) {
    compruebaPasos<Escena>(
        "superficie_bspline",
        {{"", nueveTrozos(redBSpline())},
         {"tecla r", nueveTrozos(redBSpline(), false)},
         {"tamano 360 480", nueveTrozos(redBSpline(), false, CAMARA_BSPLINE, {360, 480})}});
}

// ---- superficie_hermite ----

/// De cada elemento, la esquina de la que sale: los del primer trozo, por filas, y las filas segunda y cuarta del otro.
const std::size_t ESQUINA[] = {0, 1, 0, 1, 4,  5,  4,  5,  0,  1,  0,  1,
                               4, 5, 4, 5, 16, 17, 16, 17, 16, 17, 16, 17};

/// Lo que se arrastra: las esquinas y las puntas de los vectores, que miden un tercio.
struct Elementos {
    Red p;
    explicit Elementos(std::size_t n)
        : p(ELEMENTOS_INICIALES.begin(), ELEMENTOS_INICIALES.begin() + long(n)) {
        for (std::size_t k = 0; k < n; ++k)
            if (ESQUINA[k] != k)
                p[k] = p[ESQUINA[k]] + p[k] / 3.0;
    }
    /// La esquina se lleva sus vectores.
    void lleva(std::size_t k, const glm::dvec3 &adonde) {
        const glm::dvec3 cuanto = adonde - p[k];
        for (std::size_t i = 0; i < p.size(); ++i)
            p[i] += (i == k || ESQUINA[i] == k) ? cuanto : glm::dvec3(0);
    }
    glm::dvec3 vector(std::size_t k) const {
        return ESQUINA[k] == k ? p[k] : 3.0 * (p[k] - p[ESQUINA[k]]);
    }
};

/// `k` es 0 si solo hay un trozo.
Escena hermite(const Elementos &de, double k = 0, const std::string &texto = "",
               const oraculo::Camara &c = CAMARA_HERMITE, const glm::ivec2 &ventana = NORMAL,
               int elegido = -1) {
    Geometria2<double> A, B;
    for (std::size_t i = 0; i < 16; ++i)
        A[i / 4][i % 4] = de.vector(i);
    Escena e(c, ventana);
    e.anade(Base::HERMITE, A);
    if (k > 0) {
        for (std::size_t j = 0; j < 4; ++j) {
            B[0][j] = A[1][j];
            B[1][j] = de.vector(16 + j);
            B[2][j] = k * A[3][j];
            B[3][j] = de.vector(20 + j);
        }
        e.anade(Base::HERMITE, B, true);
        e.conProfundidad = true;
        e.curva([&](double v) { return e.px(superficieRef(Base::HERMITE, A, 1.0, v)); }, BLANCO, GROSOR, 0.2);
        e.conProfundidad = false;
    }
    Red esquinas;
    for (std::size_t i = 0; i < de.p.size(); ++i)
        if (ESQUINA[i] == i)
            esquinas.push_back(de.p[i]);
        else { // en v, a la derecha; en u, abajo, o en la última fila del segundo
            const bool conU = i >= 20 || (i >= 8 && i < 16), conV = i % 4 >= 2;
            e.trazo("flecha", e.px(Red{de.p[ESQUINA[i]], de.p[i]}), !conU ? ROJO : conV ? MORADO : VERDE);
        }
    e.trazo("puntos", e.px(esquinas), OSCURO, 3 * GROSOR);
    if (elegido >= 0)
        e.trazo("puntos", {e.px(de.p[std::size_t(elegido)])}, ROJO, 3.5 * GROSOR);
    for (const int i : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15})
        if (ESQUINA[i] == std::size_t(i) || i == elegido)
            e.rotulo("g" + std::to_string(i / 4 + 1) + std::to_string(i % 4 + 1), e.px(de.p[std::size_t(i)]),
                     i == elegido ? ROJO : OSCURO,
                     i == 0                         ? Lado::DEBAJO
                     : ESQUINA[i] == std::size_t(i) ? Lado::IZQUIERDA
                                                    : Lado::DERECHA);
    if (k > 0)
        e.rotulo("G1 con k = " + texto, {0.5 * ventana.x, 0.08 * ventana.y}, OSCURO, Lado::CENTRO);
    return e;
}
const Elementos UNO(16), DOS(24);

TEST(SuperficieHermite, PixelAPixel) {
    compruebaPasos<Escena>("superficie_hermite",
                           {{"", hermite(UNO)},
                            {"tecla u", hermite(DOS, 0.7, "0.70", CAMARA_UNION)},
                            {"tecla +", hermite(DOS, 0.875, "0.88", CAMARA_UNION)},
                            {"tecla + ×20", hermite(DOS, 3, "3.00", CAMARA_UNION)},
                            {"tecla - ×20", hermite(DOS, 0.2, "0.20", CAMARA_UNION)},
                            {"tecla n ×3; tecla u", hermite(UNO)}, // y el elegido se suelta
                            {"tamano 360 540", hermite(UNO, 0, "", CAMARA_HERMITE, {360, 540})}});
}

// Una esquina de la unión, que es de los dos trozos; una tangente y una torsión, del primero y del segundo.
TEST(SuperficieHermite, ElRatonMueveCualquierElementoYGiraLaCamara) {
    const auto girada = camara(0.45 - 40 * 0.005, 0.6 - 290 * 0.005, 8.4, {0, -0.2, 0}); // la otra cara
    for (const bool dos : {false, true}) {
        Elementos p(dos ? 24 : 16);
        const auto debe = [&](int elegido) {
            return hermite(p, dos ? 0.7 : 0, "0.70", dos ? CAMARA_UNION : CAMARA_HERMITE, NORMAL, elegido);
        };
        Pasos pasos = {{dos ? "tecla u" : "", debe(-1)}};
        std::vector<std::pair<std::size_t, glm::ivec2>> van = {
            {4, {150, 265}}, {14, {300, 120}}, {9, {200, 60}}, {2, {100, 140}}};
        if (dos)
            van.push_back({16, {420, 240}});
        for (const auto &[k, hasta] : van) {
            const Escena e = debe(-1);
            const glm::ivec2 desde = e.raton(e.px(p.p[k])) + glm::ivec2(-3, 4);
            p.lleva(k, e.llevado(p.p[k], e.punto(hasta)));
            pasos.push_back({arrastra(desde, hasta), debe(int(k))});
        }
        compruebaPasos<Escena>("superficie_hermite", pasos);
    }
    compruebaPasos<Escena>("superficie_hermite",
                           {{arrastra({20, 340}, {60, 50}), hermite(UNO, 0, "", girada)}});
}

// ---- Lo que se ve ----

// Los píxeles son los de la lista sobre la escena, y la superficie tapa lo que va con profundidad y está detrás. Lo que
// va por ella se ve casi todo.
TEST(PintadoConProfundidad, LaListaSobreLaEscena) {
    const struct {
        std::string programa, guion;
        Escena escena;
        double visto;
    } casos[] = {{"superficie_bspline", "", nueveTrozos(redBSpline()), 0.3},
                 {"superficie_bspline", arrastra({20, 20}, {-40, -60}),
                  nueveTrozos(redBSpline(), true, camara(0.85, 0.2, 9.4, {0, -0.1, 0})), 0.3},
                 {"superficie_hermite", "tecla u", hermite(DOS, 0.7, "0.70", CAMARA_UNION), 0.5},
                 {"superficie_bezier", "tecla m; tecla +", conMalla(16, "16"), 0.9}};
    for (const auto &c : casos) {
        const oraculo::ImagenRef ref = c.escena.referencia();
        const auto delante = [&](int x, int y, double z) {
            const oraculo::PixelRef &r = ref.en(x, y);
            const double mas =
                200 / (101 - 99 * z) + enCamara(c.escena.c, r.punto).z; // lejos que lo que se ve
            return oraculo::enBanda(ref, x, y) ? 0 : r.objeto < 0 || mas < -0.05 ? 1 : mas > 0.3 ? -1 : 0;
        };
        EXPECT_GT(compruebaPintado(c.programa, c.guion, NORMAL, delante), c.visto);
    }
}

} // namespace
