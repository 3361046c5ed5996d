// Comprobaciones independientes de la tetera y de ch02_modelado/bezier.h: normales contra derivadas en cuádruple
// precisión, error de cuerda, grietas y fronteras de longitud cero.
#include "ch02_modelado/bezier.h"
#include "colores.h"
#include "contra_oraculo.h"
#include "guiones.h"
#include "mallas.h"
#include "oraculo/cuadruple.h"
#include <tuple>

namespace {

using namespace oraculo;

const double U = std::ldexp(1.0, -53);

/// Lo que se comprueba de un parche en (u, v): su punto, sus derivadas y su normal.
struct PuntoParche {
    glm::dvec3 posicion, du, dv, normal;
};
PuntoParche evaluaParche(const Parche &q, double u, double v) {
    using namespace parche;
    const auto u0 = pesos0(u, 1 - u), v0 = pesos0(v, 1 - v);
    return {posicion(q, u0, v0), derivada(q, pesos1(u, 1 - u), v0), derivada(q, u0, pesos1(v, 1 - v)),
            normal(q, u, v)};
}

// La cámara del programa.
Camara camaraTetera(double gira = 0, double sube = 0, double distancia = 9.5) {
    return perspectiva(orbita(0.22 + gira, 0.38 + sube, distancia, {0.43, 1.42, 0}), 0.55, 0.5, 50);
}
/// En los datos la vertical es Z, y en la cámara Y.
Vec3 enPie(const glm::dvec3 &p) {
    return {p.x, p.z, -p.y};
}

/// El parche de puntos punto(fila, columna).
template<class F>
Parche conPuntos(F punto) {
    Parche q;
    for (int i = 0; i < 16; ++i)
        q.p[i / 4][i % 4] = punto(i / 4, i % 4);
    return q;
}

const std::vector<Parche> &tetera() {
    static const std::vector<Parche> parches = leeParches("assets/tetera.txt");
    return parches;
}

// ---- Referencia: de Casteljau, sin los pesos de Bernstein del programa; en cuádruple precisión o en doble ----

template<class T>
using Punto = glm::vec<3, T>;

template<class T>
std::pair<Punto<T>, Punto<T>> casteljau(const Punto<T> &a, const Punto<T> &b, const Punto<T> &c,
                                        const Punto<T> &d, T t) {
    const auto mezcla = [t](const Punto<T> &p, const Punto<T> &q) { return (T(1) - t) * p + t * q; };
    const Punto<T> bc = mezcla(b, c), abc = mezcla(mezcla(a, b), bc), bcd = mezcla(bc, mezcla(c, d));
    return {mezcla(abc, bcd), T(3) * (bcd - abc)};
}

template<class T>
struct Exacto {
    Punto<T> posicion, du, dv, n; // n sin normalizar
};

template<class T>
Exacto<T> evalua(const Parche &q, T u, T v) {
    std::pair<Punto<T>, Punto<T>> fila[4]; // punto y tangente
    for (int i = 0; i < 4; ++i)
        fila[i] =
            casteljau(Punto<T>(q.p[i][0]), Punto<T>(q.p[i][1]), Punto<T>(q.p[i][2]), Punto<T>(q.p[i][3]), u);
    const auto enV = casteljau(fila[0].first, fila[1].first, fila[2].first, fila[3].first, v);
    const Punto<T> a = casteljau(fila[0].second, fila[1].second, fila[2].second, fila[3].second, v).first,
                   b = enV.second;
    return {enV.first, a, b, {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}};
}

double separacion(const glm::dvec3 &a, const Punto<Cuadruple> &b) { // |a − b/|b||
    return double(largo(Punto<Cuadruple>(a) - b / largo(b)));
}

// Cota del error de la normal en doble precisión. Cada derivada es una suma de 16 productos de pesos (menos de 8
// redondeos), diferencias (1) y la propia suma (15): 24 redondeos, relativos a la suma de valores absolutos. El
// producto vectorial divide por el seno del ángulo entre las derivadas, y él y normalizar añaden 8.
double cotaNormal(const Parche &q, const Exacto<Cuadruple> &e, double u, double v) {
    using Pesos = std::array<double, 4>; // los de Bernstein, y cotas de los sumandos de los de sus derivadas
    const auto pesos = [](double t) {
        return Pesos{std::pow(1 - t, 3), 3 * t * (1 - t) * (1 - t), 3 * t * t * (1 - t), t * t * t};
    };
    const auto derivados = [](double t) {
        const double a = 3 * (1 - t) * (1 - t), b = 6 * t * (1 - t), c = 3 * t * t;
        return Pesos{a, a + b, b + c, c};
    };
    double su = 0, sv = 0;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
            const double l = glm::length(q.p[i][j] - q.p[0][0]);
            su += derivados(u)[j] * pesos(v)[i] * l;
            sv += pesos(u)[j] * derivados(v)[i] * l;
        }
    const double lu = double(largo(e.du)), lv = double(largo(e.dv)), ln = double(largo(e.n));
    return U * (24 * (su / lu + sv / lv) + 8) * (lu * lv / ln);
}

/// Lo más que se separan los triángulos de la tetera de la superficie.
double errorDeCuerda(double tolerancia, int paso) {
    const Malla malla = teselaParches(tetera(), tolerancia).malla;
    std::vector<std::size_t> parche; // de cada vértice
    for (const Division &d : divisionesPara(tetera(), tolerancia))
        parche.insert(parche.end(), std::size_t((d.nu + 1) * (d.nv + 1)),
                      parche.empty() ? 0 : parche.back() + 1);
    EXPECT_EQ(parche.size(), malla.vertices.size());
    return separacionMaxima(malla, paso, [&](unsigned v, const glm::dvec3 &p, const glm::dvec2 &uv) {
        return glm::distance(p, evalua(tetera()[parche[v]], uv.x, uv.y).posicion);
    });
}

// La posición y la normal, en una rejilla con las fronteras, contra la referencia. La cota es la de cotaNormal.
TEST(Bezier, NormalesContraDerivadasEnCuadruple) {
    int comparadas = 0;
    for (const Parche &q : tetera())
        for (int i = 0; i <= 7; ++i)
            for (int j = 0; j <= 7; ++j) {
                const double u = i / 7.0, v = j / 7.0;
                const Exacto<Cuadruple> e = evalua<Cuadruple>(q, u, v);
                const PuntoParche p = evaluaParche(q, u, v);
                // |P| ≤ 3.6 y las derivadas no pasan de 60; 12 redondeos por curva y dos curvas
                for (const auto &[hay, debe, talla] :
                     {std::tuple(p.posicion, e.posicion, 3.6), {p.du, e.du, 60.0}, {p.dv, e.dv, 60.0}}) {
                    const glm::dvec3 error = glm::abs(glm::dvec3(Punto<Cuadruple>(hay) - debe));
                    EXPECT_LE(std::max({error.x, error.y, error.z}), 24 * U * talla);
                }
                if (largo(e.du) < 1e-20 || largo(e.dv) < 1e-20)
                    continue; // fronteras de longitud cero: la prueba siguiente
                EXPECT_LE(separacion(p.normal, e.n), cotaNormal(q, e, u, v)) << u << "," << v;
                ++comparadas;
            }
    EXPECT_EQ(comparadas, 32 * 64 - 8 * 8);
}

// En el centro de la tapa y en el del fondo ∂u = 0: el límite de la normal es ±Z; el camino desde dentro lo cruza sin
// saltos ni NaN.
TEST(Bezier, FronterasDeLongitudCero) {
    for (const std::size_t primero : {20u, 28u})
        for (std::size_t k = primero; k < primero + 4; ++k)
            for (int i = 0; i <= 20; ++i) {
                const double u = i / 20.0, z = primero == 20 ? 1 : -1;
                EXPECT_LE(glm::distance(evaluaParche(tetera()[k], u, 0).normal, glm::dvec3(0, 0, z)), 1e-15);
                for (double v : {1e-300, 1e-30, 1e-16, 1e-9, 1e-8, 1e-7, 1e-6, 1e-4}) {
                    const glm::dvec3 m = evaluaParche(tetera()[k], u, v).normal;
                    // cerca del borde la normal se inclina en proporción a v (menos de 1 radián por unidad)
                    EXPECT_LE(separacion(m, evalua<Cuadruple>(tetera()[k], u, v).n), 1e-7 + v * 1e-6) << v;
                }
            }
}

// Parches sin normal en todo o en parte: siempre unitaria y finita.
TEST(Bezier, NuncaNaN) {
    const auto torcido = [](int i, int j) { return glm::dvec3(i, j, i * j); };
    const Parche punto = conPuntos([](int, int) { return glm::dvec3(1, 2, 3); }),
                 recta = conPuntos([](int i, int j) { return glm::dvec3(i + j, 0, 0); }),
                 dosLados =
                     conPuntos([&](int i, int j) { return i * j == 0 ? glm::dvec3(0) : torcido(i, j); }),
                 diminuto = conPuntos([&](int i, int j) { return 1e-100 * torcido(i, j); }),
                 lejano = conPuntos([&](int i, int j) { return torcido(i, j) + glm::dvec3(1e8, -1e8, 1e8); });
    for (const Parche &q : {punto, recta, dosLados, diminuto, lejano})
        for (int i = 0; i <= 8; ++i)
            for (int j = 0; j <= 8; ++j) {
                const PuntoParche p = evaluaParche(q, i / 8.0, j / 8.0);
                EXPECT_NEAR(glm::length(p.normal), 1, 1e-14);
                EXPECT_TRUE(std::isfinite(p.posicion.x + p.du.x + p.dv.x));
            }
    EXPECT_TRUE(teselaParches({punto}, 0.1).malla.indices.empty());
    // A 1e8 del origen las derivadas no pierden nada, porque los puntos de control se restan antes, sin error; ni con
    // talla 1e-100.
    for (const double u : {0.1, 0.5, 0.9})
        for (const Parche &q : {diminuto, lejano})
            EXPECT_LE(separacion(evaluaParche(q, u, 0.3).normal, evalua<Cuadruple>(lejano, u, 0.3).n), 1e-14);
}

// La distancia de cada punto de un triángulo al punto de la superficie con los mismos (u, v) no pasa de la tolerancia
// (más el redondeo a float de posiciones y parámetros: 4·2⁻²⁴ y, con derivadas de hasta 12, 12·2⁻²⁴). Tampoco sobra
// demasiado: el peor parche llega a más de un cuarto de la tolerancia.
TEST(Bezier, ErrorDeCuerda) {
    const double redondeo = 16 * std::ldexp(1.0, -24);
    for (double tolerancia : {0.3, 0.12, 0.03, 0.0075}) {
        const double peor = errorDeCuerda(tolerancia, tolerancia < 0.01 ? 4 : 6);
        EXPECT_LE(peor, tolerancia + redondeo);
        EXPECT_GT(peor, tolerancia / 4);
    }
}

// Sin grietas: solo quedan sueltas las de los lados de parche que no comparte nadie: la boca y la tapa (4 cada una),
// los dos extremos del asa y los del pitorro (2 cada uno).
TEST(Bezier, SinGrietas) {
    for (double tolerancia : {1.0, 0.3, 0.1, 0.037, 0.0075}) {
        const std::vector<Division> d = divisionesPara(tetera(), tolerancia);
        int esperadas = 0;
        for (std::size_t primero : {0u, 24u, 12u, 16u})
            for (std::size_t k = primero; k < primero + 4; ++k)
                esperadas += d[k].nu;
        EXPECT_EQ(aristasSueltas(teselaParches(tetera(), tolerancia).malla), esperadas) << tolerancia;
    }
}

// ---- El programa contra un oráculo que no comparte con él ni la evaluación ni la luz ----

// Una rejilla densa de cada parche.
Objeto teteraDensa() {
    std::vector<VerticeRef> vertices;
    std::vector<Triangulos::Indices> indices;
    const std::size_t N = 96;
    for (const Parche &q : tetera())
        for (std::size_t j = 0; j <= N; ++j)
            for (std::size_t i = 0; i <= N; ++i) {
                const double u = double(i) / N, v = double(j) / N;
                // la normal, un poco más adentro: en el borde una derivada puede anularse
                const glm::dvec3 n = evalua(q, std::clamp(u, 0.001, 0.999), std::clamp(v, 0.001, 0.999)).n;
                const std::size_t k = vertices.size();
                if (i < N && j < N)
                    indices.insert(indices.end(), {{k, k + 1, k + N + 2}, {k, k + N + 2, k + N + 1}});
                vertices.push_back({enPie(evalua(q, u, v).posicion), unitario(enPie(n))});
            }
    return malla(Mat4(), vertices, indices);
}

// El esmalte que promete tetera.frag: difuso con la luz de la izquierda y el cielo de arriba, brillo de Blinn y reflejo
// en los bordes.
Vec3 esmalte(const Impacto &i, const Vec3 &color) {
    const Vec3 L{-0.62, 0.45, 0.643}, V = haciaOjo(i), N = escalar(i.normal, V) < 0 ? -i.normal : i.normal;
    const double NL = std::max(escalar(N, L), 0.0), NH = std::max(escalar(N, unitario(L + V)), 0.0);
    return (0.36 + 0.68 * NL + 0.26 * N.y) * color + 0.7 * std::pow(NH, 70) * Vec3{1, 1, 1} +
           0.35 * std::pow(1 - std::max(escalar(N, V), 0.0), 4) * Vec3{0.75, 0.86, 1};
}

// Todo el sombreado y la silueta, píxel a píxel, con la tetera más fina; de frente y desde donde la lleva el ratón.
TEST(Tetera, SombreadoYSilueta) {
    const Escena escena = {teteraDensa()};
    const struct {
        std::string guion;
        Camara camara;
        int ancho, alto;
    } casos[] = {{"tecla + ×4", camaraTetera(), 480, 360},
                 {"tecla + ×4; " + arrastra({50, 60}, {90, 100}) + "; rueda -1 50 50",
                  camaraTetera(-40 * 1.8 / 120, 40 * 1.8 / 120, 9.5 * 1.1), 160, 120}};
    for (const auto &c : casos) {
        const auto comparada =
            compara(vistaDe("tetera", c.guion, c.ancho, c.alto).escena, escena, c.camara,
                    [](const Impacto &i) { return i ? esmalte(i, exacto(AZUL)) : exacto(FONDO_CLARO); });
        // en el filo del borde el brillo cambia 200 niveles de un píxel al siguiente: la mitad con la tolerancia
        comprueba(c.guion, comparada, {4, 500, 0.7});
        EXPECT_LE(comparada.rmse, 0.35);
        EXPECT_GT(comparada.interior, c.ancho * c.alto * 8 / 10);
    }
}

// Con las líneas puestas no se afina más allá de medio píxel, tampoco si se ha afinado antes de ponerlas.
TEST(Tetera, AfinadaYConLineas) {
    const auto medio = vistaDe("tetera", "tecla m; tecla +", 160, 120).escena;
    for (const char *guion : {"tecla m; tecla + ×9", "tecla + ×9; tecla m"})
        EXPECT_EQ(vistaDe("tetera", guion, 160, 120).escena.rgb, medio.rgb) << guion;
}

} // namespace
