// Comprobaciones independientes de la tetera y de ch02_modelado/bezier.h: normales contra derivadas en
// cuádruple precisión, error de cuerda, grietas, fronteras de longitud cero y los datos de Newell.
#include "azar.h"
#include "ch02_modelado/bezier.h"
#include "colores.h"
#include "contra_oraculo.h"
#include "guiones.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <sstream>

namespace {

__extension__ typedef __float128 Quad;
template<class T>
using V3 = glm::vec<3, T>;
const double U = std::ldexp(1.0, -53);

// La cámara del programa y el lado de un píxel a 720 líneas a la distancia de su centro.
const double PIXEL = 2 * std::tan(0.275) * 9.5 / 720;
oraculo::Camara camaraTetera(double gira = 0, double sube = 0, double distancia = 9.5) {
    return oraculo::perspectiva(oraculo::orbita(0.22 + gira, 0.38 + sube, distancia, {0.43, 1.42, 0}), 0.55,
                                0.5, 50);
}
/// En los datos la vertical es Z, y en la cámara Y.
oraculo::Vec3 enPie(const glm::dvec3 &p) {
    return {p.x, p.z, -p.y};
}

/// Los parches de assets/tetera.txt, leídos aquí.
const std::vector<Parche> &tetera() {
    static std::vector<Parche> parches;
    std::ifstream fichero(recurso("assets/tetera.txt"));
    std::vector<glm::dvec3> puntos;
    for (std::string tipo; parches.size() < 32 && fichero >> tipo;)
        if (tipo == "v") {
            glm::dvec3 p;
            fichero >> p.x >> p.y >> p.z;
            puntos.push_back(p);
        } else if (tipo == "p") {
            parches.emplace_back();
            for (auto &fila : parches.back().p)
                for (glm::dvec3 &p : fila) {
                    std::size_t i;
                    fichero >> i;
                    p = puntos.at(i - 1);
                }
        } else {
            std::getline(fichero, tipo);
        }
    return parches;
}

// ---- Referencia: de Casteljau, sin los pesos de Bernstein del programa; en cuádruple precisión o en doble ----

template<class T>
std::pair<V3<T>, V3<T>> casteljau(const V3<T> &a, const V3<T> &b, const V3<T> &c, const V3<T> &d, T t) {
    const auto mezcla = [t](const V3<T> &p, const V3<T> &q) { return (1 - t) * p + t * q; };
    const V3<T> bc = mezcla(b, c), abc = mezcla(mezcla(a, b), bc), bcd = mezcla(bc, mezcla(c, d));
    return {mezcla(abc, bcd), T(3) * (bcd - abc)};
}

template<class T>
struct Exacto {
    V3<T> posicion, du, dv, n; // n sin normalizar
};

template<class T>
Exacto<T> evalua(const Parche &q, T u, T v) {
    std::pair<V3<T>, V3<T>> fila[4]; // punto y tangente
    for (int i = 0; i < 4; ++i)
        fila[i] = casteljau(V3<T>(q.p[i][0]), V3<T>(q.p[i][1]), V3<T>(q.p[i][2]), V3<T>(q.p[i][3]), u);
    const auto enV = casteljau(fila[0].first, fila[1].first, fila[2].first, fila[3].first, v);
    const V3<T> a = casteljau(fila[0].second, fila[1].second, fila[2].second, fila[3].second, v).first,
                b = enV.second;
    return {enV.first, a, b, {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}};
}

glm::dvec3 puntoDe(const Parche &q, double u, double v) {
    return evalua(q, u, v).posicion;
}

Quad largo(const V3<Quad> &a) {
    const Quad cuadrado = a.x * a.x + a.y * a.y + a.z * a.z;
    const Quad raiz = std::sqrt(static_cast<long double>(cuadrado));
    return raiz > 0 ? (raiz + cuadrado / raiz) / 2 : 0; // un paso de Newton dobla las cifras
}

double separacion(const glm::dvec3 &a, const V3<Quad> &b) { // |a − b/|b||
    return double(largo(V3<Quad>(a) - b / largo(b)));
}

// Cota del error de la normal en doble precisión. Cada derivada es una suma de 16 productos de pesos (menos
// de 8 redondeos), diferencias (1) y la propia suma (15): 24 redondeos, relativos a la suma de valores
// absolutos. El producto vectorial divide por el seno del ángulo entre las derivadas, y él y normalizar
// añaden 8.
double cotaNormal(const Parche &q, const Exacto<Quad> &e, double u, double v) {
    const auto pesos = [](double t) {
        return std::array<double, 4>{std::pow(1 - t, 3), 3 * t * (1 - t) * (1 - t), 3 * t * t * (1 - t),
                                     t * t * t};
    };
    const auto derivados = [](double t) { // cotas de los sumandos de las derivadas de los pesos
        const double a = 3 * (1 - t) * (1 - t), b = 6 * t * (1 - t), c = 3 * t * t;
        return std::array<double, 4>{a, a + b, b + c, c};
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

// Llama a `f(parche, (u,v) y posición de un punto del triángulo)` en una rejilla baricéntrica de cada
// triángulo.
template<typename F>
void recorre(const std::vector<Parche> &parches, double tolerancia, const Malla &malla, int paso, F f) {
    std::vector<std::size_t> parcheDe;
    const std::vector<Division> divisiones = divisionesPara(parches, tolerancia);
    for (std::size_t k = 0; k < parches.size(); ++k)
        parcheDe.insert(parcheDe.end(), std::size_t((divisiones[k].nu + 1) * (divisiones[k].nv + 1)), k);
    ASSERT_EQ(parcheDe.size(), malla.vertices.size());
    for (std::size_t t = 0; t < malla.indices.size(); t += 3)
        for (int i = 0; i <= paso; ++i)
            for (int j = 0; i + j <= paso; ++j) {
                const double pesos[] = {double(i) / paso, double(j) / paso, double(paso - i - j) / paso};
                glm::dvec2 uv(0);
                glm::dvec3 p(0);
                for (std::size_t k = 0; k < 3; ++k) {
                    const Vertice &v = malla.vertices[malla.indices[t + k]];
                    uv += pesos[k] * glm::dvec2(v.coordTextura);
                    p += pesos[k] * glm::dvec3(v.posicion);
                }
                f(parches[parcheDe[malla.indices[t]]], uv, p);
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

Parche aleatorio(Azar &azar) {
    Parche q;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            q.p[i][j] = glm::dvec3(j, i, 0) + glm::dvec3(azar.vector(0.7f));
    return q;
}

} // namespace

TEST(DatosTetera, SonLosDeNewell) {
    const std::vector<Parche> leidos = leeParches("assets/tetera.txt");
    ASSERT_EQ(leidos.size(), 32u);
    std::set<std::array<double, 3>> puntos;
    for (std::size_t k = 0; k < 32; ++k)
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j) {
                const glm::dvec3 &p = leidos[k].p[i][j];
                EXPECT_EQ(p, tetera()[k].p[i][j]);
                puntos.insert({p.x, p.y, p.z + 0.0});
            }
    EXPECT_EQ(puntos.size(), 290u);
    glm::dvec3 minimo(9), maximo(-9);
    for (const auto &p : puntos) {
        EXPECT_TRUE(puntos.count({p[0], -p[1], p[2]})) << "no es simétrica en y";
        minimo = glm::min(minimo, glm::dvec3(p[0], p[1], p[2]));
        maximo = glm::max(maximo, glm::dvec3(p[0], p[1], p[2]));
    }
    EXPECT_EQ(minimo, glm::dvec3(-3, -2, 0));      // el asa, el cuerpo y el fondo
    EXPECT_EQ(maximo, glm::dvec3(3.525, 2, 3.15)); // el pitorro, el cuerpo y el pomo
    // Alturas y radios de lo que se cierra en redondo, y que cada cuarto acaba donde empieza el siguiente.
    const struct {
        std::size_t parche;
        int fila;
        double radio, altura;
    } redondos[] = {{0, 0, 1.4, 2.4},  {0, 3, 1.5, 2.4},  {4, 3, 2.0, 0.9},
                    {8, 3, 1.5, 0.15},                                         // boca, borde, cuerpo, pie
                    {20, 3, 0.2, 2.7}, {24, 3, 1.3, 2.4}, {28, 3, 1.5, 0.15}}; // pomo, tapa, fondo
    for (const auto &r : redondos)
        for (std::size_t cuarto = 0; cuarto < 4; ++cuarto) {
            const auto &fila = tetera()[r.parche + cuarto].p[r.fila];
            EXPECT_NEAR(std::hypot(fila[0].x, fila[0].y), r.radio, 1e-15);
            EXPECT_EQ(fila[0].z, r.altura);
            EXPECT_EQ(fila[3], tetera()[r.parche + (cuarto + 1) % 4].p[r.fila][0]);
        }
}

// La posición y la normal, en una rejilla con las fronteras, contra la referencia. La cota es la de
// cotaNormal.
TEST(Bezier, NormalesContraDerivadasEnCuadruple) {
    double peor = 0;
    int comparadas = 0;
    for (const Parche &q : tetera())
        for (int i = 0; i <= 7; ++i)
            for (int j = 0; j <= 7; ++j) {
                const double u = i / 7.0, v = j / 7.0;
                const Exacto<Quad> e = evalua<Quad>(q, u, v);
                const PuntoParche p = evaluaParche(q, u, v);
                for (int k = 0; k < 3; ++k) {
                    // |P| ≤ 3.6; 12 redondeos por curva y dos curvas
                    EXPECT_LE(std::fabs(double(p.posicion[k] - e.posicion[k])), 24 * U * 3.6);
                    EXPECT_LE(std::fabs(double(p.du[k] - e.du[k])), 24 * U * 60);
                    EXPECT_LE(std::fabs(double(p.dv[k] - e.dv[k])), 24 * U * 60);
                }
                if (largo(e.du) < 1e-20 || largo(e.dv) < 1e-20)
                    continue; // fronteras de longitud cero: la prueba siguiente
                const double error = separacion(p.normal, e.n);
                EXPECT_LE(error, cotaNormal(q, e, u, v)) << u << "," << v;
                peor = std::max(peor, error);
                ++comparadas;
            }
    EXPECT_EQ(comparadas, 32 * 64 - 8 * 8);
    RecordProperty("peor_error_normal", std::to_string(peor * 1e16) + "e-16");
}

// En el centro de la tapa y en el del fondo ∂u = 0: el límite de la normal, que la referencia toma a 1e-12
// del borde, es ±Z; el camino desde dentro lo cruza sin saltos ni NaN.
TEST(Bezier, FronterasDeLongitudCero) {
    for (const std::size_t primero : {20u, 28u})
        for (std::size_t k = primero; k < primero + 4; ++k)
            for (int i = 0; i <= 20; ++i) {
                const double u = i / 20.0, z = primero == 20 ? 1 : -1;
                const glm::dvec3 n = evaluaParche(tetera()[k], u, 0).normal;
                EXPECT_LE(separacion(n, evalua<Quad>(tetera()[k], u, 1e-12).n), 1e-11);
                EXPECT_LE(glm::length(n - glm::dvec3(0, 0, z)), 1e-15);
                for (double v : {1e-300, 1e-30, 1e-16, 1e-9, 1e-8, 1e-7, 1e-6, 1e-4}) {
                    const glm::dvec3 m = evaluaParche(tetera()[k], u, v).normal;
                    // cerca del borde la normal se inclina en proporción a v (menos de 1 radián por unidad)
                    EXPECT_LE(separacion(m, evalua<Quad>(tetera()[k], u, v).n), 1e-7 + v * 1e-6) << v;
                }
            }
}

// El mismo parche con el lado de longitud cero en cada una de sus cuatro fronteras.
TEST(Bezier, LadoDeLongitudCeroEnCualquierFrontera) {
    Azar azar(1);
    for (int vez = 0; vez < 20; ++vez) {
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
                const V3<Quad> n = evalua(r, enU ? cerca : Quad(s), enU ? Quad(s) : cerca).n;
                // el límite se separa de la normal a 1e-12 lo que esta cambie en ese trecho
                EXPECT_LE(separacion(evaluaParche(r, u, v).normal, n), 1e-9)
                    << vez << " giro " << giro << " s " << s;
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
        EXPECT_LE(separacion(evaluaParche(lejano, u, 0.3).normal, evalua<Quad>(lejano, u, 0.3).n), 1e-14);
}

// La distancia de cada punto de un triángulo al punto de la superficie con los mismos (u, v) no pasa de la
// tolerancia (más el redondeo a float de posiciones y parámetros: 4·2⁻²⁴ y, con derivadas de hasta 12,
// 12·2⁻²⁴). Tampoco sobra demasiado: el peor parche llega a más de un cuarto de la tolerancia.
TEST(Bezier, ErrorDeCuerda) {
    for (double tolerancia : {0.3, 0.12, 0.03, 0.0075}) {
        double peor = 0;
        const Teselacion t = teselaParches(tetera(), tolerancia);
        recorre(tetera(), tolerancia, t.malla, tolerancia < 0.01 ? 4 : 6,
                [&](const Parche &q, const glm::dvec2 &uv, const glm::dvec3 &p) {
                    peor = std::max(peor, glm::length(p - puntoDe(q, uv.x, uv.y)));
                });
        EXPECT_LE(peor, tolerancia + 16 * std::ldexp(1.0, -24));
        EXPECT_GT(peor, tolerancia / 4);
    }
    Azar azar(2);
    for (int n = 0; n < 50; ++n) {
        const std::vector<Parche> uno = {aleatorio(azar)};
        recorre(uno, 0.02, teselaParches(uno, 0.02).malla, 4,
                [&](const Parche &q, const glm::dvec2 &uv, const glm::dvec3 &p) {
                    ASSERT_LE(glm::length(p - puntoDe(q, uv.x, uv.y)), 0.02 + 16 * std::ldexp(1.0, -24));
                });
    }
}

// Con la cámara del programa, a 960×720, medio píxel: el error de cuerda proyectado en cada punto, que acota
// el de la silueta.
TEST(Bezier, ToleranciaDePartidaMenosDeMedioPixel) {
    const auto enPixel = [](const glm::dvec3 &p) { return enPixeles(camaraTetera(), enPie(p), 960, 720); };
    double peor = 0;
    recorre(tetera(), PIXEL, teselaParches(tetera(), PIXEL).malla, 6,
            [&](const Parche &q, const glm::dvec2 &uv, const glm::dvec3 &p) {
                peor = std::max(peor, glm::length(enPixel(p) - enPixel(puntoDe(q, uv.x, uv.y))));
            });
    EXPECT_LT(peor, 0.5);
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
    Azar azar(4);
    for (int n = 1; n <= 60; ++n) {
        const auto &p = aleatorio(azar).p[0];
        for (int i = 0; i <= n; ++i) {
            const double t = double(i) / n, c = double(n - i) / n;
            EXPECT_EQ(parche::curva(p[0], p[1], p[2], p[3], parche::pesos(t, c)),
                      parche::curva(p[3], p[2], p[1], p[0], parche::pesos(c, t)));
            EXPECT_EQ(parche::curva(p[0], p[0], p[0], p[0], parche::pesos(t, c)), p[0]);
        }
    }
}

// Dos parches cualesquiera con un lado común, recorrido en cada sentido y por u o por v: sus vértices
// coinciden.
TEST(Bezier, LadosComunesBitABit) {
    Azar azar(3);
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
        const std::size_t enA = std::size_t((d[0].nu + 1) * (d[0].nv + 1));
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
    const auto normal = [](std::size_t k, double u, double v) {
        return evaluaParche(tetera()[k], u, v).normal;
    };
    EXPECT_GT(normal(24, 0.5, 0.3).z, 0.5);  // la tapa
    EXPECT_GT(normal(4, 0, 1).x, 0.9);       // el cuerpo
    EXPECT_LT(normal(28, 0.5, 0.3).z, -0.9); // el fondo
    EXPECT_LT(normal(12, 0.5, 0.5).y, -0.9); // el asa
    EXPECT_LT(normal(16, 0.5, 0.5).y, -0.9); // el pitorro
    EXPECT_LT(normal(0, 0, 0).x, 0);         // la cara interior del borde mira al eje
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
    EXPECT_EQ(t.malla.indices.size(), std::size_t(6 * d.nu * d.nv));
    // en el pomo, el lado de longitud cero quita un triángulo de cada cuadrilátero de su fila
    EXPECT_EQ(s.malla.indices.size(), std::size_t(6 * e.nu * e.nv - 3 * e.nu));
    ASSERT_EQ(t.cuadricula.size(), t.malla.vertices.size());
    for (std::size_t i = 0; i < t.cuadricula.size(); ++i) {
        EXPECT_NEAR(t.cuadricula[i].x, t.malla.vertices[i].coordTextura.x * float(d.nu), 1e-5);
        EXPECT_NEAR(t.cuadricula[i].y, t.malla.vertices[i].coordTextura.y * float(d.nv), 1e-5);
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

namespace {

// Una rejilla densa de cada parche.
oraculo::Objeto teteraDensa() {
    std::vector<oraculo::VerticeRef> vertices;
    std::vector<oraculo::Triangulos::Indices> indices;
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
                vertices.push_back({enPie(puntoDe(q, u, v)), oraculo::unitario(enPie(n))});
            }
    return oraculo::malla(oraculo::Mat4(), vertices, indices);
}

// El esmalte que promete tetera.frag: difuso con la luz de la izquierda y el cielo de arriba, brillo de Blinn y reflejo en los
// bordes.
oraculo::Vec3 esmalte(const oraculo::Impacto &i, const oraculo::Vec3 &color) {
    using namespace oraculo;
    const Vec3 L{-0.62, 0.45, 0.643}, V = haciaOjo(i), N = escalar(i.normal, V) < 0 ? -i.normal : i.normal;
    const double NL = std::max(escalar(N, L), 0.0), NH = std::max(escalar(N, unitario(L + V)), 0.0);
    return (0.36 + 0.68 * NL + 0.26 * N.y) * color + 0.7 * std::pow(NH, 70) * Vec3{1, 1, 1} +
           0.35 * std::pow(1 - std::max(escalar(N, V), 0.0), 4) * Vec3{0.75, 0.86, 1};
}

} // namespace

// Todo el sombreado y la silueta, píxel a píxel, con la tetera más fina; de frente y desde donde la lleva el ratón.
TEST(Tetera, SombreadoYSilueta) {
    const oraculo::Escena escena = {teteraDensa()};
    const struct {
        std::string guion;
        oraculo::Camara camara;
        int ancho, alto;
    } casos[] = {{"tecla + ×4", camaraTetera(), 480, 360},
                 {"tecla + ×4; " + arrastra({50, 60}, {90, 100}) + "; rueda -1 50 50",
                  camaraTetera(-40 * 1.8 / 120, 40 * 1.8 / 120, 9.5 * 1.1), 160, 120}};
    for (const auto &c : casos) {
        const auto comparada = oraculo::compara(
            vistaDe("tetera", c.guion, c.ancho, c.alto).escena, escena, c.camara,
            [](const oraculo::Impacto &i) { return i ? esmalte(i, exacto(AZUL)) : exacto(FONDO_CLARO); });
        // en el filo del borde el brillo cambia 200 niveles de un píxel al siguiente: el error se parte por dos con la tolerancia
        comprueba(c.guion, comparada, {4, 500, 0.7});
        EXPECT_LE(comparada.rmse, 0.35);
        EXPECT_GT(comparada.interior, c.ancho * c.alto * 8 / 10);
    }
}

// + divide entre dos el error y - lo dobla, entre 1/16 y 64; el rótulo dice el error y los triángulos que hay.
TEST(Tetera, MasFinaYMasBasta) {
    const struct {
        std::string guion; // tras el anterior
        double error;
        std::string texto;
    } pasos[] = {{"", 1, "1"},
                 {"tecla +", 0.5, "0.5"},
                 {"tecla + ×3", 0.0625, "0.0625"},
                 {"tecla +", 0.0625, "0.0625"},
                 {"tecla - ×5", 2, "2"},
                 {"tecla - ×3", 16, "16"},
                 {"tecla - ×2", 64, "64"},
                 {"tecla -", 64, "64"},
                 {"tecla +", 32, "32"}};
    std::vector<std::string> guiones;
    for (const auto &p : pasos)
        guiones.push_back(p.guion);
    const std::vector<Vista> vistas = vistasDe("tetera", guiones, 960, 720);
    for (std::size_t i = 0; i < vistas.size(); ++i) {
        const std::size_t n = teselaParches(tetera(), pasos[i].error * PIXEL).malla.indices.size() / 3;
        compruebaRotulo(vistas[i].encima,
                        "hasta " + pasos[i].texto + " px de error\n" + std::to_string(n) + " triángulos",
                        {480, 0.08 * 720}, OSCURO, Lado::CENTRO);
    }
}

// Cada píxel de la malla: la línea, de dos píxeles, va por los lados de los cuadriláteros y, en la de triángulos, por sus diagonales.
TEST(Tetera, MallaYCuadrilateros) {
    using namespace oraculo;
    const std::vector<Vista> vistas = vistasDe(
        "tetera", {"tecla - ×4", "tecla c; tecla m", "tecla c", "tecla c", "tecla m; tecla x; tecla m"}, 960,
        720);
    EXPECT_EQ(vistas[0].escena.rgb, vistas[3].escena.rgb);
    EXPECT_EQ(vistas[0].escena.rgb, vistas[4].escena.rgb);
    const Teselacion t = teselaParches(tetera(), 16 * PIXEL);
    const Camara camara = camaraTetera();
    std::vector<VerticeRef> vertices;
    std::vector<Triangulos::Indices> indices;
    for (const Vertice &v : t.malla.vertices)
        vertices.push_back({enPie(v.posicion), enPie(v.normal)});
    for (std::size_t i = 0; i < t.malla.indices.size(); i += 3)
        indices.push_back({t.malla.indices[i], t.malla.indices[i + 1], t.malla.indices[i + 2]});
    const Escena escena = {malla(Mat4(), vertices, indices)};

    // La columna y la fila del punto del plano del triángulo que se ve en (x, y).
    const auto cuadricula = [&](std::size_t triangulo, double x, double y) {
        const auto &[ia, ib, ic] = indices[triangulo];
        const Vec3 a = vertices[ia].posicion, ab = vertices[ib].posicion - a, ac = vertices[ic].posicion - a,
                   n = vectorial(ab, ac);
        const Rayo r = rayo(camara, 960, 720, x, y);
        const Vec3 ap = r.origen + escalar(n, a - r.origen) / escalar(n, r.direccion) * r.direccion - a;
        const double b1 = escalar(vectorial(ap, ac), n) / escalar(n, n),
                     b2 = escalar(vectorial(ab, ap), n) / escalar(n, n);
        return (1 - b1 - b2) * glm::dvec2(t.cuadricula[ia]) + b1 * glm::dvec2(t.cuadricula[ib]) +
               b2 * glm::dvec2(t.cuadricula[ic]);
    };
    for (const bool diagonales : {true, false}) {
        const auto sombrea = [&](const Impacto &i) {
            if (!i)
                return Tono(exacto(FONDO_CLARO));
            const glm::dvec2 p = enPixeles(camara, i.punto, 960, 720);
            const auto en = [&](double dx, double dy) {
                const glm::dvec2 c = cuadricula(std::size_t(i.corte.triangulo), p.x + dx, p.y + dy);
                return glm::dvec3(c, c.x - c.y);
            };
            const glm::dvec3 c = en(0, 0), dx = en(0.5, 0) - en(-0.5, 0), dy = en(0, 0.5) - en(0, -0.5);
            double distancia = INFINITO; // píxeles
            for (int k = 0; k < (diagonales ? 3 : 2); ++k)
                distancia =
                    std::min(distancia, std::fabs(c[k] - std::round(c[k])) / std::hypot(dx[k], dy[k]));
            const double linea = std::clamp(1.5 - distancia, 0.0, 1.0);
            return Tono((1 - linea) * esmalte(i, exacto(GRIS)) + linea * exacto(OSCURO),
                        linea > 0 ? 1 + i.corte.triangulo : 0);
        };
        comprueba(diagonales ? "triángulos" : "cuadriláteros",
                  compara(vistas[diagonales ? 1 : 2].escena, escena, camara, sombrea, 12), {4, 500, 0.3});
    }
}
