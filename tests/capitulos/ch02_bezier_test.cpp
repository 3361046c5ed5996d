// Comprobaciones independientes de la tetera y de ch02_modelado/bezier.h: normales contra derivadas en
// cuádruple precisión, error de cuerda, grietas, fronteras de longitud cero y los datos de Newell.
#include "ch02_modelado/bezier.h"
#include "colores.h"
#include "ejecuta.h"
#include "oraculo/oraculo.h"
#include "rotulos.h"
#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <sstream>

namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;
using Q3 = std::array<Quad, 3>;
const double U = std::ldexp(1.0, -53);

// La cámara del programa y el lado de un píxel a 720 líneas a la distancia de su centro.
const double PIXEL = 2 * std::tan(0.275) * 9.5 / 720;
oraculo::Camara camaraTetera() {
    return oraculo::perspectiva(oraculo::orbita(0.22, 0.38, 9.5, {0.43, 1.42, 0}), 0.55, 0.5, 50);
}

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

using Bits = std::array<float, 3>;
Bits bits(const glm::vec3 &p) {
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
    const oraculo::Camara camara = camaraTetera();
    const auto enPixel = [&](const glm::dvec3 &p) { // Z es la vertical de los datos
        const oraculo::Vec3 q = oraculo::proyecta(camara, 960, 720, {p.x, p.z, -p.y});
        return glm::dvec2(q.x, q.y);
    };
    double peor = 0;
    recorre(tetera(), PIXEL, teselaParches(tetera(), PIXEL).malla, 6,
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
        std::map<std::pair<Bits, Bits>, int> dirigidas;
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
            EXPECT_EQ(parche::curva(p[0], p[1], p[2], p[3], parche::pesos(t, c)),
                      parche::curva(p[3], p[2], p[1], p[0], parche::pesos(c, t)));
            EXPECT_EQ(parche::curva(p[0], p[0], p[0], p[0], parche::pesos(t, c)), p[0]);
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
        std::set<Bits> ladoA, deB;
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

// La cuadrícula de cada parche: (u, v) por sus divisiones. Los triángulos de un cuadrilátero comparten la diagonal en que columna
// menos fila es entera.
TEST(Bezier, Cuadricula) {
    const std::vector<Parche> cuerpo = {tetera()[4]}, tapa = {tetera()[20]};
    const Division d = divisionesPara(cuerpo, 0.05)[0], e = divisionesPara(tapa, 0.05)[0];
    const Teselacion t = teselaParches(cuerpo, 0.05), s = teselaParches(tapa, 0.05);
    const auto n = [](int i) { return static_cast<std::size_t>(i); };
    EXPECT_EQ(t.malla.indices.size(), n(6 * d.nu * d.nv));
    // en el pomo, el lado de longitud cero quita un triángulo de cada cuadrilátero de su fila
    EXPECT_EQ(s.malla.indices.size(), n(6 * e.nu * e.nv - 3 * e.nu));
    ASSERT_EQ(t.cuadricula.size(), t.malla.vertices.size());
    for (std::size_t i = 0; i < t.cuadricula.size(); ++i) {
        EXPECT_NEAR(t.cuadricula[i].x, t.malla.vertices[i].coordTextura.x * static_cast<float>(d.nu), 1e-5);
        EXPECT_NEAR(t.cuadricula[i].y, t.malla.vertices[i].coordTextura.y * static_cast<float>(d.nv), 1e-5);
    }
    for (std::size_t i = 0; i < t.malla.indices.size(); i += 3) {
        int horizontales = 0, verticales = 0, diagonales = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec2 paso =
                t.cuadricula[t.malla.indices[i + (k + 1) % 3]] - t.cuadricula[t.malla.indices[i + k]];
            horizontales += paso.y == 0 && std::fabs(paso.x) == 1;
            verticales += paso.x == 0 && std::fabs(paso.y) == 1;
            diagonales += paso.x == paso.y && std::fabs(paso.x) == 1;
        }
        ASSERT_TRUE(horizontales == 1 && verticales == 1 && diagonales == 1);
    }
}

TEST(Bezier, FicheroMalEscrito) {
    EXPECT_EXIT(leeParches("assets/ejercicio_2_1.vf"), testing::ExitedWithCode(1),
                "ejercicio_2_1.vf:10: .*v o por p");
    EXPECT_EXIT(leeParches("assets/no_existe.txt"), testing::ExitedWithCode(1), "no encuentro");
}

// ---- El programa contra un oráculo que no comparte con él ni la lectura, ni la evaluación, ni la luz ----

// assets/tetera.txt, leído aquí, en una rejilla densa de cada parche por de Casteljau y ya con la vertical en Y. s y t dicen el
// parche.
oraculo::Objeto teteraDensa() {
    std::ifstream fichero(recurso("assets/tetera.txt"));
    std::vector<glm::dvec3> puntos;
    std::vector<oraculo::VerticeRef> vertices;
    std::vector<oraculo::Triangulos::Indices> indices;
    const std::size_t N = 96;
    for (std::string linea; std::getline(fichero, linea);) {
        std::istringstream palabras(linea);
        std::string tipo;
        palabras >> tipo;
        if (tipo == "v") {
            glm::dvec3 p;
            palabras >> p.x >> p.y >> p.z;
            puntos.push_back(p);
        } else if (tipo == "p") {
            Parche q;
            for (auto &fila : q.p)
                for (glm::dvec3 &p : fila) {
                    std::size_t i = 0;
                    palabras >> i;
                    p = puntos.at(i - 1);
                }
            const std::size_t base = vertices.size();
            for (std::size_t j = 0; j <= N; ++j)
                for (std::size_t i = 0; i <= N; ++i) {
                    const double u = static_cast<double>(i) / N, v = static_cast<double>(j) / N, h = 1e-5;
                    const glm::dvec3 p = puntoDe(q, u, v);
                    // la normal, por diferencias finitas un poco más adentro: en el borde una derivada puede anularse
                    const double a = std::clamp(u, 0.001, 0.999), b = std::clamp(v, 0.001, 0.999);
                    const glm::dvec3 n =
                        glm::normalize(glm::cross(puntoDe(q, a + h, b) - puntoDe(q, a - h, b),
                                                  puntoDe(q, a, b + h) - puntoDe(q, a, b - h)));
                    vertices.push_back({{p.x, p.z, -p.y}, {n.x, n.z, -n.y}});
                    if (i < N && j < N) {
                        const std::size_t k = base + j * (N + 1) + i;
                        indices.push_back({k, k + 1, k + N + 2});
                        indices.push_back({k, k + N + 2, k + N + 1});
                    }
                }
        }
    }
    EXPECT_EQ(vertices.size(), 32 * (N + 1) * (N + 1));
    return oraculo::malla(oraculo::escala({1, 1, 1}), vertices, indices);
}

// Todo el sombreado y la silueta, píxel a píxel, con la tetera más fina. El esmalte es el que promete tetera.frag: difuso con la
// luz de la izquierda y el cielo de arriba, brillo de Blinn y reflejo en los bordes.
TEST(Tetera, SombreadoYSilueta) {
    using oraculo::escalar;
    const oraculo::Vec3 azul{0.16, 0.38, 0.80}, fondo{0.95, 0.96, 0.98}, L{-0.62, 0.45, 0.643},
        cielo{0.75, 0.86, 1};
    const oraculo::Escena escena = {teteraDensa()};
    const oraculo::Camara camara = camaraTetera();
    const auto esmalte = [&](const oraculo::Impacto &i) {
        if (!i)
            return fondo;
        const oraculo::Vec3 V = oraculo::haciaOjo(i), N = escalar(i.normal, V) < 0 ? -i.normal : i.normal;
        const double NL = std::max(escalar(N, L), 0.0),
                     NH = std::max(escalar(N, oraculo::unitario(L + V)), 0.0);
        return (0.36 + 0.68 * NL + 0.26 * N.y) * azul + 0.7 * std::pow(NH, 70) * oraculo::Vec3{1, 1, 1} +
               0.35 * std::pow(1 - std::max(escalar(N, V), 0.0), 4) * cielo;
    };
    Imagen imagen = ejecuta("ch02_modelado/tetera", "tecla +; tecla +; tecla +; tecla +", 480, 360).imagen;
    ASSERT_FALSE(imagen.rgb.empty());
    for (int y = 0; y < 51; ++y) // el rótulo, que está debajo de la tetera
        for (int x = 0; x < 480; ++x)
            for (int k = 0; k < 3; ++k)
                imagen.rgb[static_cast<std::size_t>(3 * (480 * y + x) + k)] =
                    static_cast<unsigned char>(std::lround(255 * fondo[k]));
    const oraculo::Comparacion c = oraculo::compara(imagen, escena, camara, esmalte);
    std::cout << c << "\n";
    EXPECT_GT(c.interior, 480 * 360 * 8 / 10);
    // en el filo del borde el brillo cambia 200 niveles de un píxel al siguiente: el error se parte por dos con la tolerancia
    EXPECT_LE(c.maximo, 4) << c;
    EXPECT_LE(c.rmse, 0.35) << c;
    EXPECT_LE(c.desvio, 0.7) << c;
    // llena la ventana a lo ancho
    int primera = 480, ultima = 0;
    for (int y = 51; y < 360; ++y)
        for (int x = 0; x < 480; ++x)
            if (const Pixel p = pixel(imagen, x, y); p.r != 242 || p.g != 245 || p.b != 250) {
                primera = std::min(primera, x);
                ultima = std::max(ultima, x);
            }
    EXPECT_GT(ultima - primera, 420);
}

// + divide entre dos el error y - lo dobla; el rótulo dice el error y los triángulos que hay.
TEST(Tetera, MasFinaYMasBasta) {
    const struct {
        const char *guion;
        double error;
        std::u32string linea;
    } casos[] = {{"", 1, U"hasta 1 px de error"},
                 {"tecla +", 0.5, U"hasta 0.5 px de error"},
                 {"tecla -", 2, U"hasta 2 px de error"},
                 {"tecla -; tecla -; tecla +", 2, U"hasta 2 px de error"},
                 {"tecla -; tecla -; tecla -; tecla -", 16, U"hasta 16 px de error"}};
    for (const auto &caso : casos) {
        const Imagen imagen = ejecuta("ch02_modelado/tetera", caso.guion, 960, 720).imagen;
        const std::size_t n = teselaParches(tetera(), caso.error * PIXEL).malla.indices.size() / 3;
        const std::string numero = std::to_string(n) + " ";
        EXPECT_EQ(buscaRotulo(imagen, caso.linea, OSCURO, 4).size(), 1u) << caso.guion;
        EXPECT_EQ(buscaRotulo(imagen, enLetras(numero) + U"triángulos", OSCURO, 4).size(), 1u)
            << caso.guion << " " << n;
    }
}

// En cada cuadrilátero grande que se ve de frente: sobre sus lados hay línea en las dos mallas; sobre la diagonal, solo en la de
// triángulos; en el centro de cada triángulo, en ninguna.
TEST(Tetera, MallaYCuadrilateros) {
    const std::string basta = "tecla -; tecla -; tecla -; tecla -";
    const Imagen malla = ejecuta("ch02_modelado/tetera", basta + "; tecla m", 960, 720).imagen,
                 cuadrilateros =
                     ejecuta("ch02_modelado/tetera", basta + "; tecla m; tecla c", 960, 720).imagen;
    EXPECT_EQ(ejecuta("ch02_modelado/tetera", basta).imagen.rgb,
              ejecuta("ch02_modelado/tetera", basta + "; tecla c; tecla m; tecla m").imagen.rgb);
    const Teselacion t = teselaParches(tetera(), 16 * PIXEL);
    const std::vector<Division> divisiones = divisionesPara(tetera(), 16 * PIXEL);
    const oraculo::Camara camara = camaraTetera();
    const auto punto = [&](std::size_t i) {
        const glm::vec3 &p = t.malla.vertices[i].posicion;
        return oraculo::Vec3{p.x, p.z, -p.y};
    };
    std::vector<oraculo::VerticeRef> vertices;
    std::vector<oraculo::Triangulos::Indices> indices;
    for (std::size_t i = 0; i < t.malla.vertices.size(); ++i)
        vertices.push_back({punto(i), {0, 0, 1}});
    for (std::size_t i = 0; i < t.malla.indices.size(); i += 3)
        indices.push_back({t.malla.indices[i], t.malla.indices[i + 1], t.malla.indices[i + 2]});
    const oraculo::Escena escena = {oraculo::malla(oraculo::escala({1, 1, 1}), vertices, indices)};

    int lados = 0, diagonales = 0, centros = 0;
    const auto mira = [&](const oraculo::Vec3 &p, const char *que, bool enMalla, bool enCuadrilateros,
                          int &cuenta) {
        const oraculo::Vec3 q = oraculo::proyecta(camara, 960, 720, p);
        const int x = static_cast<int>(q.x), y = static_cast<int>(q.y);
        const auto i = oraculo::primerImpacto(escena, oraculo::rayo(camara, 960, 720, q.x, q.y));
        if (!i || oraculo::longitud(i.punto - p) > 1e-3)
            return;
        const auto hayLinea = [&](const Imagen &imagen, int radio) {
            bool hay = false;
            for (int dy = -radio; dy <= radio; ++dy)
                for (int dx = -radio; dx <= radio; ++dx) {
                    const Pixel c = pixel(imagen, x + dx, y + dy);
                    hay = hay || std::abs(c.r - 41) + std::abs(c.g - 43) + std::abs(c.b - 51) < 24;
                }
            return hay;
        };
        // que la haya, en el píxel o en uno vecino; que no, en el píxel
        EXPECT_EQ(hayLinea(malla, enMalla), enMalla) << que << " en " << x << "," << y;
        EXPECT_EQ(hayLinea(cuadrilateros, enCuadrilateros), enCuadrilateros)
            << que << " en " << x << "," << y;
        ++cuenta;
    };
    std::size_t base = 0;
    for (const Division &d : divisiones) {
        const std::size_t ancho = static_cast<std::size_t>(d.nu + 1);
        for (std::size_t j = 0; j + 1 <= static_cast<std::size_t>(d.nv); ++j)
            for (std::size_t i = 0; i + 1 < ancho; ++i) {
                const std::size_t k = base + j * ancho + i;
                const oraculo::Vec3 a = punto(k), b = punto(k + 1), e = punto(k + ancho),
                                    c = punto(k + ancho + 1);
                const oraculo::Vec3 n = oraculo::unitario(oraculo::vectorial(c - a, e - b));
                const oraculo::Vec3 V = oraculo::unitario(camara.ojo - a);
                // de frente, grande y no en la sombra, donde el esmalte es tan oscuro como la línea
                if (oraculo::escalar(n, V) < 0.6 || oraculo::longitud(c - a) < 0.35 ||
                    oraculo::longitud(e - b) < 0.35 || oraculo::escalar(n, {-0.62, 0.45, 0.643}) < 0.3 ||
                    n.y < -0.2)
                    continue;
                mira(0.5 * (a + b), "lado", true, true, lados);
                mira(0.5 * (a + e), "lado", true, true, lados);
                mira(0.5 * (a + c), "diagonal", true, false, diagonales);
                mira(0.25 * a + 0.5 * b + 0.25 * c, "centro", false, false, centros);
                mira(0.25 * a + 0.5 * e + 0.25 * c, "centro", false, false, centros);
            }
        base += ancho * static_cast<std::size_t>(d.nv + 1);
    }
    EXPECT_GT(diagonales, 20);
    std::printf("%d lados, %d diagonales y %d centros\n", lados, diagonales, centros);
}
