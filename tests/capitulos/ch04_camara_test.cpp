// Comprobaciones independientes de la transformación de la cámara (ecuación 4.1): vista.h contra la ecuación en
// cuádruple precisión y contra GLM, los casos difíciles, y lo que ve el programa camara contra el oráculo.
#include "ch04_oraculo.h"
#include "ch04_vista3d/vista.h"
#include "ejecuta.h"
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <iostream>
#include <random>
#include <sstream>

namespace {

using Cuadruple = boost::multiprecision::cpp_bin_float_quad;
using Vec = std::array<Cuadruple, 3>;

Vec deGlm(const glm::dvec3 &v) {
    return {v.x, v.y, v.z};
}
Vec resta(const Vec &a, const Vec &b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Cuadruple escalar(const Vec &a, const Vec &b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vec vectorial(const Vec &a, const Vec &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec unitario(const Vec &a) {
    const Cuadruple l = sqrt(escalar(a, a));
    return {a[0] / l, a[1] / l, a[2] / l};
}

/// Filas de la ecuación 4.1 en cuádruple, con S normalizado; `seno`, el del ángulo entre F y UP.
struct Referencia {
    Vec filas[3];
    Cuadruple traslacion[3];
    double seno;
};
Referencia ecuacion41(const glm::dvec3 &p, const glm::dvec3 &i, const glm::dvec3 &UP) {
    const Vec F = unitario(resta(deGlm(i), deGlm(p))), producto = vectorial(F, unitario(deGlm(UP)));
    const Vec S = unitario(producto), U = vectorial(S, F), ojo = deGlm(p);
    Referencia r{{S, U, {-F[0], -F[1], -F[2]}}, {}, static_cast<double>(sqrt(escalar(producto, producto)))};
    for (int f = 0; f < 3; ++f)
        r.traslacion[f] = -escalar(r.filas[f], ojo);
    return r;
}

/// El mayor error de la base y el de la traslación, éste dividido por |p|.
struct Error {
    double base = 0, traslacion = 0;
};
template<class Matriz>
Error error(const Matriz &M, const Referencia &r, double distancia) {
    Error e;
    for (int f = 0; f < 3; ++f) {
        for (int c = 0; c < 3; ++c)
            e.base = std::fmax(
                e.base, std::fabs(static_cast<double>(M[c][f] - r.filas[f][static_cast<std::size_t>(c)])));
        e.traslacion =
            std::fmax(e.traslacion, std::fabs(static_cast<double>(M[3][f] - r.traslacion[f])) / distancia);
    }
    return e;
}

const double U_DOBLE = std::ldexp(1.0, -53), U_FLOAT = std::ldexp(1.0, -24); // error de un redondeo

// F y UP normalizados llevan unos 6 redondeos por componente; F × UP los suma y añade 3 (18 en total, por la
// norma), y al normalizar se dividen por el seno. U y S añaden otros 12 sin dividir.
double cotaBase(double seno) {
    return 30 * U_DOBLE / seno + 12 * U_DOBLE;
}

glm::dvec3 alAzar(std::mt19937 &azar, double talla) {
    std::uniform_real_distribution<double> d(-talla, talla);
    const double x = d(azar), y = d(azar), z = d(azar);
    return {x, y, z};
}

/// Base unitaria, perpendicular, a derechas y sin NaN, y p en el origen.
void esperaBaseValida(const glm::dvec3 &p, const glm::dvec3 &i, const glm::dvec3 &UP) {
    const auto [S, U, F] = baseCamara(p, i, UP);
    const auto explica = [&, S = S, U = U, F = F] {
        std::ostringstream s;
        s << "p " << p.x << " " << p.y << " " << p.z << ", UP " << UP.x << " " << UP.y << " " << UP.z
          << ": S " << S.x << " " << S.y << " " << S.z << ", U " << U.x << " " << U.y << " " << U.z << ", F "
          << F.x << " " << F.y << " " << F.z;
        return s.str();
    };
    for (const glm::dvec3 &v : {S, U, F})
        EXPECT_NEAR(glm::length(v), 1, 8 * U_DOBLE) << explica();
    EXPECT_NEAR(glm::dot(S, U), 0, 8 * U_DOBLE) << explica();
    EXPECT_NEAR(glm::dot(S, F), 0, 8 * U_DOBLE) << explica();
    EXPECT_NEAR(glm::dot(U, F), 0, 8 * U_DOBLE) << explica();
    EXPECT_NEAR(glm::dot(glm::cross(S, U), -F), 1, 16 * U_DOBLE) << explica();
    const glm::dvec4 origen = transformacionCamara(p, i, UP) * glm::dvec4(p, 1);
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(origen[k], 0, 8 * U_DOBLE * glm::length(p)) << explica();
}

} // namespace

TEST(TransformacionCamara, ContraLaEcuacionEnCuadrupleYContraGlm) {
    std::mt19937 azar(4);
    double peor = 0, peorGlm = 0;
    for (int n = 0; n < 2000; ++n) {
        const glm::dvec3 p = alAzar(azar, 10), i = alAzar(azar, 10), UP = alAzar(azar, 3);
        const Referencia r = ecuacion41(p, i, UP);
        const glm::dmat4 M = transformacionCamara(p, i, UP), G = glm::lookAt(p, i, UP);
        const Error e = error(M, r, glm::length(p));
        ASSERT_LE(e.base, cotaBase(r.seno));
        ASSERT_LE(e.traslacion, cotaBase(r.seno) + 4 * U_DOBLE);
        peor = std::fmax(peor, e.base * r.seno);
        for (int c = 0; c < 4; ++c)
            for (int f = 0; f < 4; ++f)
                peorGlm = std::fmax(peorGlm, std::fabs(M[c][f] - G[c][f]) * r.seno);
        ASSERT_EQ(glm::row(M, 3), glm::dvec4(0, 0, 0, 1));
    }
    std::cout << "error por el seno: " << peor << "; diferencia con GLM en doble: " << peorGlm << "\n";
    EXPECT_LE(peorGlm, 17 * 2 * cotaBase(1)); // las dos se equivocan, y |p| llega a 17
}

// El libro no dice que S haya que normalizarlo; sin eso, con UP oblicuo, la matriz encoge la imagen.
TEST(TransformacionCamara, SinNormalizarSNoEsUnGiro) {
    const glm::dvec3 F = glm::normalize(glm::dvec3(0, -1, -1)), UP(0, 1, 0), S = glm::cross(F, UP);
    EXPECT_NEAR(glm::length(S), std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(glm::length(baseCamara({0, 0, 0}, F, UP).S), 1, 8 * U_DOBLE);
}

TEST(TransformacionCamara, UpParaleloNuloODeCualquierLongitud) {
    std::mt19937 azar(41);
    for (int n = 0; n < 300; ++n) {
        const glm::dvec3 p = alAzar(azar, 10), i = alAzar(azar, 10);
        for (const double k : {1.0, -1.0, 1e-3, 1e-300, 1e300, 0.0, 1e-320})
            esperaBaseValida(p, i, k * (i - p));
    }
    for (int eje = 0; eje < 3; ++eje)
        for (const double signo : {-1.0, 1.0}) {
            glm::dvec3 d(0);
            d[eje] = signo;
            for (const glm::dvec3 &UP : {d, -d, glm::dvec3(0)}) {
                esperaBaseValida({1, 2, 3}, glm::dvec3(1, 2, 3) + d, UP);
                const BaseCamara b = baseCamara({1, 2, 3}, glm::dvec3(1, 2, 3) + d, UP);
                EXPECT_EQ(b.F, d);
                if (eje == 1) {
                    EXPECT_EQ(b.S, glm::dvec3(1, 0, 0)); // planta: X a la derecha
                } else {
                    EXPECT_EQ(b.U, glm::dvec3(0, 1, 0)); // alzado y perfil: Y hacia arriba
                }
            }
        }
    // lookAt, en float y en doble, da NaN
    const glm::mat4 G = glm::lookAt(glm::vec3(0, 5, 0), glm::vec3(0), glm::vec3(0, 1, 0));
    EXPECT_TRUE(std::isnan(G[0][0]));
}

TEST(TransformacionCamara, OjoEnElPuntoDeInteres) {
    for (const glm::dvec3 &p : {glm::dvec3(0), glm::dvec3(1, -2, 3), glm::dvec3(1e6)})
        for (const glm::dvec3 &UP :
             {glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 1, 0), glm::dvec3(0)}) {
            esperaBaseValida(p, p, UP);
            EXPECT_EQ(baseCamara(p, p, UP).F, glm::dvec3(0, 0, -1));
        }
}

// UP separado de F un ángulo de 1e-3 a 1e-9: la base sigue siendo exacta y la inclinación, la pedida con el error
// que cabe esperar, u/seno. A 1e-11 ya no hay inclinación que pedir, pero sí base.
TEST(TransformacionCamara, UpCasiParalelo) {
    std::mt19937 azar(42);
    for (const double desvio : {1e-3, 1e-5, 1e-7, 1e-9}) {
        double peor = 0;
        for (int n = 0; n < 200; ++n) {
            const glm::dvec3 p = alAzar(azar, 10), i = alAzar(azar, 10), d = i - p;
            const glm::dvec3 lado = glm::normalize(glm::cross(d, alAzar(azar, 1)));
            const glm::dvec3 UP = d + desvio * glm::length(d) * lado;
            const Referencia r = ecuacion41(p, i, UP);
            const Error e = error(transformacionCamara(p, i, UP), r, glm::length(p));
            ASSERT_LE(e.base, cotaBase(r.seno)) << desvio;
            esperaBaseValida(p, i, UP);
            peor = std::fmax(peor, e.base);
        }
        std::cout << "desvío " << desvio << ": error máximo de la base " << peor << ", cota "
                  << cotaBase(desvio) << "\n";
    }
    esperaBaseValida({0, 0, 0}, {1, 2, 3}, {1, 2, 3 + 1e-11});
    esperaBaseValida({0, 0, 0}, {1e-5, 2, 3}, {1e-5, 2, 3 + 1e-9});
}

// Con el ojo a L del origen, un vértice a unas 5 unidades del ojo. En float (la matriz, el mundo o los dos) el
// error crece con L: al menos medio ulp de L. Multiplicando en doble por la del modelo antes de pasar a float, no:
// 4 productos y sumas de números menores que 16, unos 8 redondeos de 16·2⁻²⁴, y en doble 8·L·2⁻⁵³.
TEST(TransformacionCamara, OjoLejosDelOrigen) {
    std::mt19937 azar(43);
    for (const double L : {0.0, 1e3, 1e5, 1e6}) {
        double enFloat = 0, enDoble = 0;
        for (int n = 0; n < 300; ++n) {
            const glm::dvec3 p = glm::dvec3(L) + alAzar(azar, 1), i = p + alAzar(azar, 5),
                             modelo = i + alAzar(azar, 2);
            const glm::vec3 v(alAzar(azar, 1));
            const Referencia r = ecuacion41(p, i, {0, 1, 0});
            if (r.seno < 0.1)
                continue;
            const glm::vec4 simple = glm::lookAt(glm::vec3(p), glm::vec3(i), glm::vec3(0, 1, 0)) *
                                     glm::vec4(glm::vec3(modelo) + v, 1);
            const glm::mat4 MV(transformacionCamara(p, i, {0, 1, 0}) * glm::translate(glm::dmat4(1), modelo));
            const glm::vec4 bueno = MV * glm::vec4(v, 1);
            for (int f = 0; f < 3; ++f) {
                Vec mundo = deGlm(modelo), local = deGlm(v);
                for (std::size_t k = 0; k < 3; ++k)
                    mundo[k] += local[k];
                const Cuadruple exacto = escalar(r.filas[f], resta(mundo, deGlm(p)));
                enFloat = std::fmax(enFloat, std::fabs(static_cast<double>(simple[f] - exacto)));
                enDoble = std::fmax(enDoble, std::fabs(static_cast<double>(bueno[f] - exacto)));
            }
        }
        std::cout << "ojo a " << L << ": error " << enFloat << " todo en float, " << enDoble
                  << " restando en doble\n";
        EXPECT_LE(enDoble, 8 * 16 * U_FLOAT + 10 * cotaBase(0.1) + 100 * L * U_DOBLE);
        if (L >= 1e5) {
            EXPECT_GT(enFloat, 100 * enDoble);
        }
    }
}

namespace {

namespace o = oraculo;

const o::Vec3 I{0, 1.7, 0};

/// La escena de camara.cpp, escrita otra vez, con sólidos exactos.
o::ImagenRef escenaDeCamara(const o::Vec3 &p, const o::Vec3 &UP, int ancho, int alto) {
    const o::Mat4 tumba = o::gira({1, 0, 0}, -o::PI / 2);
    const o::Escena escena = {
        o::caja(o::traslada({0, -0.1, 0}) * o::escala({7, 0.2, 7})),
        o::caja(o::traslada({0, 0.75, 0}) * o::escala({0.3, 1.5, 0.3})),
        o::esfera(o::traslada(I) * o::escala(0.35)),
        o::caja(o::traslada({-2, 0.9, -1.2}) * o::escala(1.8)),
        o::cono(o::traslada({2.2, 0, -1}) * tumba * o::escala({1, 1, 2.8})),
        o::caja(o::traslada({0.9, 0.4, 2}) * o::gira({0, 1, 0}, 0.5) * o::escala({1.6, 0.8, 0.8})),
    };
    const glm::vec3 colores[] = {SUELO, GRIS, AMARILLO, ROJO, VERDE, AZUL};
    const o::Camara camara = oraculo::perspectiva(o::miraDesde(p, I, UP), 0.85, 0.5, 60);
    return o::render(escena, camara, ancho, alto, [&](const o::Impacto &i) {
        return i ? luzExacta(i.normal) * vec3De(colores[i.objeto]) : vec3De(CIELO);
    });
}

} // namespace

// Lo que ve la cámara, contra trazado de rayos con la misma posición, punto de interés e inclinación.
TEST(Camara, LoQueVe) {
    const struct {
        const char *guion;
        o::Vec3 p, UP;
        double inclinacion; // alrededor de F
    } casos[] = {{"", {4.4, 4.6, 0.4}, {0, 1, 0}, 0},
                 {"tecla 2; tecla i; tecla i; tecla i", {-4, 1.5, 0.9}, {0, 1, 0}, -0.3},
                 {"tecla 2; tecla o", {-4, 1.5, 0.9}, {0, 1, 0}, 0.1},
                 {"tecla 2; tecla i; tecla 1", {4.4, 4.6, 0.4}, {0, 1, 0}, 0},
                 {"tecla 3", {0.4, 7.2, 0.8}, {0, 0, -1}, 0},
                 // UP a 1e-7 de F: lo que cuenta de él es su diferencia, que es Z
                 {"tecla 4", {2.4, 5.4, 2.0}, {0, 0, 1}, 0}};
    const Hueco h = hueco(1, 2, 0, 1, 240, 180);
    for (const auto &c : casos) {
        const Ejecucion e = ejecuta("ch04_vista3d/camara", c.guion);
        ASSERT_EQ(e.estado, 0) << e.errores;
        const o::Vec3 UP = o::direccion(o::gira(I - c.p, c.inclinacion), c.UP);
        const Imagen derecha = recorta(e.imagen, h);
        o::ImagenRef ref = escenaDeCamara(c.p, UP, h.ancho, h.alto);
        daPorBuenos(ref, derecha,
                    [&](int x, int y) { return y > h.alto - 14 && std::abs(x - h.ancho / 2) < 30; });
        const o::Comparacion k = o::compara(derecha, ref, 7);
        std::cout << "«" << c.guion << "»: " << k << "\n";
        // el cono tiene 32 caras y en su vértice la normal salta de una a otra: media cara, sen(π/32)·0.42·255·0.62 = 6.5, más el
        // redondeo
        EXPECT_LE(k.maximo, 7) << c.guion;
        EXPECT_LE(k.rmse, 0.6) << c.guion;
        EXPECT_GT(k.interior, 14000);
        EXPECT_EQ(k.bandaLejos, 0) << c.guion;
    }
}

// Vista desde fuera: cada flecha es de su color y va hacia donde dice su rótulo; p e i están donde deben.
TEST(Camara, EjesYRotulosDesdeFuera) {
    const struct {
        const char *guion;
        o::Vec3 p, UP;
        double inclinacion;
    } casos[] = {{"", {4.4, 4.6, 0.4}, {0, 1, 0}, 0},
                 {"tecla 2; tecla i; tecla i", {-4, 1.5, 0.9}, {0, 1, 0}, -0.2}};
    for (const auto &c : casos) {
        const Ejecucion e = ejecuta("ch04_vista3d/camara", c.guion, 960, 720);
        ASSERT_EQ(e.estado, 0) << e.errores;
        const Hueco h = hueco(0, 2, 0, 1, 960, 720);
        const o::Vec3 UP = o::direccion(o::gira(I - c.p, c.inclinacion), c.UP), F = o::unitario(I - c.p),
                      S = o::unitario(o::vectorial(F, UP)), U = o::vectorial(S, F);
        const o::Camara fuera =
            oraculo::perspectiva(o::orbita(0.75, 0.32, 18.5, {-0.3, 2.7, 0}), 0.54, 1, 100);
        const auto en = [&](const o::Vec3 &punto) { return o::proyecta(fuera, h.ancho, h.alto, punto); };
        const struct {
            o::Vec3 v;
            glm::vec3 color;
            const char32_t *nombre;
        } flechas[] = {
            {3.4 * UP, NARANJA, U"UP"}, {2.5 * S, ROJO, U"S"}, {2.5 * U, VERDE, U"U"}, {2.5 * F, AZUL, U"F"}};
        for (const auto &f : flechas) {
            const o::Vec3 medio = en(c.p + 0.8 * f.v), masAlla = en(c.p + 1.3 * f.v);
            const Pixel p = pixel(e.imagen, static_cast<int>(medio.x), static_cast<int>(medio.y));
            EXPECT_TRUE(esColor(p, f.color))
                << c.guion << " " << p.r << " " << p.g << " " << p.b << " en " << medio.x << "," << medio.y;
            EXPECT_LE(distanciaRotulo(e.imagen, f.nombre, f.color, masAlla.x, masAlla.y), 6 / 720.0)
                << c.guion << " " << masAlla.x << "," << masAlla.y;
        }
        const o::Vec3 p = en(c.p), i = en(I);
        EXPECT_LE(distanciaRotulo(e.imagen, U"p", OSCURO, p.x, p.y - 26), 8 / 720.0) << c.guion;
        EXPECT_LE(distanciaRotulo(e.imagen, U"i", OSCURO, i.x + 22, i.y), 8 / 720.0) << c.guion;
    }
}

// El comienzo de la pirámide de visión: a 3 unidades del ojo, lo que abarca el panel de la derecha.
TEST(Camara, LaPiramideEsLaDeLaImagen) {
    const Ejecucion e = ejecuta("ch04_vista3d/camara", "", 960, 720);
    ASSERT_EQ(e.estado, 0) << e.errores;
    const Hueco h = hueco(0, 2, 0, 1, 960, 720), d = hueco(1, 2, 0, 1, 960, 720);
    const o::Camara fuera = oraculo::perspectiva(o::orbita(0.75, 0.32, 18.5, {-0.3, 2.7, 0}), 0.54, 1, 100),
                    dentro = oraculo::perspectiva(o::miraDesde({4.4, 4.6, 0.4}, I), 0.85, 0.5, 60);
    int buenos = 0, puntos = 0;
    for (int k = 0; k < 4; ++k)
        for (int n = 1; n < 20; ++n) { // los lados del marco: de esquina a esquina del panel
            const double u = n / 20.0,
                         px = (k == 0   ? u
                               : k == 1 ? 1
                               : k == 2 ? u
                                        : 0) *
                              d.ancho,
                         py = (k == 0   ? 0
                               : k == 1 ? u
                               : k == 2 ? 1
                                        : u) *
                              d.alto;
            const o::Rayo r = o::rayo(dentro, d.ancho, d.alto, px, py);
            const o::Ejes ejes = o::ejes(dentro);
            const o::Vec3 punto = r.origen + (3 / -o::escalar(r.direccion, ejes.z)) * r.direccion,
                          w = o::proyecta(fuera, h.ancho, h.alto, punto);
            ++puntos;
            buenos += esColor(pixel(e.imagen, static_cast<int>(w.x), static_cast<int>(w.y)), GRIS);
        }
    EXPECT_GE(buenos, puntos * 6 / 10) << "de " << puntos; // los demás los tapan las flechas y la escena
}
