// Comprobaciones independientes de las partículas del capítulo 12. Dónde está cada una se calcula aquí, en doble precisión, y se
// busca en la imagen en los dos sentidos: donde debe haber una la hay, y donde no, no.
#include "ch08_oraculo.h"
#include "ch12_animacion/reloj.h"
#include "colores.h"
#include "ejecuta.h"
#include "encima.h"
#include "oraculo/oraculo.h"
#include "rotulos.h"
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>

using oraculo::PI;
using oraculo::Vec3;

namespace {

const std::string PARTICULAS = "ch12_animacion/particulas", MOSAICO = "ch12_animacion/mosaico",
                  BANDERAS = "ch12_animacion/banderas";
const int ANCHO = 960, ALTO = 720, ROTULO = 80; // por debajo de esa fila hay rótulos
const char *const CIEN_HORAS =
    "tecla h; tecla h; tecla h; tecla h; tecla h; tecla h; tecla h; tecla h; tecla h; tecla h; ";

/// El guion que lleva a ese instante, múltiplo de medio segundo, sin dibujar todos los de en medio.
std::string instante(double t) {
    std::string g = "tecla Espacio";
    for (int i = 0; i < std::lround(2 * t); ++i)
        g += "; tecla s";
    return g;
}

bool es(const Pixel &p, const glm::vec3 &c, int margen = 1) {
    return std::abs(p.r - std::lround(255 * c.r)) <= margen &&
           std::abs(p.g - std::lround(255 * c.g)) <= margen &&
           std::abs(p.b - std::lround(255 * c.b)) <= margen;
}

double azarDe(std::uint32_t n) {
    n = (n ^ (n >> 16)) * 0x7feb352du;
    n = (n ^ (n >> 15)) * 0x846ca68bu;
    n ^= n >> 16;
    return (n >> 8) / 16777216.0;
}
double mezcla(double a, double b, double t) {
    return a + (b - a) * t;
}
double parteDecimal(double x) {
    return x - std::floor(x);
}

// --- Partículas ---

const double VIDAS[] = {3, 4, 1.5}; // segundos
const int GRUPOS[] = {13, 60, 7};

/// Qué parte de su vida ha pasado; las partículas de una bocanada de humo nacen juntas.
double edadDe(int modo, std::uint32_t id, double t) {
    return parteDecimal(t / VIDAS[modo] + azarDe(modo == 1 ? id % 60 : id));
}

/// Si vive, y dónde está la partícula `id` en el segundo t.
bool posicion(int modo, std::uint32_t id, double t, Vec3 &P) {
    const double tau = parteDecimal(t / VIDAS[modo]), edad = edadDe(modo, id, t), s = edad * VIDAS[modo];
    const auto grupo = id % static_cast<std::uint32_t>(GRUPOS[modo]);
    const std::uint32_t semilla = 4 * id + 0x9e3779b9u;
    const double a = azarDe(semilla), b = azarDe(semilla + 1), c = azarDe(semilla + 2);
    const auto angulo = [](double vueltas) { return 2 * PI * vueltas; };
    if (modo == 0) { // v·t + g·t²/2, con g = 5; doce chorros alrededor de uno más alto
        const double sale = grupo ? 0.80 + 0.14 * b : 0.22 * std::sqrt(b),
                     u = angulo(grupo ? (grupo + 0.16 * a) / 12 : a),
                     v = grupo ? 4.9 + 0.35 * c : 5.6 + 1.0 * c;
        P = {sale * std::cos(u) * s, v * s - 5 * s * s / 2, sale * std::sin(u) * s};
        return P.y >= 0;
    }
    if (modo == 1) { // dentro de una esfera que crece, gira y se aleja
        const double R = (0.20 + 0.85 * edad) * std::pow(b, 0.33), z = 2 * c - 1, u = angulo(a + 0.5 * edad),
                     sale = std::sqrt(azarDe(grupo + 100)) * edad, w = angulo(azarDe(grupo + 200)),
                     h = std::sqrt(1 - z * z);
        P = {R * h * std::cos(u) + sale * std::cos(w) + 0.09 * s * s, R * h * std::sin(u) + 0.93 * s + 0.12,
             R * z + sale * std::sin(w)};
        return P.y >= 0;
    }
    const double llega = grupo ? 0.45 + 0.4 * azarDe(grupo) : 1, fase = azarDe(grupo + 50),
                 mece = std::sin(2 * PI * (edad - tau + fase)) +
                        0.5 * std::sin(2 * PI * (2.3 * edad - 3 * tau + 3 * fase)),
                 base = grupo ? 0.75 * (1 - 0.8 * edad) : 0, u = angulo(grupo / 6.0),
                 r = 0.5 * std::sqrt(b) * (1 - edad) * (0.7 + 2 * edad);
    P = {base * std::cos(u) + r * std::cos(2 * PI * a) + 0.28 * edad * mece,
         4.8 * llega * edad * (0.7 + 0.3 * c), base * std::sin(u) + r * std::sin(2 * PI * a)};
    return true;
}

oraculo::Camara camaraParticulas() {
    return oraculo::perspectiva(oraculo::orbita(0.4, 0.12, 12, {0, 1.95, 0}), 0.55, 0.5, 50);
}

/// Lo que hay de la cámara al plano del punto.
double distanciaDe(const Vec3 &P) {
    const Vec3 haciaCamara{std::cos(0.12) * std::sin(0.4), std::sin(0.12), std::cos(0.12) * std::cos(0.4)};
    return 12 - oraculo::escalar(P - Vec3{0, 1.95, 0}, haciaCamara);
}

struct Aspecto {
    double diametro;
    Vec3 color;
    double alfa;
};
Aspecto aspectoDe(int modo, std::uint32_t id, double t) {
    const std::uint32_t semilla = 4 * id + 0x9e3779b9u;
    const double edad = edadDe(modo, id, t), a = azarDe(semilla), b = azarDe(semilla + 1),
                 c = azarDe(semilla + 2);
    if (modo == 0)
        return {0.07, (1 - c) * Vec3{0.20, 0.50, 0.95} + c * Vec3{0.85, 0.95, 1}, 0.4};
    if (modo == 1) { // la luz viene de arriba a la izquierda y delante
        const double z = 2 * c - 1, h = std::sqrt(1 - z * z), u = 2 * PI * (a + 0.5 * edad),
                     luz = 0.5 + 0.5 * std::pow(b, 0.33) *
                                     (-0.49 * h * std::cos(u) + 0.78 * h * std::sin(u) + 0.39 * z);
        return {0.15 + 0.24 * edad, (1 - luz) * Vec3{0.16, 0.17, 0.21} + luz * Vec3{0.98, 0.96, 0.92},
                0.20 * (1 - edad) * std::min(8 * edad, 1.0)};
    }
    return {0.26 * (1 - 0.7 * edad), (1 - edad) * Vec3{1, 0.62, 0.18} + edad * Vec3{0.85, 0.10, 0.02},
            0.11 * (1 - edad * edad)};
}

struct Hallazgo {
    double x = 0, y = 0, luz = 0;
};
/// Centro de lo que brilla más que el fondo cerca de un punto.
Hallazgo centroDe(const Imagen &im, double x0, double y0, int radio) {
    Hallazgo h;
    for (int y = std::max(0, int(y0) - radio); y <= std::min(im.alto - 1, int(y0) + radio); ++y)
        for (int x = std::max(0, int(x0) - radio); x <= std::min(im.ancho - 1, int(x0) + radio); ++x) {
            const Pixel p = pixel(im, x, y);
            const double luz = std::max(
                0.0, p.r + p.g + p.b - 255.0 * (FONDO_OSCURO.r + FONDO_OSCURO.g + FONDO_OSCURO.b) - 3);
            h.x += luz * (x + 0.5);
            h.y += luz * (y + 0.5);
            h.luz += luz;
        }
    h.x /= h.luz;
    h.y /= h.luz;
    return h;
}

/// Lo que recibe de más que el fondo, de media, un píxel por encima de los rótulos.
double luzDe(const Imagen &im) {
    double luz = 0;
    for (int y = ROTULO * im.alto / ALTO; y < im.alto; ++y)
        for (int x = 0; x < im.ancho; ++x) {
            const Pixel p = pixel(im, x, y);
            luz += p.r + p.g + p.b - 255.0 * (FONDO_OSCURO.r + FONDO_OSCURO.g + FONDO_OSCURO.b);
        }
    return luz / (im.ancho * im.alto);
}

/// El guion que lleva a ese modo y ese instante con 10 000 / 10^partes partículas.
std::string guionDe(int modo, int partes, double t, bool horas) {
    std::string g;
    for (int i = 0; i < partes; ++i)
        g += "tecla -; ";
    return g + "tecla " + std::to_string(modo + 1) + "; " + (horas ? CIEN_HORAS : "") + instante(t);
}

} // namespace

// Una sola partícula, a las 0 h y a las 100 h, en muchos instantes: su centro, a menos de un píxel de la forma cerrada.
TEST(Particulas, UnaSolaContraFormaCerrada) {
    for (int modo = 0; modo < 3; ++modo)
        for (const bool horas : {false, true}) {
            int vistas = 0;
            for (double t : {0.5, 2.5, 4.5, 7.5, 11.5}) {
                const Imagen im = ejecuta(PARTICULAS, guionDe(modo, 4, t, horas), ANCHO, ALTO).imagen;
                Vec3 P;
                if (!posicion(modo, 0, t, P))
                    continue;
                const auto q = oraculo::proyecta(camaraParticulas(), ANCHO, ALTO, P);
                if (edadDe(modo, 0, t) > 0.85 || q.y < ROTULO ||
                    P.y < 0.6) // casi invisible, o junto a lo que no es ella
                    continue;
                const int radio = modo == 0 ? 16 : 50;
                const Hallazgo h = centroDe(im, q.x, q.y, radio);
                ASSERT_GT(h.luz, 0) << modo << " " << t;
                EXPECT_LE(std::hypot(h.x - q.x, h.y - q.y), 1.0) << modo << " t " << t << " horas " << horas;
                ++vistas;
            }
            EXPECT_GE(vistas, 2) << modo;
        }
}

// Mil gotas: hay luz donde debe haber cada una, y ni un píxel encendido lejos de todas.
TEST(Particulas, MilGotasYNingunaMas) {
    for (const double t : {0.0, 1.5, 11.0}) {
        const Imagen im = ejecuta(PARTICULAS, guionDe(0, 1, t, t == 11.0), ANCHO, ALTO).imagen;
        std::vector<int> cerca(ANCHO * ALTO, 0);
        int faltan = 0, hay = 0;
        for (std::uint32_t id = 0; id < 1000; ++id) {
            Vec3 P;
            if (!posicion(0, id, t, P))
                continue;
            const auto q = oraculo::proyecta(camaraParticulas(), ANCHO, ALTO, P);
            const int x0 = int(q.x), y0 = int(q.y), r = 14;
            for (int y = std::max(0, y0 - r); y <= std::min(ALTO - 1, y0 + r); ++y)
                for (int x = std::max(0, x0 - r); x <= std::min(ANCHO - 1, x0 + r); ++x)
                    cerca[std::size_t(y * ANCHO + x)] = 1;
            if (P.y < 0.7)
                continue; // sobre la circunferencia
            ++hay;
            faltan += es(pixel(im, x0, y0), FONDO_OSCURO, 12);
        }
        EXPECT_GT(hay, 300);
        EXPECT_EQ(faltan, 0) << t;
        for (int i = 0; i < 2000; ++i) { // la circunferencia del suelo
            const double a = 2 * PI * i / 2000;
            const auto q =
                oraculo::proyecta(camaraParticulas(), ANCHO, ALTO, {2.1 * std::cos(a), 0, 2.1 * std::sin(a)});
            for (int y = std::max(0, int(q.y) - 5); y <= int(q.y) + 5; ++y)
                for (int x = int(q.x) - 5; x <= int(q.x) + 5; ++x)
                    cerca[std::size_t(y * ANCHO + x)] = 1;
        }
        int sobran = 0;
        for (int y = ROTULO; y < ALTO; ++y) // tampoco bajo el suelo
            for (int x = 0; x < ANCHO; ++x)
                sobran += !cerca[std::size_t(y * ANCHO + x)] && !es(pixel(im, x, y), FONDO_OSCURO);
        EXPECT_EQ(sobran, 0) << t;
    }
}

// Cien de cada clase, más de las que hay grupos: la imagen entera, mezclada aquí en doble precisión en el orden de sus números.
TEST(Particulas, CienContraSuImagenEnLaCPU) {
    for (int modo = 0; modo < 3; ++modo)
        for (const double t : {1.0, 3.5}) {
            const Imagen im = ejecuta(PARTICULAS, guionDe(modo, 2, t, false), ANCHO, ALTO).imagen;
            std::vector<Vec3> ref(ANCHO * ALTO, 255 * Vec3{FONDO_OSCURO.r, FONDO_OSCURO.g, FONDO_OSCURO.b});
            for (std::uint32_t id = 0; id < 100; ++id) {
                Vec3 P;
                if (!posicion(modo, id, t, P))
                    continue;
                const Aspecto a = aspectoDe(modo, id, t);
                const auto q = oraculo::proyecta(camaraParticulas(), ANCHO, ALTO, P);
                const double radio = 0.5 * 3 * a.diametro * (0.5 * ALTO / std::tan(0.275)) / distanciaDe(P);
                for (int y = std::max(0, int(q.y - radio)); y <= std::min(ALTO - 1, int(q.y + radio)); ++y)
                    for (int x = std::max(0, int(q.x - radio)); x <= std::min(ANCHO - 1, int(q.x + radio));
                         ++x) {
                        const double u = (x + 0.5 - q.x) / radio, v = (y + 0.5 - q.y) / radio,
                                     alfa = a.alfa * std::max(0.0, 1 - u * u - v * v);
                        Vec3 &c = ref[std::size_t(y * ANCHO + x)];
                        c = (modo == 1 ? 1 - alfa : 1.0) * c + 255 * alfa * a.color;
                    }
            }
            int pintados = 0, mal = 0;
            for (int y = modo == 0 ? 250 : 200; y < ALTO; ++y) // por encima de la circunferencia del suelo
                for (int x = 0; x < ANCHO; ++x) {
                    const Vec3 &c = ref[std::size_t(y * ANCHO + x)];
                    const Pixel p = pixel(im, x, y);
                    const double d = std::max({std::fabs(p.r - std::min(c.x, 255.0)),
                                               std::fabs(p.g - std::min(c.y, 255.0)),
                                               std::fabs(p.b - std::min(c.z, 255.0))});
                    pintados += !es(p, FONDO_OSCURO);
                    mal += d > 6; // cada mezcla redondea a 8 bits
                }
            EXPECT_GT(pintados, modo == 0 ? 1000 : 20000) << modo << " " << t;
            EXPECT_LE(mal, pintados / 200) << modo << " " << t;
        }
}

// De 1 a un millón, y no más: la tecla no pasa de ahí (la imagen es la misma).
TEST(Particulas, DeUnaAUnMillon) {
    const auto con = [](const std::string &teclas) {
        return ejecuta(PARTICULAS, "tecla Espacio" + teclas, 120, 90).imagen.rgb;
    };
    EXPECT_EQ(con("; tecla +; tecla +"), con("; tecla +; tecla +; tecla +"));
    EXPECT_EQ(con("; tecla -; tecla -; tecla -; tecla -"),
              con("; tecla -; tecla -; tecla -; tecla -; tecla -"));
    EXPECT_NE(con("; tecla -; tecla -; tecla -; tecla -"), con("; tecla -; tecla -; tecla -"));
    EXPECT_NE(con("; tecla +; tecla +"), con("; tecla +"));
    EXPECT_EQ(con("; tecla +; tecla -"), con(""));
}

// Cien veces más partículas cubren entre todas lo mismo: la luz de la imagen, que las suma, no cambia. Y el rótulo las cuenta.
TEST(Particulas, LaLuzNoDependeDeCuantas) {
    for (int modo = 0; modo < 3; ++modo) {
        double luz[2];
        for (const int mas : {0, 2}) {
            std::string g = "tecla " + std::to_string(modo + 1) + "; tecla s; tecla s; tecla s";
            for (int i = 0; i < mas; ++i)
                g += "; tecla +";
            const Imagen im = ejecuta(PARTICULAS, g, ANCHO, ALTO).imagen;
            EXPECT_FALSE(leeRotulo(im,
                                   mas ? "t = 1.50 s, 1 000 000 partículas" : "t = 1.50 s, 10 000 partículas",
                                   BLANCO)
                             .empty())
                << modo;
            luz[mas / 2] = luzDe(im);
        }
        EXPECT_NEAR(luz[1] / luz[0], 1, 0.15) << modo;
    }
    EXPECT_FALSE(leeRotulo(ejecuta(PARTICULAS, "tecla -; tecla -; tecla -; tecla -", 480, 360).imagen,
                           "t = 0.00 s, 1 partícula", BLANCO)
                     .empty());
}

// Tampoco la de un millón de gotas que no llegan a un píxel: en una ventana de la mitad, cada píxel recibe lo mismo.
TEST(Particulas, LaLuzDeLasQueNoLleganAUnPixel) {
    const auto con = [](int ancho, int alto) {
        return luzDe(ejecuta(PARTICULAS, "tecla s; tecla s; tecla s; tecla +; tecla +", ancho, alto).imagen);
    };
    EXPECT_NEAR(con(ANCHO / 2, ALTO / 2) / con(ANCHO, ALTO), 1, 0.15);
}

// La luz de fuente y fuego se suma y el humo tapa: donde hay humo denso no se pasa del gris claro.
TEST(Particulas, ElHumoTapaYElFuegoSuma) {
    int blancos[3] = {};
    for (const int modo : {1, 2}) {
        const Imagen im = ejecuta(PARTICULAS, guionDe(modo, 0, 1.5, false), ANCHO, ALTO).imagen;
        for (int y = ROTULO + 40; y < ALTO; ++y)
            for (int x = 0; x < ANCHO; ++x) {
                const Pixel p = pixel(im, x, y);
                blancos[modo] += p.r > 240;
            }
    }
    EXPECT_EQ(blancos[1], 0);
    EXPECT_GT(blancos[2], 2000);
}

// --- Mosaico y banderas ---

namespace {

struct Vida {
    double nace, muere;
    double crecida(double t) const {
        return std::min(1.0, std::max(0.0, std::min(t - nace, muere - t) / 0.4));
    }
};
Vida vidaDe(int i) { // nacen entre 0 y 3.5 s y mueren entre 6 y 9.5
    const auto n = 2 * static_cast<std::uint32_t>(i);
    return {3.5 * azarDe(n), mezcla(6, 9.5, azarDe(n + 1))};
}
double vaivenDe(int c, int f, double t, double cual) {
    return definicion::ruido(glm::dvec3(0.31 * c + cual, 0.31 * f + cual, 2 * t), {0, 0, 20});
}

} // namespace

TEST(Mosaico, CadaTeselaVivaEstaEnSuSitio) {
    const int C = 52, F = 39;
    const double k = 0.5 * ALTO / 1.28; // píxeles por unidad
    for (const bool horas : {false, true})
        for (const double t : {0.0, 1.5, 3.0, 5.0, 8.0, 9.5, 11.5}) {
            const double tt = std::fmod(t, 10);
            const Imagen im = ejecuta(MOSAICO, (horas ? CIEN_HORAS : "") + (instante(t)), ANCHO, ALTO).imagen;
            std::vector<char> cubierto(ANCHO * ALTO, 0);
            int vivas = 0, faltan = 0;
            for (int i = 0; i < C * F; ++i) {
                const int c = i % C, f = i / C;
                const double crece = vidaDe(i).crecida(tt), lado = 0.9 * crece / F,
                             giro = 0.5 * vaivenDe(c, f, tt, 7.3);
                const double x = (2 * c + 1 - C + 0.9 * vaivenDe(c, f, tt, 0)) / F,
                             y = (2 * f + 1 - F + 0.9 * vaivenDe(c, f, tt, 40.7)) / F;
                // por dentro y por fuera del cuadrado girado, con un margen de un píxel y medio
                for (int v = -12; v <= 12; ++v)
                    for (int u = -12; u <= 12; ++u) {
                        const int px = int(std::floor(ANCHO / 2 + k * x)) + u,
                                  py = int(std::floor(ALTO / 2 + k * y)) + v;
                        const double dx = (px + 0.5 - ANCHO / 2) / k - x, dy = (py + 0.5 - ALTO / 2) / k - y;
                        const double a = std::fabs(std::cos(giro) * dx + std::sin(giro) * dy),
                                     b = std::fabs(-std::sin(giro) * dx + std::cos(giro) * dy), m = 1.0 / k;
                        const bool fuera = crece == 0 || std::max(a, b) > lado + m;
                        if (!fuera)
                            cubierto[std::size_t(py * ANCHO + px)] = 1;
                        if (crece > 0 && std::max(a, b) < lado - m)
                            faltan += es(pixel(im, px, py), FONDO_CLARO);
                    }
                vivas += crece > 0;
            }
            int sobran = 0;
            for (int y = ROTULO; y < ALTO; ++y)
                for (int x = 0; x < ANCHO; ++x)
                    sobran += !cubierto[std::size_t(y * ANCHO + x)] && !es(pixel(im, x, y), FONDO_CLARO);
            EXPECT_EQ(faltan, 0) << t;
            EXPECT_EQ(sobran, 0) << t;
            if (tt == 5.0) {
                EXPECT_EQ(vivas, C * F);
            }
            if (tt == 0.0 || tt >= 9.5) {
                EXPECT_LE(vivas, 1);
            }
        }
}

// El dibujo: el centro rojo, los pétalos amarillos con el filo naranja, la orla oscura y el fondo azul.
TEST(Mosaico, LosColoresDeLaFlor) {
    const Imagen im = ejecuta(MOSAICO, instante(5), ANCHO, ALTO).imagen;
    const double k = 0.5 * ALTO / 1.28;
    const auto parecido = [&](double x, double y, const glm::vec3 &c) {
        int si = 0; // alguno de alrededor: entre teselas se ve el fondo
        for (int v = -4; v <= 4; ++v)
            for (int u = -4; u <= 4; ++u) {
                const Pixel p = pixel(im, int(ANCHO / 2 + k * x) + u, int(ALTO / 2 + k * y) + v);
                const double e = p.r / (255.0 * c.r);
                si += e > 0.85 && e < 1.15 && std::fabs(p.g - 255 * c.g * e) < 6;
            }
        return si >= 8;
    };
    EXPECT_TRUE(parecido(0, 0.05, ROJO));
    for (int i = 0; i < 8; ++i)
        EXPECT_TRUE(parecido(0.4 * std::cos(i * PI / 4), 0.4 * std::sin(i * PI / 4), AMARILLO)) << i;
    for (int i = 0; i < 8; i += 2)
        EXPECT_TRUE(parecido(0.74 * std::cos(i * PI / 4), 0.74 * std::sin(i * PI / 4), NARANJA)) << i;
    for (const double s : {-1.0, 1.0}) {
        EXPECT_TRUE(parecido(0, 0.95 * s, OSCURO));
        EXPECT_TRUE(parecido(1.29 * s, 0, OSCURO));
    }
}

// El rótulo dice qué les pasa: los instantes, de la figura, se repiten cada diez segundos.
TEST(Mosaico, DiceEnQueEtapaEstan) {
    const std::pair<double, const char *> etapas[] = {{0, "t = 0.00 s, nacen"},
                                                      {3, "t = 3.00 s, nacen"},
                                                      {3.5, "t = 3.50 s, viven"},
                                                      {5.5, "t = 5.50 s, viven"},
                                                      {6, "t = 6.00 s, mueren"},
                                                      {9, "t = 9.00 s, mueren"},
                                                      {9.5, "t = 9.50 s, no queda ninguna"},
                                                      {10, "t = 10.00 s, nacen"}};
    for (const std::string &programa : {MOSAICO, BANDERAS})
        for (const auto &[t, texto] : etapas)
            EXPECT_FALSE(leeRotulo(ejecuta(programa, instante(t)).imagen, texto, OSCURO).empty())
                << programa << " " << t;
}

TEST(Banderas, CadaUnaConSuAstaEnSuSitio) {
    const int C = 26, F = 12;
    const oraculo::Camara camara =
        oraculo::perspectiva(oraculo::orbita(0.35, 0.34, 43, {0.4, 3.9, -4.5}), 0.5, 1, 200);
    for (const double t : {1.5, 3.0, 5.0, 8.0}) {
        const Imagen im = ejecuta(BANDERAS, instante(t), ANCHO, ALTO).imagen;
        int bien = 0, vivas = 0, deMas = 0, muertas = 0;
        for (int i = 0; i < C * F; ++i) {
            const int c = i % C, f = i / C;
            const double crece = vidaDe(i).crecida(t), a = 0.7 * vaivenDe(c, f, t, 0);
            if (crece > 0 && crece < 1)
                continue;
            const double ancho = 0.9, alto = 1.1, u = 0.55 * ancho, v = 0.72 * alto; // en medio de la tela
            const Vec3 P{c - 12.5 - 0.25 + std::cos(a) * u - std::sin(a) * v,
                         0.8 * f + 0.25 + 0.3 * vaivenDe(c, f, t, 40.7) + std::sin(a) * u + std::cos(a) * v,
                         -0.9 * f};
            const auto q = oraculo::proyecta(camara, ANCHO, ALTO, P);
            const glm::vec3 colores[] = {ROJO, AMARILLO, AZUL};
            const int franja = int(std::floor(0.25 * (std::fabs(c - 12.5) + 2 * f))) % 3;
            const Pixel p = pixel(im, int(q.x), int(q.y));
            const glm::vec3 &k = colores[franja];
            const int canal = franja == 2 ? 2 : 0;
            const double e = (canal ? p.b : p.r) / (255.0 * k[canal]);
            const bool suya = e > 0.7 && e < 1.02 && std::fabs(p.g - 255 * e * k.g) < 4 &&
                              std::fabs((canal ? p.r - 255 * e * k.r : p.b - 255 * e * k.b)) < 4;
            (crece > 0 ? vivas : muertas) += 1;
            (crece > 0 ? bien : deMas) += suya;
        }
        EXPECT_GT(vivas + muertas, 200);
        EXPECT_GE(bien, 0.9 * vivas) << t;     // a alguna la tapa la de delante
        EXPECT_LE(deMas, 0.12 * muertas) << t; // donde no hay puede verse la de detrás
    }
}

// La grada, cuando no queda ninguna bandera; y bajo la tela de las de la primera fila, el escalón que tienen detrás.
TEST(Banderas, LaGrada) {
    const oraculo::Camara camara =
        oraculo::perspectiva(oraculo::orbita(0.35, 0.34, 43, {0.4, 3.9, -4.5}), 0.5, 1, 200);
    oraculo::Escena escena;
    for (int f = 0; f < 12; ++f) // hasta el suelo, que está un escalón por debajo de la primera fila
        escena.push_back(oraculo::caja(oraculo::traslada({0, 0.4 * f - 0.4, -0.9 * f}) *
                                       oraculo::escala({26.6, 0.8 * (f + 1), 0.9})));
    const Vec3 cielo{CIELO.r, CIELO.g, CIELO.b};
    const auto color = [&](const oraculo::Impacto &i) {
        return i ? (0.58 + 0.42 * oraculo::escalar(i.normal, {0.20, 0.78, 0.593})) * Vec3{0.66, 0.68, 0.72}
                 : cielo;
    };
    const oraculo::ImagenRef ref = oraculo::render(escena, camara, ANCHO, ALTO, color);
    SinEncima vacia(ejecuta(BANDERAS, instante(9.5), ANCHO, ALTO).imagen, ref);
    EXPECT_TRUE(vacia.rotulo("t = 9.50 s, no queda ninguna", OSCURO, 0, 0, ANCHO));
    const oraculo::Comparacion c = oraculo::compara(vacia.limpia, ref);
    EXPECT_LE(c.maximo, 1) << c;
    EXPECT_LE(c.bandaLejos, c.banda / 500) << c;

    const Imagen llena = ejecuta(BANDERAS, instante(5), ANCHO, ALTO).imagen;
    for (int i = 0; i < 26; ++i) {
        const double a = 0.7 * vaivenDe(i, 0, 5, 0), u = 0.5 * 0.9, v = 0.2 * 1.1;
        const auto q =
            oraculo::proyecta(camara, ANCHO, ALTO,
                              {i - 12.75 + std::cos(a) * u - std::sin(a) * v,
                               0.25 + 0.3 * vaivenDe(i, 0, 5, 40.7) + std::sin(a) * u + std::cos(a) * v, 0});
        const Pixel p = pixel(llena, int(q.x), int(q.y));
        EXPECT_NEAR(1.0 * p.r / p.g, 0.66 / 0.68, 0.03) << i;
    }
}

// A las 100 horas se ve lo mismo que al principio, salvo el rótulo; y parar no cambia nada.
TEST(Tiempo, ALas100HorasTodoSigueIgual) {
    for (const std::string &programa : {PARTICULAS, MOSAICO, BANDERAS}) {
        const Imagen a = ejecuta(programa, "espera 2500", 480, 360).imagen,
                     b = ejecuta(programa, CIEN_HORAS + std::string("espera 2500"), 480, 360).imagen,
                     c = ejecuta(programa,
                                 "espera 1000; tecla Espacio; espera 3000; tecla Espacio; espera 1500", 480,
                                 360)
                             .imagen,
                     d = ejecuta(programa, "espera 1000", 480, 360).imagen;
        int distintos = 0, mueve = 0;
        for (int y = 40; y < 360; ++y)
            for (int x = 0; x < 480; ++x) {
                const Pixel p = pixel(a, x, y), q = pixel(b, x, y), r = pixel(d, x, y);
                distintos += std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b) > 6;
                mueve += std::abs(p.r - r.r) + std::abs(p.g - r.g) + std::abs(p.b - r.b) > 6;
            }
        EXPECT_LE(distintos, 20) << programa;
        EXPECT_GT(mueve, 500) << programa;
        EXPECT_EQ(a.rgb, c.rgb) << programa;
    }
}

// La tecla d adelanta una décima y la s, cinco.
TEST(Tiempo, LaDecimaEsUnaQuintaParteDeMedioSegundo) {
    EXPECT_EQ(ejecuta(MOSAICO, "tecla d; tecla d; tecla d; tecla d; tecla d").imagen.rgb,
              ejecuta(MOSAICO, "tecla s").imagen.rgb);
    EXPECT_FALSE(leeRotulo(ejecuta(MOSAICO, "tecla d; tecla s").imagen, "t = 0.60 s, nacen", OSCURO).empty());
}

TEST(Reloj, FaseYPausa) {
    EXPECT_FLOAT_EQ(fase(2.5, 10), 0.25f);
    EXPECT_EQ(fase(360000, 12), 0.0f);
    EXPECT_NEAR(fase(360000.001, 12) * 12, 0.001, 1e-6);
    EXPECT_NEAR(fase(-1, 4), 0.75, 1e-7);
    for (double t = 0; t < 40; t += 0.0137) {
        const float f = fase(t + 360000, 12);
        EXPECT_GE(f, 0);
        EXPECT_LT(f, 1);
        EXPECT_NEAR(std::sin(2 * PI * f), std::sin(2 * PI * t / 12), 1e-6);
    }
    EXPECT_LT(fase(12 - 1e-15, 12), 1.0f);
    Reloj r;
    EXPECT_EQ(segundos(r, 1500), 1.5);
    conmutaPausa(r, 1500);
    EXPECT_EQ(segundos(r, 9000), 1.5);
    adelanta(r, 10);
    EXPECT_EQ(segundos(r, 9000), 11.5);
    conmutaPausa(r, 9500);
    EXPECT_EQ(segundos(r, 10000), 12.0);
    adelanta(r, 3600);
    EXPECT_EQ(segundos(r, 10000), 3612.0);
}
