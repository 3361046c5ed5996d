// Comprobaciones independientes de los programas del capítulo 12 que no son partículas: qué debe verse en cada instante se
// calcula aquí, en doble precisión.
#include "ch08_oraculo.h"
#include "colores.h"
#include "ejecuta.h"
#include "oraculo/oraculo.h"
#include "rotulos.h"
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>

using oraculo::PI;
using oraculo::Vec3;

namespace {

const int ANCHO = 480, ALTO = 360, ROTULO = 40; // por debajo de esa fila hay rótulos
const char *const CIEN_HORAS =
    "tecla h; tecla h; tecla h; tecla h; tecla h; tecla h; tecla h; tecla h; tecla h; tecla h; ";

/// Lleva al instante t, múltiplo de medio segundo, sin dibujar los de en medio.
std::string instante(double t) {
    std::string g = "tecla Espacio";
    for (int i = 0; i < std::lround(2 * t); ++i)
        g += "; tecla s";
    return g;
}
Imagen en(const std::string &programa, double t, const std::string &antes = "") {
    return ejecuta("ch12_animacion/" + programa, antes + instante(t), ANCHO, ALTO).imagen;
}
double distancia(const Pixel &p, const Vec3 &c) {
    return std::max({std::fabs(p.r - c.x), std::fabs(p.g - c.y), std::fabs(p.b - c.z)});
}
Vec3 color(const Pixel &p) {
    return {double(p.r), double(p.g), double(p.b)};
}
bool es(const Pixel &p, const glm::vec3 &c) {
    return distancia(p, 255 * Vec3{c.r, c.g, c.b}) <= 1;
}

} // namespace

// alfa = (1 − cos(2πt/4))/2: la mezcla de lo que hay sin anillo (t = 0) y con él opaco (t = 2).
TEST(Desvanecer, MezclaExacta) {
    const Imagen sin = en("desvanecer", 0), con = en("desvanecer", 2);
    const auto azules = [](const Imagen &im) { // del anillo
        int n = 0;
        for (int y = ROTULO; y < ALTO; ++y)
            for (int x = 0; x < ANCHO; ++x)
                n += pixel(im, x, y).b > 2 * pixel(im, x, y).r;
        return n;
    };
    EXPECT_EQ(azules(sin), 0);
    EXPECT_GT(azules(con), 10000);
    for (const double t : {0.5, 1.0, 1.5, 3.0, 5.5}) {
        const double alfa = 0.5 * (1 - std::cos(2 * PI * t / 4));
        for (const bool horas : {false, true}) {
            const Imagen im = en("desvanecer", t, horas ? CIEN_HORAS : "");
            int cambian = 0;
            double peor = 0;
            for (int y = ROTULO; y < ALTO; ++y)
                for (int x = 0; x < ANCHO; ++x) {
                    const Vec3 a = color(pixel(sin, x, y)), b = color(pixel(con, x, y));
                    peor = std::max(peor, distancia(pixel(im, x, y), (1 - alfa) * a + alfa * b));
                    cambian += oraculo::longitud(a - b) > 20;
                }
            EXPECT_GT(cambian, 10000);
            apuntaDiferencia(peor);
            EXPECT_LE(peor, 1.5) << t;
        }
    }
}

// Sin la luz queda el ambiente; lo demás es proporcional, en cada canal, a I(t)·C(t).
TEST(LucesAnimadas, ProporcionalALaLuz) {
    const auto luz = [](double t) {
        const double I = 0.5 * (1 - std::cos(2 * PI * t / 4)), f = 0.5 * (1 - std::cos(2 * PI * t / 12));
        const Vec3 calido{1, 0.6, 0.25}, frio{0.3, 0.6, 1};
        return I * ((1 - f) * calido + f * frio);
    };
    const Imagen nada = en("luces_animadas", 0), azul = en("luces_animadas", 6);
    const Vec3 maxima = luz(6);
    for (const double t : {0.5, 1.5, 2.0, 5.0, 9.0, 4.0, 13.0}) {
        const Imagen im = en("luces_animadas", t, t > 8 ? CIEN_HORAS : "");
        int alumbrados = 0;
        double peor = 0;
        for (int y = ROTULO; y < ALTO; ++y)
            for (int x = 0; x < ANCHO; ++x) {
                const Vec3 a = color(pixel(nada, x, y)), b = color(pixel(azul, x, y));
                if (std::max({b.x, b.y, b.z}) > 250)
                    continue; // recortado
                alumbrados += b.z - a.z > 50;
                for (int k = 0; k < 3; ++k) {
                    const double espera = a[k] + (b[k] - a[k]) * luz(t)[k] / maxima[k],
                                 margen = 1.1 + luz(t)[k] / maxima[k];
                    const Vec3 c = color(pixel(im, x, y));
                    if (espera < 254)
                        peor = std::max(peor, std::fabs(c[k] - espera) / margen);
                }
            }
        EXPECT_GT(alumbrados, 5000);
        apuntaDiferencia(peor);
        EXPECT_LE(peor, 1) << t;
    }
    EXPECT_TRUE(es(pixel(nada, 5, ALTO - 5), FONDO_OSCURO));
}

// La bombilla está donde la fuente y tiene el color de su luz: las dos son la misma cosa.
TEST(LucesAnimadas, LaBombillaTieneElColorDeLaLuz) {
    const auto donde =
        oraculo::proyecta(oraculo::perspectiva(oraculo::orbita(0.4, 0.42, 12, {0.1, 0.65, 0}), 0.45, 1, 50),
                          ANCHO, ALTO, {-0.1, 2.3, 1.3});
    for (const double t : {1.5, 2.0, 5.0, 6.0, 9.5}) {
        const double I = 0.5 * (1 - std::cos(2 * PI * t / 4)), f = 0.5 * (1 - std::cos(2 * PI * t / 12));
        const Vec3 espera = 255 * I * ((1 - f) * Vec3{1, 0.6, 0.25} + f * Vec3{0.3, 0.6, 1});
        const Imagen im = en("luces_animadas", t);
        for (int v = -6; v <= 6; v += 3)
            for (int u = -6; u <= 6; u += 3)
                EXPECT_LE(distancia(pixel(im, int(donde.x) + u, int(donde.y) + v), espera), 1.1) << t;
    }
    // lo más claro del suelo es lo que tiene la fuente encima, más o menos: está sobre él
    const Imagen im = en("luces_animadas", 6), nada = en("luces_animadas", 0);
    const auto pie =
        oraculo::proyecta(oraculo::perspectiva(oraculo::orbita(0.4, 0.42, 12, {0.1, 0.65, 0}), 0.45, 1, 50),
                          ANCHO, ALTO, {-0.1, 0, 1.3});
    EXPECT_GT(pixel(im, int(pie.x), int(pie.y)).b, 225);
    EXPECT_LT(pixel(nada, int(pie.x), int(pie.y)).b, 50);
}

// Con una imagen cuyo rojo es s y cuyo verde es t, el color del píxel dice qué (s, t) ha leído.
TEST(TexturaOndulada, LeeDondeDiceElSeno) {
    const int N = 256;
    const std::string fichero = (carpetaTemporal() / "ch12_st.rgb").string();
    std::ofstream f(fichero, std::ios::binary);
    for (int y = N - 1; y >= 0; --y) // la fila de arriba, primero
        for (int x = 0; x < N; ++x)
            f.put(static_cast<char>(x)).put(static_cast<char>(y)).put(0);
    f.close();
    for (const double t : {0.0, 0.5, 1.0, 2.5, 3.5, 6.0}) {
        const Imagen im = ejecuta("ch12_animacion/textura_ondulada", (t > 3 ? CIEN_HORAS : "") + instante(t),
                                  ANCHO, ALTO, {fichero, "-talla", "256x256"})
                              .imagen;
        double peor = 0;
        const double k = ALTO / 2 / 0.64;
        int mirados = 0;
        for (int y = ROTULO; y < ALTO; ++y)
            for (int x = 0; x < ANCHO; ++x) {
                const double s = (x + 0.5 - ANCHO / 2) / k + 0.5, u = (y + 0.5 - ALTO / 2) / k + 0.5;
                if (s < 0.05 || s > 0.95 || u < 0.05 || u > 0.95)
                    continue;
                const double s2 = s + 0.03 * std::sin(2 * PI * (3 * u - t / 4)),
                             u2 = u + 0.03 * std::sin(2 * PI * (3 * s - t / 4));
                const Pixel p = pixel(im, x, y);
                peor = std::max({peor, std::fabs(p.r - (256 * s2 - 0.5)), std::fabs(p.g - (256 * u2 - 0.5))});
                ++mirados;
            }
        EXPECT_GT(mirados, 30000);
        apuntaDiferencia(peor);
        EXPECT_LE(peor, 2.5) << t;
        EXPECT_TRUE(
            es(pixel(im, ANCHO / 2, int(ALTO / 2 - 0.52 * k)), FONDO_CLARO)); // el cuadrado no se deforma
    }
}

// Cada punto desplazado, calculado en double, cae dentro de la silueta, y la silueta no pasa de ellos.
TEST(RuidoVertices, SiluetaContraCPU) {
    const oraculo::Camara camara = oraculo::perspectiva(oraculo::orbita(0.3, 0.2, 10), 0.38, 1, 50);
    for (const int modo : {0, 1})
        for (const double t : {0.0, 2.5, 7.0, 19.5}) {
            const Imagen im =
                en("ruido_vertices", t,
                   std::string(t > 3 ? CIEN_HORAS : "") + "tecla " + std::to_string(modo + 1) + "; ");
            const auto pintado = [&](int x, int y) {
                const Pixel p = pixel(im, x, y);
                return modo == 0 ? p.g > p.r + 25 && p.g > p.b + 25 : p.r > p.b + 40;
            };
            int fuera = 0, x0 = ANCHO, x1 = 0, y0 = ALTO, y1 = 0;
            double a0 = ANCHO, a1 = 0, b0 = ALTO, b1 = 0;
            for (int i = 0; i < 500; ++i)
                for (int j = 1; j < 250; ++j) {
                    const double u = 2 * PI * i / 500, v = PI * j / 250;
                    const glm::dvec3 p(std::cos(u) * std::sin(v), std::sin(u) * std::sin(v), std::cos(v));
                    const auto canal = [&](double cual) {
                        return 0.5 *
                                   definicion::ruido(1.2 * p + glm::dvec3(cual, 4 * t / 5, cual), {0, 4, 0}) +
                               0.5 - (modo == 0 ? 0.5 : 0);
                    };
                    const glm::dvec3 q = p + 0.7 * glm::dvec3(canal(0), canal(11.5), canal(23.5));
                    const auto w = oraculo::proyecta(camara, ANCHO, ALTO, {q.x, q.y, q.z});
                    a0 = std::min(a0, w.x), a1 = std::max(a1, w.x), b0 = std::min(b0, w.y),
                    b1 = std::max(b1, w.y);
                    bool alguno = false; // el círculo negro, de un par de píxeles, puede taparlo
                    for (int d = -3; d <= 3; ++d)
                        alguno = alguno || pintado(int(w.x) + d, int(w.y)) || pintado(int(w.x), int(w.y) + d);
                    fuera += !alguno;
                }
            for (int y = ROTULO; y < ALTO - 30; ++y)
                for (int x = 0; x < ANCHO; ++x)
                    if (pintado(x, y))
                        x0 = std::min(x0, x), x1 = std::max(x1, x + 1), y0 = std::min(y0, y),
                        y1 = std::max(y1, y + 1);
            EXPECT_EQ(fuera, 0) << modo << " " << t;
            EXPECT_NEAR(x0, a0, 2) << modo << " " << t;
            EXPECT_NEAR(x1, a1, 2) << modo << " " << t;
            EXPECT_NEAR(y0, b0, 2) << modo << " " << t;
            EXPECT_NEAR(y1, b1, 2) << modo << " " << t;
        }
}

// Y de cerca, la luz de su normal: la del producto vectorial de las derivadas del punto desplazado, que se miden con
// diferencias. Solo de los puntos que se ven de frente.
TEST(RuidoVertices, LaNormalDeLaSuperficieDesplazada) {
    const oraculo::Camara camara = oraculo::perspectiva(oraculo::orbita(0.3, 0.2, 10), 0.38, 1, 50);
    for (const double t : {0.0, 2.5}) {
        const Imagen im = en("ruido_vertices", t);
        const auto desplazado = [&](double u, double v) {
            const glm::dvec3 p(std::cos(u) * std::sin(v), std::sin(u) * std::sin(v), std::cos(v));
            const auto canal = [&](double cual) {
                return 0.5 * definicion::ruido(1.2 * p + glm::dvec3(cual, 4 * t / 5, cual), {0, 4, 0});
            };
            return Vec3{p.x, p.y, p.z} + 0.7 * Vec3{canal(0), canal(11.5), canal(23.5)};
        };
        struct Punto {
            int x, y;
            double lejos, luz;
            bool deFrente;
        };
        std::vector<Punto> puntos;
        std::vector<double> cerca(ANCHO * ALTO, 1e9); // lo más cerca que hay algo en cada píxel o a su lado
        for (int i = 0; i < 500; ++i)
            for (int j = 1; j < 250; ++j) {
                const double u = 2 * PI * i / 500, v = PI * j / 250, h = 1e-4;
                const Vec3 q = desplazado(u, v),
                           n = oraculo::unitario(
                               oraculo::vectorial(desplazado(u, v + h) - desplazado(u, v - h),
                                                  desplazado(u + h, v) - desplazado(u - h, v))),
                           haciaOjo = camara.ojo - q, w = oraculo::proyecta(camara, ANCHO, ALTO, q);
                puntos.push_back({int(w.x), int(w.y), oraculo::longitud(haciaOjo),
                                  0.58 + 0.42 * oraculo::escalar(n, {0.20, 0.78, 0.593}),
                                  oraculo::escalar(n, oraculo::unitario(haciaOjo)) > 0.5});
                const Punto &p = puntos.back();
                for (int k = 0; k < 9; ++k) {
                    double &d = cerca[std::size_t((p.y + k / 3 - 1) * ANCHO + p.x + k % 3 - 1)];
                    d = std::min(d, p.lejos);
                }
            }
        int mirados = 0, mal = 0;
        for (const Punto &p : puntos) {
            const Pixel c = pixel(im, p.x, p.y);
            if (!p.deFrente || p.lejos > cerca[std::size_t(p.y * ANCHO + p.x)] + 0.05 || c.g < 2 * c.b)
                continue; // de canto, tapado por otro o por el círculo
            ++mirados;
            mal += std::fabs(c.g - 255 * p.luz * double(VERDE.g)) > 3;
        }
        EXPECT_GT(mirados, 20000);
        EXPECT_LE(mal, mirados / 50) << t; // la malla tiene 120 segmentos
    }
}

// Con v, el centrado a la izquierda y el del listado a la derecha; más o menos amplitud, y el rótulo lo dice.
TEST(RuidoVertices, LosDosYLaAmplitud) {
    const auto cuenta = [](const Imagen &im, bool verde, int desde, int hasta) {
        int n = 0;
        for (int y = ROTULO; y < ALTO; ++y)
            for (int x = desde; x < hasta; ++x) {
                const Pixel p = pixel(im, x, y);
                n += verde ? p.g > p.r + 25 && p.g > p.b + 25 : p.r > p.b + 40;
            }
        return n;
    };
    const Imagen im = en("ruido_vertices", 2.5, "tecla v; ");
    for (const bool verde : {true, false}) {
        EXPECT_EQ(cuenta(im, verde, verde ? ANCHO / 2 : 0, verde ? ANCHO : ANCHO / 2), 0);
        EXPECT_GT(cuenta(im, verde, verde ? 0 : ANCHO / 2, verde ? ANCHO / 2 : ANCHO), 8000);
    }
    EXPECT_TRUE(seLee(im, "centrado", OSCURO, ANCHO / 4, 0.95 * ALTO, 5));
    EXPECT_TRUE(seLee(im, "listado 12.1", OSCURO, 3 * ANCHO / 4, 0.95 * ALTO, 5));

    const Imagen menos = en("ruido_vertices", 2.5, "tecla -; tecla -; tecla -; "),
                 mas = en("ruido_vertices", 2.5, "tecla +; tecla +; tecla +; ");
    EXPECT_FALSE(leeRotulo(menos, "t = 2.50 s, S2 = 0.4", OSCURO).empty());
    EXPECT_FALSE(leeRotulo(mas, "t = 2.50 s, S2 = 0.8", OSCURO).empty()); // la máxima
}

// Cuántas marcas de su color hay en cada fila: los disparos de cada temporizador.
TEST(Temporizador, DisparosDeCadaUno) {
    const auto marcas = [](const std::string &guion) {
        const Imagen im = ejecuta("ch12_animacion/temporizador", guion, 960, 720).imagen;
        const glm::vec3 colores[] = {ROJO, VERDE, AZUL};
        std::vector<int> n;
        for (int i = 0; i < 3; ++i) {
            const int y = int(360 + 360 * (0.6 - 0.55 * i)) + 6; // por encima de la línea gris
            int cuantas = 0;
            bool antes = false;
            for (int x = 480 - 160; x < 960; ++x) { // a la derecha de los números
                const bool ahora = es(pixel(im, x, y), colores[i]);
                cuantas += ahora && !antes;
                antes = ahora;
            }
            n.push_back(cuantas);
        }
        return n;
    };
    const Imagen final = ejecuta("ch12_animacion/temporizador", "espera 2500", ANCHO, ALTO).imagen;
    const struct {
        const char *disparos, *periodo;
        glm::vec3 color;
    } FILAS[] = {{"10", "250 ms", ROJO}, {"6", "400 ms", VERDE}, {"2", "1000 ms", AZUL}};
    for (int i = 0; i < 3; ++i) {
        const double y = 180 + 180 * (0.6 - 0.55 * i);
        EXPECT_TRUE(seLee(final, FILAS[i].disparos, FILAS[i].color, 240 - 0.88 * 180, y + 0.04 * 180, 25))
            << i;
        EXPECT_TRUE(seLee(final, FILAS[i].periodo, OSCURO, 240 - 0.88 * 180, y - 0.17 * 180, 25)) << i;
    }
    using V = std::vector<int>;
    EXPECT_EQ(marcas(""), (V{0, 0, 0}));
    EXPECT_EQ(marcas("espera 1000"), (V{4, 2, 1}));
    EXPECT_EQ(marcas("espera 2500"), (V{10, 6, 2}));
    EXPECT_EQ(marcas("espera 4000"), (V{13, 8, 4})); // los tres últimos segundos: de 1 a 4, incluidos
    EXPECT_EQ(marcas("espera 1000; tecla Espacio; espera 3000"), (V{4, 2, 1}));
    EXPECT_EQ(marcas("espera 1100; tecla Espacio; espera 3330; tecla Espacio; espera 1400"), (V{10, 6, 2}));
}

// El color del punto de la esfera o del anillo que ve cada rayo, con la textura hecha otra vez según la definición del ruido: tras un
// periodo entero, el mismo. Entre roca y lava el color cambia hasta 4 niveles por cada uno de la textura, y las caras corren el punto
// hasta medio píxel.
TEST(Textura3dAnimada, ElRuidoEnCadaPuntoYPeriodica) {
    const oraculo::Camara camara = oraculo::perspectiva(oraculo::orbita(0.4, 0.4, 9.5), 0.4, 1, 50);
    const oraculo::ImagenRef ref = oraculo::render(
        {oraculo::esfera(oraculo::escala(1.0)), oraculo::toro(oraculo::gira({1, 0, 0}, 1.3), 1.7, 0.22)},
        camara, ANCHO, ALTO, [](const oraculo::Impacto &) { return Vec3{}; });
    std::vector<unsigned char> texels;
    for (int i = 0; i < 64 * 64 * 64; ++i) {
        const glm::dvec3 texel(i % 64 + 0.5, i / 64 % 64 + 0.5, i / 4096 + 0.5);
        const double v = 0.5 + 0.5 * definicion::turbulencia(texel / 16.0, 3, glm::ivec3(4));
        texels.push_back(static_cast<unsigned char>(std::lround(255 * std::min(1.0, std::max(0.0, v)))));
    }
    const Imagen inicio = en("textura3d_animada", 0);
    EXPECT_EQ(color(pixel(inicio, 240, 180)).x, color(pixel(en("textura3d_animada", 4), 240, 180)).x);
    for (const double t : {0.0, 1.0, 4.5, 13.0}) {
        const Imagen im = en("textura3d_animada", t, t > 4 ? CIEN_HORAS : "");
        double suma = 0, peor = 0;
        int n = 0;
        for (int y = ROTULO; y < ALTO; ++y)
            for (int x = 0; x < ANCHO; ++x) {
                const oraculo::PixelRef &i = ref.en(x, y);
                if (i.objeto < 0 || oraculo::enBanda(ref, x, y) ||
                    oraculo::escalar(i.normal, oraculo::unitario(camara.ojo - i.punto)) < 0.3)
                    continue;
                const glm::dvec3 p =
                    0.4 * glm::dvec3(i.punto.x, i.punto.y, i.punto.z) - glm::dvec3(0, t / 4, 0);
                const double v = definicion::trilineal(texels, p),
                             u = std::min(1.0, std::max(0.0, (v - 0.40) / 0.35)), calor = u * u * (3 - 2 * u),
                             luz = 0.58 + 0.42 * (0.20 * i.normal.x + 0.78 * i.normal.y + 0.593 * i.normal.z);
                const Vec3 roca = luz * Vec3{0.26, 0.20, 0.19},
                           lava = (1 - calor) * Vec3{0.85, 0.15, 0.02} + calor * Vec3{1, 0.85, 0.30};
                const double d = distancia(pixel(im, x, y), 255 * ((1 - calor) * roca + calor * lava));
                suma += d;
                peor = std::max(peor, d);
                ++n;
            }
        EXPECT_GT(n, 20000);
        apuntaDiferencia(peor);
        EXPECT_LE(suma / n, 1) << t;
        EXPECT_LE(peor, 8) << t;
    }
}
