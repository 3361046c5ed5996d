// Comprobaciones independientes de la tetera y de ch02_modelado/bezier.h: normales contra derivadas en
// cuádruple precisión, error de cuerda, grietas, fronteras de longitud cero y los datos de Newell.
#include "ch02_modelado/bezier.h"
#include "ejecuta.h"
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <set>

namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;
using Q3 = std::array<Quad, 3>;
const double U = std::ldexp(1.0, -53);

const std::vector<Parche> &tetera() {
    static const std::vector<Parche> parches = leeParches("assets/tetera.txt");
    return parches;
}

// ---- Referencia: de Casteljau en cuádruple precisión, sin los pesos de Bernstein del programa ----

Q3 entre(const Q3 &a, const Q3 &b, const Quad &t) {
    Q3 r;
    for (std::size_t k = 0; k < 3; ++k)
        r[k] = (1 - t) * a[k] + t * b[k];
    return r;
}

struct Curva {
    Q3 punto, tangente;
};

Curva casteljau(std::array<Q3, 4> p, const Quad &t) {
    for (std::size_t n = 3; n > 1; --n)
        for (std::size_t i = 0; i < n; ++i)
            p[i] = entre(p[i], p[i + 1], t);
    Curva c{entre(p[0], p[1], t), {}};
    for (std::size_t k = 0; k < 3; ++k)
        c.tangente[k] = 3 * (p[1][k] - p[0][k]);
    return c;
}

Q3 cruz(const Q3 &a, const Q3 &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Quad largo(const Q3 &a) {
    return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

struct Exacto {
    Q3 posicion, du, dv, n; // n sin normalizar
};

Exacto exacto(const Parche &q, const Quad &u, const Quad &v) {
    std::array<Q3, 4> columna, filaV, columnaU;
    for (std::size_t i = 0; i < 4; ++i) {
        std::array<Q3, 4> fila;
        for (std::size_t j = 0; j < 4; ++j)
            fila[j] = {Quad(q.p[i][j].x), Quad(q.p[i][j].y), Quad(q.p[i][j].z)};
        const Curva c = casteljau(fila, u);
        columna[i] = c.punto;
        columnaU[i] = c.tangente;
    }
    const Curva enV = casteljau(columna, v);
    Exacto e{enV.punto, casteljau(columnaU, v).punto, enV.tangente, {}};
    e.n = cruz(e.du, e.dv);
    return e;
}

double separacion(const glm::dvec3 &a, Q3 b) { // |a − b/|b||
    const Quad l = largo(b);
    Quad s = 0;
    for (int k = 0; k < 3; ++k) {
        const Quad d = Quad(a[k]) - b[static_cast<std::size_t>(k)] / l;
        s += d * d;
    }
    return static_cast<double>(sqrt(s));
}

// Cota del error de la normal en doble precisión. Cada derivada es una suma de 16 productos de pesos (menos
// de 8 redondeos), diferencias (1) y la propia suma (15): 24 redondeos, relativos a la suma de valores
// absolutos. El producto vectorial divide por el seno del ángulo entre las derivadas, y él y normalizar
// añaden 8.
double cotaNormal(const Parche &q, const Exacto &e, double u, double v) {
    double su = 0, sv = 0;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            auto b = [](int k, double t) {
                return std::array<double, 4>{std::pow(1 - t, 3), 3 * t * (1 - t) * (1 - t),
                                             3 * t * t * (1 - t), t * t * t}[static_cast<std::size_t>(k)];
            };
            auto d = [](int k, double t) { // cotas de los sumandos de las derivadas de los pesos
                return std::array<double, 4>{3 * (1 - t) * (1 - t), 3 * (1 - t) * (1 - t) + 6 * t * (1 - t),
                                             6 * t * (1 - t) + 3 * t * t,
                                             3 * t * t}[static_cast<std::size_t>(k)];
            };
            const double l = glm::length(q.p[i][j] - q.p[0][0]);
            su += d(j, u) * b(i, v) * l;
            sv += b(j, u) * d(i, v) * l;
        }
    const double lu = static_cast<double>(largo(e.du)), lv = static_cast<double>(largo(e.dv)),
                 ln = static_cast<double>(largo(e.n));
    return U * (24 * (su / lu + sv / lv) + 8) * (lu * lv / ln);
}

// ---- Referencia en doble precisión, para los muchos puntos del error de cuerda ----

glm::dvec3 puntoDe(const Parche &q, double u, double v) {
    glm::dvec3 columna[4];
    for (int i = 0; i < 4; ++i) {
        glm::dvec3 f[4] = {q.p[i][0], q.p[i][1], q.p[i][2], q.p[i][3]};
        for (int n = 3; n > 0; --n)
            for (int k = 0; k < n; ++k)
                f[k] = (1 - u) * f[k] + u * f[k + 1];
        columna[i] = f[0];
    }
    for (int n = 3; n > 0; --n)
        for (int k = 0; k < n; ++k)
            columna[k] = (1 - v) * columna[k] + v * columna[k + 1];
    return columna[0];
}

// Llama a `f(parche, (u,v) y posición de un punto del triángulo)` en una rejilla baricéntrica de cada
// triángulo.
template<typename F>
void recorre(const std::vector<Parche> &parches, double tolerancia, const Malla &malla, int paso, F f) {
    std::vector<std::size_t> parcheDe;
    const std::vector<Division> divisiones = divisionesPara(parches, tolerancia);
    for (std::size_t k = 0; k < parches.size(); ++k)
        parcheDe.insert(parcheDe.end(),
                        static_cast<std::size_t>((divisiones[k].nu + 1) * (divisiones[k].nv + 1)), k);
    ASSERT_EQ(parcheDe.size(), malla.vertices.size());
    for (std::size_t t = 0; t < malla.indices.size(); t += 3) {
        const Vertice *w[3];
        for (std::size_t i = 0; i < 3; ++i)
            w[i] = &malla.vertices[malla.indices[t + i]];
        for (int i = 0; i <= paso; ++i)
            for (int j = 0; i + j <= paso; ++j) {
                const double a = static_cast<double>(i) / paso, b = static_cast<double>(j) / paso,
                             c = 1 - a - b;
                f(parcheDe[malla.indices[t]],
                  a * glm::dvec2(w[0]->coordTextura) + b * glm::dvec2(w[1]->coordTextura) +
                      c * glm::dvec2(w[2]->coordTextura),
                  a * glm::dvec3(w[0]->posicion) + b * glm::dvec3(w[1]->posicion) +
                      c * glm::dvec3(w[2]->posicion));
            }
    }
}

using Punto = std::array<float, 3>;
Punto bits(const glm::vec3 &p) {
    return {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}; // −0 y +0 son el mismo sitio
}

Parche traspuesto(const Parche &q) {
    Parche t;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            t.p[i][j] = q.p[j][i];
    return t;
}

Parche aleatorio(std::mt19937 &azar) {
    std::uniform_real_distribution<double> d(-1, 1);
    Parche q;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            q.p[i][j] = glm::dvec3(j, i, 0) + 0.7 * glm::dvec3(d(azar), d(azar), d(azar));
    return q;
}

} // namespace

TEST(DatosTetera, SonLosDeNewell) {
    ASSERT_EQ(tetera().size(), 32u);
    std::set<std::array<double, 3>> puntos;
    for (const Parche &q : tetera())
        for (const auto &fila : q.p)
            for (const glm::dvec3 &p : fila)
                puntos.insert({p.x, p.y, p.z + 0.0});
    EXPECT_EQ(puntos.size(), 290u);
    double minimo[3] = {9, 9, 9}, maximo[3] = {-9, -9, -9};
    for (const auto &p : puntos) {
        EXPECT_TRUE(puntos.count({p[0], -p[1], p[2]})) << "no es simétrica en y";
        for (std::size_t k = 0; k < 3; ++k) {
            minimo[k] = std::min(minimo[k], p[k]);
            maximo[k] = std::max(maximo[k], p[k]);
        }
    }
    EXPECT_EQ(minimo[0], -3.0);  // el asa
    EXPECT_EQ(maximo[0], 3.525); // el pitorro
    EXPECT_EQ(maximo[1], 2.0);   // el cuerpo
    EXPECT_EQ(minimo[2], 0.0);   // el fondo
    EXPECT_EQ(maximo[2], 3.15);  // el pomo
    // Alturas y radios de lo que se cierra en redondo: boca, borde, cuerpo, pie; pomo, tapa.
    const double radios[][3] = {{0, 0, 1.4},  {0, 3, 1.5},  {4, 3, 2.0}, {8, 3, 1.5},
                                {20, 3, 0.2}, {24, 3, 1.3}, {28, 3, 1.5}};
    const double alturas[] = {2.4, 2.4, 0.9, 0.15, 2.7, 2.4, 0.15};
    for (std::size_t n = 0; n < 7; ++n)
        for (std::size_t cuarto = 0; cuarto < 4; ++cuarto) {
            const auto &fila =
                tetera()[static_cast<std::size_t>(radios[n][0]) + cuarto].p[static_cast<int>(radios[n][1])];
            EXPECT_NEAR(std::hypot(fila[0].x, fila[0].y), radios[n][2], 1e-15);
            EXPECT_EQ(fila[0].z, alturas[n]);
            // y acaba donde empieza el cuarto siguiente
            EXPECT_EQ(fila[3], tetera()[static_cast<std::size_t>(radios[n][0]) + (cuarto + 1) % 4]
                                   .p[static_cast<int>(radios[n][1])][0]);
        }
}

// La posición y la normal, en una rejilla con las fronteras, contra la referencia. La cota es la de
// cotaNormal.
TEST(Bezier, NormalesContraDerivadasEnCuadruple) {
    double peor = 0, peorRelativo = 0;
    int comparadas = 0;
    for (const Parche &q : tetera())
        for (int i = 0; i <= 7; ++i)
            for (int j = 0; j <= 7; ++j) {
                const double u = i / 7.0, v = j / 7.0;
                const Exacto e = exacto(q, u, v);
                const PuntoParche p = evaluaParche(q, u, v);
                for (std::size_t k = 0; k < 3; ++k) {
                    // |P| ≤ 3.6; 12 redondeos por curva y dos curvas
                    EXPECT_LE(abs(Quad(p.posicion[static_cast<int>(k)]) - e.posicion[k]), 24 * U * 3.6);
                    EXPECT_LE(abs(Quad(p.du[static_cast<int>(k)]) - e.du[k]), 24 * U * 60);
                    EXPECT_LE(abs(Quad(p.dv[static_cast<int>(k)]) - e.dv[k]), 24 * U * 60);
                }
                if (largo(e.du) < 1e-20 || largo(e.dv) < 1e-20)
                    continue; // fronteras de longitud cero: la prueba siguiente
                const double error = separacion(p.normal, e.n), cota = cotaNormal(q, e, u, v);
                EXPECT_LE(error, cota) << u << "," << v;
                peor = std::max(peor, error);
                peorRelativo = std::max(peorRelativo, error / cota);
                ++comparadas;
            }
    EXPECT_EQ(comparadas, 32 * 64 - 8 * 8);
    RecordProperty("peor_error_normal", std::to_string(peor * 1e16) + "e-16");
    std::printf("normales: %d comparadas, peor error %.2e, %.2f de su cota\n", comparadas, peor,
                peorRelativo);
}

// En el centro de la tapa y en el del fondo ∂u = 0: el límite de la normal, que la referencia toma a 1e-12
// del borde, es ±Z; el camino desde dentro lo cruza sin saltos ni NaN.
TEST(Bezier, FronterasDeLongitudCero) {
    for (const std::size_t primero : {20u, 28u})
        for (std::size_t k = primero; k < primero + 4; ++k)
            for (int i = 0; i <= 20; ++i) {
                const double u = i / 20.0, z = primero == 20 ? 1 : -1;
                const glm::dvec3 n = evaluaParche(tetera()[k], u, 0).normal;
                EXPECT_LE(separacion(n, exacto(tetera()[k], u, Quad(1e-12)).n), 1e-11);
                EXPECT_LE(glm::length(n - glm::dvec3(0, 0, z)), 1e-15);
                for (double v : {1e-300, 1e-30, 1e-16, 1e-9, 1e-8, 1e-7, 1e-6, 1e-4}) {
                    const glm::dvec3 m = evaluaParche(tetera()[k], u, v).normal;
                    // cerca del borde la normal se inclina en proporción a v (menos de 1 radián por unidad)
                    EXPECT_LE(separacion(m, exacto(tetera()[k], u, Quad(v)).n), 1e-7 + v * 1e-6) << v;
                }
            }
}

// El mismo parche con el lado de longitud cero en cada una de sus cuatro fronteras.
TEST(Bezier, LadoDeLongitudCeroEnCualquierFrontera) {
    std::mt19937 azar(1);
    for (int n = 0; n < 20; ++n) {
        Parche q = aleatorio(azar);
        for (int j = 1; j < 4; ++j)
            q.p[0][j] = q.p[0][0];
        for (int giro = 0; giro < 4; ++giro) {
            const bool enU = giro % 2 == 1, alFinal = giro >= 2;
            Parche r = q;
            if (alFinal)
                for (int j = 0; j < 4; ++j) {
                    std::swap(r.p[0][j], r.p[3][j]);
                    std::swap(r.p[1][j], r.p[2][j]);
                }
            if (enU)
                r = traspuesto(r);
            for (double s : {0.0, 0.3, 0.5, 1.0}) {
                const double t = alFinal ? 1 : 0, u = enU ? t : s, v = enU ? s : t;
                const Quad cerca = alFinal ? 1 - Quad(1e-12) : Quad(1e-12);
                const Exacto e = exacto(r, enU ? cerca : Quad(s), enU ? Quad(s) : cerca);
                const glm::dvec3 normal = evaluaParche(r, u, v).normal;
                // el límite se separa de la normal a 1e-12 lo que esta cambie en ese trecho
                EXPECT_LE(separacion(normal, e.n), 1e-9) << n << " giro " << giro << " s " << s;
            }
        }
    }
}

// Parches sin normal en todo o en parte: siempre unitaria y finita.
TEST(Bezier, NuncaNaN) {
    std::vector<Parche> parches;
    Parche punto, recta, dosLados, diminuto, lejano;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            punto.p[i][j] = {1, 2, 3};
            recta.p[i][j] = {i + j, 0, 0};
            dosLados.p[i][j] = i == 0 || j == 0 ? glm::dvec3(0) : glm::dvec3(i, j, i * j);
            diminuto.p[i][j] = glm::dvec3(i, j, i * j) * 1e-100;
            lejano.p[i][j] = glm::dvec3(i, j, i * j) + glm::dvec3(1e8, -1e8, 1e8);
        }
    for (const Parche &q : {punto, recta, dosLados, diminuto, lejano}) {
        for (int i = 0; i <= 8; ++i)
            for (int j = 0; j <= 8; ++j) {
                const PuntoParche p = evaluaParche(q, i / 8.0, j / 8.0);
                EXPECT_NEAR(glm::length(p.normal), 1, 1e-14);
                EXPECT_TRUE(std::isfinite(p.posicion.x + p.du.x + p.dv.x));
            }
        for (const Vertice &v : teselaParches({q}, 0.1).malla.vertices)
            EXPECT_NEAR(glm::length(v.normal), 1, 1e-6f);
    }
    EXPECT_TRUE(teselaParches({punto}, 0.1).malla.indices.empty());
    // Un parche de talla 1e-100 tiene la misma normal que el de talla 1 (el de 1e8, menos su origen).
    EXPECT_LE(glm::length(evaluaParche(diminuto, 0.3, 0.6).normal - evaluaParche(lejano, 0.3, 0.6).normal),
              1e-14);
    // A 1e8 del origen las derivadas no pierden nada: los puntos de control se restan antes, sin error.
    for (double u : {0.1, 0.5, 0.9})
        EXPECT_LE(separacion(evaluaParche(lejano, u, 0.3).normal, exacto(lejano, u, Quad(0.3)).n), 1e-14);
}

// La distancia de cada punto de un triángulo al punto de la superficie con los mismos (u, v) no pasa de la
// tolerancia (más el redondeo a float de posiciones y parámetros: 4·2⁻²⁴ y, con derivadas de hasta 12,
// 12·2⁻²⁴). Tampoco sobra demasiado: el peor parche llega a más de un cuarto de la tolerancia.
TEST(Bezier, ErrorDeCuerda) {
    for (double tolerancia : {0.3, 0.12, 0.03, 0.0075}) {
        double peor = 0;
        const Teselacion t = teselaParches(tetera(), tolerancia);
        recorre(tetera(), tolerancia, t.malla, tolerancia < 0.01 ? 4 : 6,
                [&](std::size_t k, const glm::dvec2 &uv, const glm::dvec3 &p) {
                    peor = std::max(peor, glm::length(p - puntoDe(tetera()[k], uv.x, uv.y)));
                });
        EXPECT_LE(peor, tolerancia + 16 * std::ldexp(1.0, -24));
        EXPECT_GT(peor, tolerancia / 4);
        std::printf("tolerancia %g: error de cuerda medido %.3g (%.2f), %zu triángulos\n", tolerancia, peor,
                    peor / tolerancia, t.malla.indices.size() / 3);
    }
    std::mt19937 azar(2);
    for (int n = 0; n < 50; ++n) {
        const std::vector<Parche> uno = {aleatorio(azar)};
        recorre(uno, 0.02, teselaParches(uno, 0.02).malla, 4,
                [&](std::size_t, const glm::dvec2 &uv, const glm::dvec3 &p) {
                    ASSERT_LE(glm::length(p - puntoDe(uno[0], uv.x, uv.y)), 0.02 + 16 * std::ldexp(1.0, -24));
                });
    }
}

// Con la cámara del programa, a 960×720, medio píxel: el error de cuerda proyectado en cada punto, que acota
// el de la silueta.
TEST(Bezier, ToleranciaDePartidaMenosDeMedioPixel) {
    const double azimut = 0.22, elevacion = 0.38, distancia = 9.9, angulo = 0.55, alto = 720;
    auto enPixel = [&](const glm::dvec3 &p) { // Z es la vertical de los datos
        const glm::dvec3 q(p.x - 0.26, p.z - 1.50, -p.y);
        const double ca = std::cos(azimut), sa = std::sin(azimut), ce = std::cos(elevacion),
                     se = std::sin(elevacion);
        const double fondo = distancia - (ce * sa * q.x + se * q.y + ce * ca * q.z),
                     escala = alto / 2 / std::tan(angulo / 2) / fondo;
        return glm::dvec2((ca * q.x - sa * q.z) * escala,
                          (-se * sa * q.x + ce * q.y - se * ca * q.z) * escala);
    };
    double peor = 0;
    recorre(tetera(), 0.0075, teselaParches(tetera(), 0.0075).malla, 6,
            [&](std::size_t k, const glm::dvec2 &uv, const glm::dvec3 &p) {
                peor = std::max(peor, glm::length(enPixel(p) - enPixel(puntoDe(tetera()[k], uv.x, uv.y))));
            });
    EXPECT_LT(peor, 0.5);
    std::printf("error de cuerda proyectado: %.3f píxeles\n", peor);
}

// Sin grietas: soldando los vértices que coinciden bit a bit, cada arista está en dos triángulos que la
// recorren en sentidos opuestos, salvo las de los lados de parche que no comparte nadie: la boca y la tapa (4
// cada una), los dos extremos del asa y los del pitorro (2 cada uno).
TEST(Bezier, SinGrietas) {
    for (double tolerancia : {1.0, 0.3, 0.1, 0.037, 0.0075}) {
        const Malla m = teselaParches(tetera(), tolerancia).malla;
        std::map<std::pair<Punto, Punto>, int> dirigidas;
        for (std::size_t t = 0; t < m.indices.size(); t += 3)
            for (std::size_t i = 0; i < 3; ++i)
                ++dirigidas[{bits(m.vertices[m.indices[t + i]].posicion),
                             bits(m.vertices[m.indices[t + (i + 1) % 3]].posicion)}];
        int borde = 0;
        for (const auto &[arista, n] : dirigidas) {
            EXPECT_EQ(n, 1);
            borde += dirigidas.count({arista.second, arista.first}) == 0;
        }
        const std::vector<Division> d = divisionesPara(tetera(), tolerancia);
        int esperado = 0;
        for (std::size_t k : {0u, 1u, 2u, 3u, 24u, 25u, 26u, 27u, 12u, 13u, 14u, 15u, 16u, 17u, 18u, 19u})
            esperado += d[k].nu;
        EXPECT_EQ(borde, esperado) << tolerancia;
    }
}

// Lo que hace que no haya grietas, en doble precisión: recorrer una curva al revés da el mismo punto, y una
// curva reducida a un punto da ese punto.
TEST(Bezier, CurvaAlRevesBitABit) {
    std::mt19937 azar(4);
    for (int n = 1; n <= 60; ++n) {
        const auto &p = aleatorio(azar).p[0];
        for (int i = 0; i <= n; ++i) {
            const double t = static_cast<double>(i) / n, c = static_cast<double>(n - i) / n;
            EXPECT_EQ(bezier::curva(p[0], p[1], p[2], p[3], bezier::pesos(t, c)),
                      bezier::curva(p[3], p[2], p[1], p[0], bezier::pesos(c, t)));
            EXPECT_EQ(bezier::curva(p[0], p[0], p[0], p[0], bezier::pesos(t, c)), p[0]);
        }
    }
}

// Dos parches cualesquiera con un lado común, recorrido en cada sentido y por u o por v: sus vértices
// coinciden.
TEST(Bezier, LadosComunesBitABit) {
    std::mt19937 azar(3);
    for (int n = 0; n < 100; ++n) {
        const Parche a = aleatorio(azar);
        Parche b = aleatorio(azar);
        for (int j = 0; j < 4; ++j)
            b.p[0][j] = a.p[3][n % 2 ? j : 3 - j];
        if (n % 4 >= 2)
            b = traspuesto(b);
        const double tolerancia = 0.3 / (1 + n);
        const Malla m = teselaParches({a, b}, tolerancia).malla;
        const std::vector<Division> d = divisionesPara({a, b}, tolerancia);
        const std::size_t enA = static_cast<std::size_t>((d[0].nu + 1) * (d[0].nv + 1));
        std::set<Punto> ladoA, deB;
        for (std::size_t i = 0; i < enA; ++i)
            if (m.vertices[i].coordTextura.t == 1)
                ladoA.insert(bits(m.vertices[i].posicion));
        for (std::size_t i = enA; i < m.vertices.size(); ++i)
            if ((n % 4 >= 2 ? m.vertices[i].coordTextura.s : m.vertices[i].coordTextura.t) == 0)
                deB.insert(bits(m.vertices[i].posicion));
        EXPECT_EQ(ladoA, deB) << n;
    }
}

// Los triángulos giran hacia donde apunta la normal, y la normal apunta hacia fuera: al dado por el parche
// explorado desde el eje de cada pieza. El cuerpo, el borde, la tapa y el fondo encierran un volumen
// positivo.
TEST(Bezier, GiroYNormalesHaciaFuera) {
    const Malla m = teselaParches(tetera(), 0.01).malla;
    for (std::size_t t = 0; t < m.indices.size(); t += 3) {
        const Vertice &a = m.vertices[m.indices[t]], &b = m.vertices[m.indices[t + 1]],
                      &c = m.vertices[m.indices[t + 2]];
        const glm::dvec3 n =
            glm::cross(glm::dvec3(b.posicion - a.posicion), glm::dvec3(c.posicion - a.posicion));
        EXPECT_GT(glm::dot(n, glm::dvec3(a.normal + b.normal + c.normal)), 0);
    }
    const glm::dvec3 arriba = evaluaParche(tetera()[24], 0.5, 0.3).normal,
                     lado = evaluaParche(tetera()[4], 0, 1).normal,
                     abajo = evaluaParche(tetera()[28], 0.5, 0.3).normal,
                     asa = evaluaParche(tetera()[12], 0.5, 0.5).normal,
                     pitorro = evaluaParche(tetera()[16], 0.5, 0.5).normal,
                     dentro = evaluaParche(tetera()[0], 0, 0).normal;
    EXPECT_GT(arriba.z, 0.5);
    EXPECT_GT(lado.x, 0.9);
    EXPECT_LT(abajo.z, -0.9);
    EXPECT_LT(asa.y, -0.9);
    EXPECT_LT(pitorro.y, -0.9);
    EXPECT_LT(dentro.x, 0); // la cara interior del borde mira al eje
    // Las normales en float son unitarias salvo el redondeo: tres componentes, media unidad cada una
    for (const Vertice &v : m.vertices)
        EXPECT_NEAR(glm::length(glm::dvec3(v.normal)), 1, 1.5 * std::ldexp(1.0, -24));
}

TEST(Bezier, LadosYDiagonales) {
    const std::vector<Parche> cuerpo = {tetera()[4]}, tapa = {tetera()[20]};
    const Division d = divisionesPara(cuerpo, 0.05)[0], e = divisionesPara(tapa, 0.05)[0];
    const Teselacion t = teselaParches(cuerpo, 0.05), s = teselaParches(tapa, 0.05);
    const auto n = [](int i) { return static_cast<std::size_t>(i); };
    EXPECT_EQ(t.malla.indices.size(), n(6 * d.nu * d.nv));
    EXPECT_EQ(t.lados.size(), n(2 * (d.nu * (d.nv + 1) + d.nv * (d.nu + 1))));
    EXPECT_EQ(t.diagonales.size(), n(2 * d.nu * d.nv));
    // en el pomo, el lado de longitud cero quita un triángulo y un lado de cada cuadrilátero de su fila
    EXPECT_EQ(s.malla.indices.size(), n(6 * e.nu * e.nv - 3 * e.nu));
    EXPECT_EQ(s.lados.size(), n(2 * (e.nu * e.nv + e.nv * (e.nu + 1))));
}

TEST(Bezier, FicheroMalEscrito) {
    EXPECT_EXIT(leeParches("assets/ejercicio_2_1.vf"), testing::ExitedWithCode(1),
                "ejercicio_2_1.vf:10: .*v o por p");
    EXPECT_EXIT(leeParches("assets/no_existe.txt"), testing::ExitedWithCode(1), "no encuentro");
}

// La silueta de partida no se mueve al afinar cuatro veces la tolerancia: los píxeles que cambian están todos
// en el contorno de la tetera fina.
TEST(Tetera, LaSiluetaNoSeMueve) {
    const Ejecucion basta = ejecuta("ch02_modelado/tetera", "", 960, 720),
                    fina = ejecuta("ch02_modelado/tetera", "tecla -; tecla -", 960, 720);
    ASSERT_EQ(basta.estado, 0) << basta.errores;
    ASSERT_EQ(fina.estado, 0) << fina.errores;
    EXPECT_EQ(basta.errores, "");
    auto dentro = [](const Imagen &i, int x, int y) {
        const Pixel p = pixel(i, x, y), fondo = pixel(i, 0, 0);
        return !(p.r == fondo.r && p.g == fondo.g && p.b == fondo.b);
    };
    int distintos = 0, cubiertos = 0;
    for (int y = 1; y < 719; ++y)
        for (int x = 1; x < 959; ++x) {
            cubiertos += dentro(fina.imagen, x, y);
            if (dentro(basta.imagen, x, y) == dentro(fina.imagen, x, y))
                continue;
            ++distintos;
            int vecinos = 0;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    vecinos += dentro(fina.imagen, x + dx, y + dy);
            EXPECT_TRUE(vecinos > 0 && vecinos < 9) << x << "," << y;
        }
    EXPECT_GT(cubiertos, 960 * 720 / 4); // llena la ventana
    std::printf("silueta: %d píxeles de %d cambian\n", distintos, cubiertos);
}

// Las líneas de los cuadriláteros son parte de las de los triángulos, y m y c se quitan con la misma tecla.
TEST(Tetera, MallaYCuadrilateros) {
    const std::string gruesa = "tecla +; tecla +; tecla +; tecla +";
    const Ejecucion nada = ejecuta("ch02_modelado/tetera", gruesa),
                    malla = ejecuta("ch02_modelado/tetera", gruesa + "; tecla m"),
                    cuadrilateros = ejecuta("ch02_modelado/tetera", gruesa + "; tecla m; tecla c"),
                    otraVez = ejecuta("ch02_modelado/tetera", gruesa + "; tecla m; tecla c; tecla c");
    EXPECT_EQ(nada.imagen.rgb, otraVez.imagen.rgb);
    int soloMalla = 0, soloCuadrilateros = 0;
    auto esLinea = [](const Pixel &p) {
        return std::abs(p.r - 36) <= 1 && std::abs(p.g - 51) <= 1 && std::abs(p.b - 97) <= 1;
    };
    for (int y = 0; y < 180; ++y)
        for (int x = 0; x < 240; ++x) {
            const bool a = esLinea(pixel(malla.imagen, x, y)), b = esLinea(pixel(cuadrilateros.imagen, x, y));
            soloMalla += a && !b;
            soloCuadrilateros += b && !a;
        }
    EXPECT_GT(soloMalla, 500);
    EXPECT_EQ(soloCuadrilateros, 0);
}
