// Las superficies del capítulo 11: superficies.h contra la definición en cuádruple precisión, y las de sus programas,
// trazadas. Lo que pintan encima está en sus .encima.
#include "ch11_curvas/hermite_trozos.h"
#include "ch11_curvas/lamina.h"
#include "ch11_referencia.h"
#include "colores.h"
#include "contra_oraculo.h"
#include "guiones.h"
#include "tabla.h"

namespace {

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

/// La misma red en otra precisión.
template<typename T>
Geometria2<T> lleva(const Geometria2<double> &G) {
    return redDe<T>([&](std::size_t i, std::size_t j) { return G[i][j]; });
}

/// Una red con un poco de forma y sus puntos de Bézier en (i, f, j), de esa talla y en ese sitio.
Geometria2<double> loma(double talla = 1, const glm::dvec3 &sitio = glm::dvec3(0)) {
    const double y[] = {0, 1, 0.5, -0.5, 0.5, 1.5, 0, 0, 0, -0.5, -1, 0.5, -0.5, 0, 0.5, 1};
    return redDe([&](std::size_t i, std::size_t j) {
        return talla * glm::dvec3(double(i), y[4 * i + j], -double(j)) + sitio;
    });
}

/// Los 16 puntos de una red de n×n que empiezan en una fila y una columna.
using Red = std::vector<glm::dvec3>;
Geometria2<double> trozoDe(const Red &P, std::size_t n, std::size_t i, std::size_t j) {
    return redDe([&](std::size_t fila, std::size_t columna) { return P[n * (i + fila) + j + columna]; });
}

// ---- superficies.h: puntos y derivadas ----

/// El mayor error de la superficie o de una derivada suya.
template<typename T>
void compruebaError(Base base, unsigned semilla, int du, int dv, double cota) {
    const auto G = redAlAzar<T>(semilla);
    const auto error = [&](double u, double v) {
        return lejos(superficie(base, G, T(u), T(v), du, dv),
                     superficieRef(base, G, Cuadruple(T(u)), Cuadruple(T(v)), du, dv));
    };
    EXPECT_LT(peor(error), redondeos<T>(cota)) << du << dv;
}

TEST(Superficies, ErrorFrenteACuadruplePrecision) {
    const struct {
        int du, dv;
        double cota;
    } casos[] = {{0, 0, 3}, {1, 0, 12}, {0, 1, 12}, {1, 1, 60}, {2, 0, 60}, {0, 2, 60}};
    for (const auto &[du, dv, cota] : casos)
        for (const Base base : BASES)
            for (unsigned semilla = 0; semilla < 20; ++semilla) {
                compruebaError<float>(base, semilla, du, dv, cota);
                compruebaError<double>(base, semilla, du, dv, cota);
                compruebaError<Cuadruple>(base, semilla, du, dv, cota);
            }
}

// Ecuación 11.41, con (n + 1)×(m + 1) puntos: la superficie y sus derivadas, que también se anulan cuando el grado no
// da para más. Cada peso se equivoca en unos redondeos por grado. Y §11.5: en v es la curva de Bézier de los puntos
// G(v).
TEST(Superficies, BezierDeGradoNxM) {
    for (const auto &[n, m] :
         {std::pair<std::size_t, std::size_t>{1, 1}, {0, 2}, {3, 3}, {5, 2}, {1, 7}, {12, 9}, {1, 60}}) {
        const RedBezier<double> red = {n, m, puntosAlAzar<double>((n + 1) * (m + 1), 7)};
        const auto error = [&](int du, int dv, const auto &Q) {
            return peor([&](double u, double v) {
                return lejos(Q(u, v), superficieRef(red, Cuadruple(u), Cuadruple(v), du, dv));
            });
        };
        const double cota = redondeos<double>(2 * double(n + m + 1));
        for (const auto &[du, dv] : {std::pair<int, int>{0, 0}, {1, 0}, {0, 1}, {1, 1}, {2, 0}, {0, 2}}) {
            const auto Q = [&, i = du, j = dv](double u, double v) { return superficie(red, u, v, i, j); };
            const double sumandos = std::pow(2.0 * double(n + 1), du) * std::pow(2.0 * double(m + 1), dv);
            EXPECT_LT(error(du, dv, Q), cota * sumandos) << n << m << du << dv;
        }
        EXPECT_LT(error(0, 0, [&](double u, double v) { return bezier(geometriaEn(red, v), u); }), cota);
    }
}

// Con puntos duplicados, aunque el libro diga que no (§11.8), dos trozos vecinos siguen unidos: lo que se pierde es la
// tangente, y con una fila repetida tres veces Q_u se anula en todo un borde.
TEST(Superficies, BSplineConFilasRepetidasPierdeLaTangente) {
    Geometria2<double> G = loma();
    G[1] = G[2] = G[0];
    const Geometria2<double> siguiente = {G[1], G[2], G[3], loma()[1]};
    for (const double v : OCTAVOS) {
        EXPECT_LT(glm::length(superficie(Base::BSPLINE, G, 0.0, v, 1, 0)), 1e-15);
        for (const int d : {0, 1, 2})
            EXPECT_LT(lejos(superficie(Base::BSPLINE, G, 1.0, v, d, 0),
                            superficie(Base::BSPLINE, siguiente, 0.0, v, d, 0)),
                      4e-15);
    }
}

// ---- superficies.h: normales ----

/// El mayor ángulo entre la normal, que es unitaria, y la de referencia.
template<typename T>
double peorAngulo(Base base, const Geometria2<double> &enDoble, const std::vector<double> &us,
                  const std::vector<double> &vs) {
    const auto G = lleva<T>(enDoble);
    const auto Q = [&](const Cuadruple &s, const Cuadruple &t, int du, int dv) {
        return superficieRef(base, G, s, t, du, dv);
    };
    double peor = 0;
    for (const double u : us)
        for (const double v : vs) {
            const Punto<Cuadruple> m(normalSuperficie(base, G, T(u), T(v))),
                n = normalDe(Q, Cuadruple(u), Cuadruple(v));
            EXPECT_LT(std::fabs(double(largo(m) - Cuadruple(1))), redondeos<T>(4));
            peor = mayor(peor, std::atan2(double(largo(cruz(m, n))), glm::dot(glm::dvec3(m), glm::dvec3(n))));
        }
    return peor;
}

// La talla y el sitio no cuentan.
TEST(Normales, ContraCuadruplePrecision) {
    for (const Base base : BASES) {
        EXPECT_LT(peorAngulo<Cuadruple>(base, loma(), PARAMETROS, PARAMETROS), 1e-32);
        EXPECT_LT(peorAngulo<double>(base, loma(), PARAMETROS, PARAMETROS), 8e-15);
        EXPECT_LT(peorAngulo<float>(base, loma(), PARAMETROS, PARAMETROS), 4e-6);
    }
    for (const auto &G : {loma(1e-15), loma(1e15), loma(1, {1 << 20, 0, -(1 << 20)})}) {
        EXPECT_LT(peorAngulo<double>(Base::BEZIER, G, PARAMETROS, PARAMETROS), 8e-15);
        EXPECT_LT(peorAngulo<float>(Base::BEZIER, G, PARAMETROS, PARAMETROS), 4e-6);
    }
}

/// La loma con algo que le quita la normal en un borde o en una esquina.
std::vector<Geometria2<double>> degeneradas() {
    const Geometria2<double> G = loma();
    std::vector<Geometria2<double>> d(7, G);
    for (std::size_t k = 0; k < 4; ++k) { // un borde, dos a la vez y un borde y una esquina
        d[0][0][k] = d[1][0][k] = G[0][0];
        d[2][k][3] = G[2][3];
        d[3][0][k] = G[0][1];
        d[3][3][k] = G[3][2];
    }
    d[1][3][1] = G[3][0]; // sin tangente en u y en v
    d[4][1][0] = G[0][0];
    d[5][3][2] = G[3][3];
    d[6][0][1] = G[0][0] + 0.75 * (G[1][0] - G[0][0]); // con las dos paralelas
    return d;
}

TEST(Normales, UnBordeColapsadoLaTiene) {
    for (const Geometria2<double> &G : degeneradas()) {
        EXPECT_LT(peorAngulo<double>(Base::BEZIER, G, OCTAVOS, OCTAVOS), 1e-13);
        EXPECT_LT(peorAngulo<float>(Base::BEZIER, G, OCTAVOS, OCTAVOS), 1e-4);
    }
    std::vector<double> cerca; // ni salta al acercarse a él
    for (int k = 1; k < 50; ++k)
        cerca.push_back(std::ldexp(1.0, -k));
    EXPECT_LT(peorAngulo<double>(Base::BEZIER, degeneradas()[0], cerca, OCTAVOS), 1e-6);
    EXPECT_LT(peorAngulo<float>(Base::BEZIER, degeneradas()[0], cerca, OCTAVOS), 2e-3);
    Geometria2<double> G = loma(); // sin ninguna de las dos tangentes, la de cerca de la esquina
    G[0][1] = G[1][0] = G[0][0];
    EXPECT_LT(peorAngulo<float>(Base::BEZIER, G, {0}, {0}), 0.1);
}

// Un trozo que es un punto o una recta no tiene normal, pero se da una.
TEST(Normales, UnitariaAunqueNoHayaSuperficie) {
    for (const float largo : {0.0f, 1.0f}) {
        const auto G = redDe<float>([&](std::size_t i, std::size_t j) {
            return largo * Punto<float>(float(i + j)) + Punto<float>(1, 2, 3);
        });
        const auto falta = [&](double u, double v) {
            return std::fabs(glm::length(normalSuperficie(Base::BEZIER, G, float(u), float(v))) - 1);
        };
        EXPECT_LT(peor(falta), redondeos<float>(4));
    }
}

// ---- superficies.h: triángulos ----

/// Lo más que se separan la superficie y sus triángulos en el mismo (u, v): en una rejilla de cada uno, de seis puntos
/// por lado.
double separacion(Base base, const Geometria2<float> &G, const Segmentos &segmentos) {
    const Malla m = mallaSuperficie(base, G, segmentos);
    const int n = 6;
    double mayor = 0;
    for (std::size_t t = 0; t < m.indices.size(); t += 3)
        for (int i = 0; i <= n; ++i)
            for (int j = 0; i + j <= n; ++j) {
                glm::dvec3 p(0);
                glm::dvec2 uv(0);
                for (const auto &[k, peso] : {std::pair<std::size_t, int>{0, i}, {1, j}, {2, n - i - j}}) {
                    const Vertice &v = m.vertices[m.indices[t + k]];
                    p += glm::dvec3(v.posicion) * double(peso) / double(n);
                    uv += glm::dvec2(v.coordTextura) * double(peso) / double(n);
                }
                mayor = std::max(mayor, glm::distance(p, superficieRef(base, G, uv.x, uv.y)));
            }
    return mayor;
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

// ---- Los programas: la superficie, píxel a píxel ----

const glm::ivec2 NORMAL{480, 360};

oraculo::Camara camara(double azimut, double elevacion, double distancia, const oraculo::Vec3 &centro,
                       double angulo = 0.5) {
    return oraculo::perspectiva(oraculo::orbita(azimut, elevacion, distancia, centro), angulo, 1, 100);
}
const oraculo::Camara CAMARA_BEZIER = camara(0.55, 0.65, 8, {0, -0.35, 0}),
                      CAMARA_BSPLINE = camara(0.55, 0.6, 9.4, {0, -0.1, 0}),
                      CAMARA_HERMITE = camara(0.45, 0.6, 8.4, {0, -0.2, 0}),
                      CAMARA_UNION = camara(0.45, 0.6, 8.4, {1.25, -0.1, 0}, 0.65);

/// Una superficie, Q(u, v, du, dv), de uno de los dos colores.
struct Trozo {
    std::function<glm::dvec3(double, double, int, int)> Q;
    bool naranja = false;
    Segmentos n = {48, 48}; // tantos, que da igual
};
Trozo trozo(Base base, const Geometria2<double> &G, bool naranja = false) {
    return {[=](double u, double v, int du, int dv) { return superficieRef(base, G, u, v, du, dv); },
            naranja};
}
using RedD = RedBezier<double>;
Trozo trozo(const RedD &red, const Segmentos &n = {48, 48}, bool naranja = false) {
    return {[=](double u, double v, int du, int dv) { return superficieRef(red, u, v, du, dv); }, naranja, n};
}

/// Cada superficie, en triángulos con su normal exacta; cada cara, con su luz.
oraculo::ImagenRef referencia(const oraculo::Camara &c, const std::vector<Trozo> &trozos,
                              const glm::ivec2 &ventana = NORMAL) {
    oraculo::Escena objetos;
    for (const Trozo &t : trozos) {
        std::vector<oraculo::VerticeRef> vertices;
        std::vector<oraculo::Triangulos::Indices> indices;
        ponSuperficie(vertices, indices, t.Q, t.n);
        objetos.push_back(oraculo::malla(oraculo::Mat4(), vertices, indices));
    }
    return oraculo::render(objetos, c, ventana.x, ventana.y, [&](const oraculo::Impacto &i) {
        if (!i)
            return oraculo::Tono(exacto(FONDO_CLARO));
        const Material &m = trozos[std::size_t(i.objeto)].naranja ? LAMINA_NARANJA : LAMINA_AZUL;
        const double cara = i.frente ? 1 : -1;
        const oraculo::Luz luz = direccional(cara * oraculo::Vec3{-0.6, 0.85, 0.3});
        return oraculo::Tono(oraculo::phong({exacto(m.Ka), exacto(m.Kd), exacto(m.Ks), double(m.alfa)},
                                            {1, 1, 1}, {luz}, i.punto, cara * i.normal, oraculo::haciaOjo(i)),
                             i.frente);
    });
}

/// Lo que debe verse tras un guion.
struct Caso {
    std::string guion;
    oraculo::Camara camara;
    std::vector<Trozo> trozos;
};
void compruebaEscena(const Vista &v, const Caso &c) {
    comprueba("la superficie", v.escena, referencia(c.camara, c.trozos, {v.escena.ancho, v.escena.alto}),
              {2, 100});
}
void compruebaCasos(const std::string &programa, const std::vector<Caso> &casos) {
    paraCada(programa, casos, NORMAL.x, NORMAL.y,
             [](const Caso &c, const Vista &v) { compruebaEscena(v, c); });
}

// ---- superficie_bezier ----

/// Los 16 puntos o, con otros grados, los de su red en los mismos sitios.
RedD redBezier(std::size_t n = 3, std::size_t m = 3) {
    const double y[] = {0.1, 0.8, 0.5, -0.1, 0.5, 1.5, 0.3, -0.3, -0.2, -0.2, -1.3, 0.2, -0.5, 0.2, 0.3, 0.7};
    RedD red{n, m, {}};
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

TEST(SuperficieBezier, PixelAPixel) {
    compruebaCasos("superficie_bezier",
                   {{"", CAMARA_BEZIER, {trozo(redBezier())}},
                    {"tamano 360 480", CAMARA_BEZIER, {trozo(redBezier())}},
                    {"tamano 640 320; tecla +", CAMARA_BEZIER, {trozo(redBezier(4, 3))}},
                    {"tamano 480 360; tecla + ×9; tecla -", CAMARA_BEZIER, {trozo(redBezier(7, 6))}},
                    {"tecla - ×20", CAMARA_BEZIER, {trozo(redBezier(1, 1))}}});
}

// §11.7: C0, con los puntos de después del borde reflejados; G1, con los primeros a 0.8 veces lo que distan de él los
// de antes; y, con esos puntos solo alineados, ni lo uno ni lo otro. De cualquier grado. El rótulo dice lo que se
// separan las normales.
TEST(SuperficieBezier, DosTrozosUnidos) {
    const std::vector<double> iguales(9, 0.8), desiguales = {0.15, 2.2, 0.15, 2.2, 0.15};
    const struct {
        std::string guion, nombre;
        RedD A;
        std::vector<double> k;
    } casos[] = {{"tecla u", "C0: normales a 84°", redBezier(), {}},
                 {"tecla u", "G1: normales a 0°", redBezier(), iguales},
                 {"tecla u", "alineados: normales a 19°", redBezier(), desiguales},
                 {"tecla u ×3; tecla + ×2", "G1: normales a 0°", redBezier(4, 4), iguales}};
    paraCada("superficie_bezier", casos, NORMAL.x, NORMAL.y, [](const auto &c, const Vista &vista) {
        RedD B = c.A;
        for (std::size_t i = 0; i <= B.n; ++i)
            for (std::size_t j = 0; j <= B.m; ++j) {
                const glm::dvec3 borde = c.A.en(B.n, j), p = c.A.en(B.n - i, j);
                B.P[i * (B.m + 1) + j] = i == 1 && !c.k.empty() ? borde + c.k[j] * (borde - p)
                                                                : glm::dvec3(2 * borde.x - p.x, p.y, p.z);
            }
        // con proporciones distintas se curva mucho junto al borde
        const std::vector<Trozo> trozos = {trozo(c.A), trozo(B, {192, 48}, true)};
        compruebaEscena(vista, {c.guion, camara(0.55, 0.65, 8, {1.5, -0.2, 0}, 0.68), trozos});
        double separadas = 0;
        for (int v = 0; v <= 12; ++v)
            separadas = std::max(separadas, std::acos(std::min(glm::dot(normalDe(trozos[0].Q, 1.0, v / 12.0),
                                                                        normalDe(trozos[1].Q, 0.0, v / 12.0)),
                                                               1.0)));
        const std::string rotulo = c.nombre.substr(0, c.nombre.find(" a ") + 3) +
                                   std::to_string(std::lround(separadas * 180 / M_PI)) + "°";
        EXPECT_EQ(rotulo, c.nombre);
        EXPECT_EQ(vista.encima.rotulos(rotulo).size(), 1u);
    });
}

// ---- superficie_bspline ----

/// Con la tercera fila de puntos de control, esas veces.
std::vector<Trozo> nueveTrozos(int veces = 1) {
    Red P;
    for (int k = 0; k < 30 + 6 * veces; ++k) {
        const int fila = k / 6 <= 2 ? k / 6 : std::max(2, k / 6 - veces + 1);
        const double x = 0.8 * fila - 2, z = 2 - 0.8 * (k % 6);
        const auto monte = [&](double c) {
            return std::exp(-1.6 * (std::pow(x - c, 2) + std::pow(z - c, 2)));
        };
        P.push_back({x, 2 * monte(-0.5) - 1.5 * monte(0.6), z});
    }
    std::vector<Trozo> trozos;
    for (std::size_t i = 0; i + 3 < P.size() / 6; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            trozos.push_back(trozo(Base::BSPLINE, trozoDe(P, 6, i, j), (i + j) % 2 == 1));
    return trozos;
}

TEST(SuperficieBSpline, PixelAPixel) {
    compruebaCasos("superficie_bspline", {{"", CAMARA_BSPLINE, nueveTrozos()},
                                          {"tecla d", CAMARA_BSPLINE, nueveTrozos(2)},
                                          {"tecla d", CAMARA_BSPLINE, nueveTrozos(3)},
                                          {"tecla d; tamano 360 480", CAMARA_BSPLINE, nueveTrozos()}});
}

// ---- superficie_hermite ----

/// Las filas de `elementos`, que son puntos y vectores; con k, también el segundo trozo, unido al primero.
std::vector<Trozo> hermite(const Red &elementos, double k = 0) {
    const Geometria2<double> A = trozoDe(elementos, 4, 0, 0);
    Geometria2<double> B;
    for (std::size_t j = 0; j < 4; ++j) {
        B[0][j] = A[1][j];
        B[1][j] = elementos[16 + j];
        B[2][j] = k * A[3][j];
        B[3][j] = elementos[20 + j];
    }
    std::vector<Trozo> trozos = {trozo(Base::HERMITE, A), trozo(Base::HERMITE, B, true)};
    trozos.resize(k > 0 ? 2 : 1);
    return trozos;
}
const Red ELEMENTOS(ELEMENTOS_INICIALES.begin(), ELEMENTOS_INICIALES.end());

TEST(SuperficieHermite, PixelAPixel) {
    compruebaCasos("superficie_hermite",
                   {{"", CAMARA_HERMITE, hermite(ELEMENTOS)},
                    {"tecla u", CAMARA_UNION, hermite(ELEMENTOS, 0.7)},
                    {"tecla + ×20", CAMARA_UNION, hermite(ELEMENTOS, 3)},
                    {"tecla - ×20", CAMARA_UNION, hermite(ELEMENTOS, 0.2)},
                    {"tecla u; tamano 360 540", CAMARA_HERMITE, hermite(ELEMENTOS)},
                    {"tamano 480 360; " + arrastra({20, 340}, {60, 50}), // la otra cara
                     camara(0.45 - 40 * 0.005, 0.6 - 290 * 0.005, 8.4, {0, -0.2, 0}), hermite(ELEMENTOS)}});
}

} // namespace
