// Comprobaciones independientes del capítulo 6. El color esperado se calcula aquí, en doble precisión: qué
// (s, t) ve cada píxel, trazando su rayo con el oráculo, y qué da ahí la textura según la especificación de
// OpenGL.
#include "colores.h"
#include "ejecuta.h"
#include "oraculo/oraculo.h"
#include "rotulos.h"
#include "rutas.h"
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>

namespace fs = std::filesystem;
using oraculo::PI;
using oraculo::Vec3;

namespace {

const std::string TEXTURA_OBJETO = "ch06_texturas/textura_objeto", REPETICION = "ch06_texturas/repeticion",
                  FILTRADO = "ch06_texturas/filtrado", COORDENADAS = "ch06_texturas/coordenadas",
                  MULTITEXTURA = "ch06_texturas/multitextura";

// --- Texturas de prueba ---

using Texel = std::function<Pixel(int x, int y)>; // y desde abajo, como t

Imagen imagen(int ancho, int alto, const Texel &texel) {
    Imagen i{ancho, alto, {}};
    for (int y = 0; y < alto; ++y)
        for (int x = 0; x < ancho; ++x) {
            const Pixel p = texel(x, y);
            for (const int k : {p.r, p.g, p.b})
                i.rgb.push_back(static_cast<unsigned char>(k));
        }
    return i;
}
/// Colores que no se parecen entre vecinos.
Pixel alAzar(int x, int y) {
    const unsigned h =
        (static_cast<unsigned>(x) * 2654435761u ^ static_cast<unsigned>(y) * 2246822519u) * 3266489917u;
    return {static_cast<int>(h >> 24), static_cast<int>(h >> 16 & 255), static_cast<int>(h >> 8 & 255)};
}
/// El fichero sin cabecera, escrito sin pasar por common/: la fila de arriba, primero.
std::string escribeRgb(const fs::path &ruta, const Imagen &i) {
    fs::create_directories(ruta.parent_path());
    std::ofstream f(ruta, std::ios::binary);
    for (int y = i.alto - 1; y >= 0; --y)
        f.write(reinterpret_cast<const char *>(&i.rgb[static_cast<std::size_t>(3 * i.ancho * y)]),
                3 * i.ancho);
    return ruta.string();
}
std::vector<std::string> argumentos(const Imagen &i) {
    static int n = 0;
    return {escribeRgb(carpetaTemporal() / ("ch06_" + std::to_string(++n) + ".rgb"), i), "-talla",
            std::to_string(i.ancho) + "x" + std::to_string(i.alto)};
}

// --- Muestreo, según la especificación de OpenGL 3.1 (§3.8.7 y §3.8.8), en niveles de 0 a 255 ---

int resto(int i, int n) {
    return ((i % n) + n) % n;
}
int texelDe(int i, int n, bool repite) {
    return repite ? resto(i, n) : std::min(std::max(i, 0), n - 1);
}
Vec3 texel(const Imagen &im, int i, int j, bool repiteS, bool repiteT) {
    const Pixel p = pixel(im, texelDe(i, im.ancho, repiteS), texelDe(j, im.alto, repiteT));
    return {double(p.r), double(p.g), double(p.b)};
}
Vec3 bilineal(const Imagen &im, double s, double t, bool repiteS = true, bool repiteT = true) {
    const double u = s * im.ancho - 0.5, v = t * im.alto - 0.5, i = std::floor(u), j = std::floor(v),
                 a = u - i, b = v - j;
    const int I = static_cast<int>(i), J = static_cast<int>(j);
    return (1 - a) * (1 - b) * texel(im, I, J, repiteS, repiteT) +
           a * (1 - b) * texel(im, I + 1, J, repiteS, repiteT) +
           (1 - a) * b * texel(im, I, J + 1, repiteS, repiteT) +
           a * b * texel(im, I + 1, J + 1, repiteS, repiteT);
}
Vec3 vecino(const Imagen &im, double s, double t) {
    return texel(im, static_cast<int>(std::floor(s * im.ancho)), static_cast<int>(std::floor(t * im.alto)),
                 true, true);
}

// --- Lo que va por encima de la textura: rótulos y trazos ---

/// De un rótulo (tinta o halo), una flecha o un punto.
bool deMarca(const Pixel &p) {
    return esColor(p, OSCURO) || esColor(p, BLANCO) || esColor(p, ROJO) || esColor(p, VERDE);
}
/// Centro, en píxeles, del rótulo de una línea y letra de un píxel por cuadrado que hay en la parte de la imagen que va de
/// (x0, y0) a (x1, y1); (−1, −1) si no está.
oraculo::Vec2 rotulo(const Imagen &im, const std::u32string &texto, const glm::vec3 &color, int x0 = 0,
                     int y0 = 0, int x1 = 100000, int y1 = 100000) {
    for (const Rotulo &r : buscaRotulo(im, texto, color, 1))
        if (r.x0 >= x0 && r.y0 >= y0 && r.x1 < x1 && r.y1 < y1)
            return {r.x, r.y};
    return {-1, -1};
}
bool hay(const oraculo::Vec2 &rotulo) {
    return rotulo.x >= 0;
}

double distancia(const Pixel &p, const Vec3 &c) {
    return std::max({std::fabs(p.r - c.x), std::fabs(p.g - c.y), std::fabs(p.b - c.z)});
}
bool iguales(const Pixel &a, const Pixel &b) {
    return a.r == b.r && a.g == b.g && a.b == b.b;
}

/// (s, t) que ve el punto (x, y) de la ventana.
struct Coordenadas {
    bool hay = false;
    double s = 0, t = 0;
    int cara = 0;
};
using Ve = std::function<Coordenadas(double x, double y)>;

/// Cota superior del ρ de la especificación, en texels por píxel: con ρ < 1 el filtro es el de ampliación,
/// aunque el controlador lo aproxime. Infinito si a un lado hay otra cosa.
double texelsPorPixel(const Ve &ve, int x, int y, int ancho, int alto) {
    const Coordenadas c = ve(x + 0.5, y + 0.5);
    double suma = 0;
    for (const int d : {-1, 1})
        for (const bool enX : {true, false}) {
            const Coordenadas v = ve(x + 0.5 + (enX ? d : 0), y + 0.5 + (enX ? 0 : d));
            if (!c.hay || !v.hay || c.cara != v.cara)
                return 1e9;
            suma += std::fabs(v.s - c.s) * ancho + std::fabs(v.t - c.t) * alto;
        }
    return suma / 2;
}

} // namespace

// --- textura_objeto ---

// Cada píxel interior donde la textura se amplía: bilineal exacto por Phong, sobre el toro exacto. La textura mide
// 5 × 3: sus filas no llegan a un múltiplo de 4 bytes, y sin GL_UNPACK_ALIGNMENT las de arriba saldrían torcidas. 2
// niveles: el redondeo a 8 bits, el pow de la GPU y las facetas.
TEST(TexturaObjeto, TexelPorIluminacionContraElOraculo) {
    const int ancho = 240, alto = 180;
    const Imagen im = imagen(5, 3, alAzar);
    const Ejecucion e = ejecuta(TEXTURA_OBJETO, "", ancho, alto, argumentos(im));
    ASSERT_EQ(e.estado, 0) << e.errores;

    const oraculo::Camara camara = oraculo::perspectiva(oraculo::orbita(0.25, 0.45, 6), 0.47, 1, 100);
    const oraculo::Escena escena = {oraculo::toro(oraculo::gira({1, 0, 0}, -1.2), 1, 0.5)};
    const oraculo::Ejes ejes =
        oraculo::ejes(camara); // la luz va con el observador, sobre su hombro izquierdo
    const oraculo::Luz luz{camara.ojo - 5.0 * ejes.x + 2.5 * ejes.y + 3.0 * ejes.z};
    const Ve ve = [&](double x, double y) {
        const oraculo::Impacto i = oraculo::primerImpacto(escena, oraculo::rayo(camara, ancho, alto, x, y));
        return Coordenadas{bool(i), 6 * i.s, 2 * i.t};
    };
    int comparados = 0;
    double maximo = 0, suma = 0;
    for (int y = 1; y < alto - 1; y += 3)
        for (int x = 1; x < ancho - 1; x += 2) {
            if (texelsPorPixel(ve, x, y, im.ancho, im.alto) > 0.95)
                continue;
            const oraculo::Impacto i =
                oraculo::primerImpacto(escena, oraculo::rayo(camara, ancho, alto, x + 0.5, y + 0.5));
            const Vec3 tinte = 1 / 255.0 * bilineal(im, 6 * i.s, 2 * i.t);
            const oraculo::Material m{0.22 * tinte, 0.85 * tinte, {0.45, 0.45, 0.45}, 40};
            const Vec3 color = oraculo::phong(m, {1, 1, 1}, {luz}, i.punto, i.normal, -i.rayo.direccion);
            const double d = oraculo::diferencia(e.imagen, x, y, color);
            maximo = std::max(maximo, d);
            suma += d * d;
            ++comparados;
        }
    apuntaDiferencia(maximo, std::sqrt(suma / comparados));
    EXPECT_LE(maximo, 2);
    EXPECT_LE(std::sqrt(suma / comparados), 0.5);
    EXPECT_GT(comparados, 1800); // uno de cada seis de los 17 000 que ocupa el toro, sin los de canto
}

// Un texel: el color es el mismo en todas partes, salvo por la luz, y no hay NaN (que sería negro o blanco).
TEST(TodasLasTexturas, UnSoloTexel) {
    const std::string ppm = (carpetaTemporal() / "ch06_1x1.ppm").string();
    guardaPpm(ppm, imagen(1, 1, [](int, int) { return Pixel{200, 100, 50}; }));
    for (const std::string &programa : {TEXTURA_OBJETO, REPETICION, FILTRADO, COORDENADAS}) {
        const Ejecucion e = ejecuta(programa, "", 120, 90, {ppm});
        ASSERT_EQ(e.estado, 0) << programa << ": " << e.errores;
        const bool sinLuz = programa == REPETICION || programa == FILTRADO;
        EXPECT_EQ(iguales(pixel(e.imagen, 60, 10), {200, 100, 50}), sinLuz) << programa;
        int conTinte = 0;
        for (int y = 0; y < 90; ++y)
            for (int x = 0; x < 120; ++x) {
                const Pixel q = pixel(e.imagen, x, y);
                conTinte += std::abs(q.r - 2 * q.g) <= 2 && std::abs(q.g - 2 * q.b) <= 2;
            }
        EXPECT_GT(conTinte, 120 * 90 / 8) << programa;
    }
}

// La imagen de omisión de cada programa: con todas las texturas de un color, y cada una del suyo, se ve la que es.
TEST(TodasLasTexturas, LaDeOmision) {
    const struct {
        const char *nombre;
        int lado;
        Pixel color;
    } texturas[] = {{"metal", 256, {200, 100, 50}},  {"carta", 256, {50, 200, 100}},
                    {"mosaico", 32, {100, 50, 200}}, {"baldosas", 256, {90, 90, 30}},
                    {"madera", 256, {30, 90, 90}},   {"ladrillo", 256, {90, 30, 90}},
                    {"musgo", 256, {120, 120, 120}}};
    const fs::path raiz = carpetaTemporal() / "lisas";
    for (const auto &t : texturas)
        escribeRgb(raiz / "assets" / (std::string(t.nombre) + ".rgb"),
                   imagen(t.lado, t.lado, [&](int, int) { return t.color; }));
    const ConRaiz conRaiz(raiz);
    const std::pair<std::string, Pixel> casos[] = {{TEXTURA_OBJETO, texturas[0].color},
                                                   {REPETICION, texturas[1].color},
                                                   {COORDENADAS, texturas[1].color},
                                                   {FILTRADO, texturas[2].color}};
    for (const auto &[programa, color] : casos) {
        const Ejecucion e = ejecuta(programa, "", 120, 90);
        ASSERT_EQ(e.estado, 0) << programa << ": " << e.errores;
        int conTinte = 0; // del color, más o menos iluminado
        for (int y = 0; y < 90; ++y)
            for (int x = 0; x < 120; ++x) {
                const Pixel p = pixel(e.imagen, x, y);
                conTinte += std::abs(p.r * color.g - p.g * color.r) <= 400 &&
                            std::abs(p.r * color.b - p.b * color.r) <= 400;
            }
        EXPECT_GT(conTinte, 120 * 90 / 8) << programa;
    }
}

// --- Argumentos ---

TEST(Argumentos, UnPpmYUnRgbIgualesDanLaMismaImagen) {
    const Imagen im = imagen(7, 5, alAzar);
    const std::string ppm = (carpetaTemporal() / "ch06.ppm").string();
    guardaPpm(ppm, im);
    const Ejecucion a = ejecuta(TEXTURA_OBJETO, "", 60, 45, argumentos(im)),
                    b = ejecuta(TEXTURA_OBJETO, "", 60, 45, {ppm}), sin = ejecuta(TEXTURA_OBJETO, "", 60, 45);
    EXPECT_EQ(a.estado, 0) << a.errores;
    EXPECT_EQ(b.estado, 0) << b.errores;
    EXPECT_EQ(a.imagen.rgb, b.imagen.rgb);
    EXPECT_NE(a.imagen.rgb, sin.imagen.rgb);
}

TEST(Argumentos, UnaLineaQueDiceQuePasa) {
    const std::string f = argumentos(imagen(7, 5, alAzar))[0],
                      larga = argumentos(imagen(32768, 1, alAzar))[0];
    const struct {
        std::vector<std::string> argumentos;
        int estado;
        std::string mensaje;
    } casos[] = {
        {{"no_esta.ppm"}, 1, "no puedo leer «no_esta.ppm»: "},
        {{"no_esta.rgb", "-talla", "7x5"}, 1, "no puedo leer «no_esta.rgb»: "},
        {{f, "-talla", "7x6"}, 1, "una imagen RGB de 7×6 ocupa 126 bytes y hay 105"},
        {{f, "-talla", "7x4"}, 1, "una imagen RGB de 7×4 ocupa 84 bytes y hay 105"},
        {{f, "-talla", "99999x1"}, 1, "no hay texturas de 99999×1"},
        {{larga, "-talla", "32768x1"}, 1, "una textura de 32768×1 es demasiado grande"},
        {{f}, 2, "de un fichero RGB sin cabecera hay que decir -talla ANCHOxALTO"},
        {{f, "-talla"}, 2, "detrás de -talla va el tamaño, ANCHOxALTO"},
        {{f, "-talla", "7"}, 2, "«7» no es un tamaño ANCHOxALTO"},
        {{f, "-talla", "7x"}, 2, "«7x» no es un tamaño ANCHOxALTO"},
        {{f, "-talla", "7x5x"}, 2, "«7x5x» no es un tamaño ANCHOxALTO"},
        {{f, "-talla", "0x5"}, 2, "«0x5» no es un tamaño ANCHOxALTO"},
        {{f, "-talla", "7x999999999999"}, 2, "«7x999999999999» no es un tamaño ANCHOxALTO"},
        {{"-talla", "7x5"}, 2, "con -talla falta el fichero RGB"},
        {{"x.ppm", "-talla", "7x5"}, 2, "«x.ppm»: un PPM ya dice su tamaño, sobra -talla"},
        {{f, "x.ppm"}, 2, "sobra «x.ppm»: solo se lee una imagen"},
        {{f, "-t", "7x5"}, 2, "sobra «-t»: solo se lee una imagen"},
        {{""}, 2, "«»"},
        {{"-foto"}, 2, "sobra «-foto»: solo se lee una imagen"},
    };
    for (const auto &c : casos) {
        const Ejecucion e = ejecuta(TEXTURA_OBJETO, "", 9, 9, c.argumentos);
        EXPECT_EQ(e.estado, c.estado) << c.mensaje;
        EXPECT_NE(e.errores.find(c.mensaje), std::string::npos) << e.errores;
        EXPECT_EQ(std::count(e.errores.begin(), e.errores.end(), '\n'), 1) << e.errores;
        EXPECT_TRUE(e.imagen.rgb.empty());
    }
}

// --- repeticion ---

namespace {

/// Píxeles que mide una unidad de s y de t: 2.8125 a lo alto de una ventana de 4:3 o más ancha.
double unidadRepeticion(int ancho, int alto) {
    return std::min<double>(alto, 0.75 * ancho) / 2.8125;
}
/// (s, t) del punto (x, y) de la ventana.
Coordenadas enRepeticion(double x, double y, int ancho, int alto) {
    const double unidad = unidadRepeticion(ancho, alto);
    return {true, 0.5 + (x - 0.5 * ancho) / unidad, 0.5 + (y - 0.5 * alto) / unidad};
}
const std::u32string MODOS[4] = {U"GL_REPEAT en s, GL_CLAMP_TO_EDGE en t",
                                 U"GL_CLAMP_TO_EDGE en s, GL_REPEAT en t", U"GL_REPEAT en s y en t",
                                 U"GL_CLAMP_TO_EDGE en s y en t"};

} // namespace

// Todos los píxeles, con las cuatro repeticiones: fract o clamp de la coordenada y bilineal. 1 nivel: el
// redondeo (0.5) y el de los pesos del filtro en float. Arriba, el rótulo dice cuál es.
TEST(Repeticion, FractOClamp) {
    const int ancho = 240, alto = 180;
    const struct {
        int ancho, alto, tecla;
    } casos[] = {{5, 3, 1}, {5, 3, 2}, {5, 3, 3}, {5, 3, 4}, {1, 17, 3}, {17, 1, 4}};
    for (const auto &caso : casos) {
        const Imagen im = imagen(caso.ancho, caso.alto, alAzar);
        const bool repiteS = caso.tecla == 1 || caso.tecla == 3, repiteT = caso.tecla == 2 || caso.tecla == 3;
        const Ejecucion e =
            ejecuta(REPETICION, "tecla " + std::to_string(caso.tecla), ancho, alto, argumentos(im));
        ASSERT_EQ(e.estado, 0) << e.errores;
        int comparados = 0;
        double maximo = 0;
        for (int y = 0; y < alto * 8 / 9; ++y)
            for (int x = 0; x < ancho; ++x) {
                const Coordenadas c = enRepeticion(x + 0.5, y + 0.5, ancho, alto);
                if (deMarca(pixel(e.imagen, x, y)))
                    continue;
                maximo = std::max(maximo,
                                  distancia(pixel(e.imagen, x, y), bilineal(im, c.s, c.t, repiteS, repiteT)));
                ++comparados;
            }
        apuntaDiferencia(maximo);
        EXPECT_LE(maximo, 1) << caso.ancho << "×" << caso.alto << ", tecla " << caso.tecla;
        EXPECT_GT(comparados, ancho * alto * 8 / 9 * 95 / 100);
        for (int modo = 0; modo < 4; ++modo)
            EXPECT_EQ(hay(rotulo(e.imagen, MODOS[modo], OSCURO, 0, alto * 8 / 9)), modo == caso.tecla - 1)
                << modo;
    }
}

// El marco pasa por s = 0, s = 1, t = 0 y t = 1, y junto a sus esquinas están los rótulos que lo dicen.
TEST(Repeticion, ElMarcoVaDe0A1) {
    const int ancho = 240, alto = 180;
    const Ejecucion e = ejecuta(REPETICION, "", ancho, alto, argumentos(imagen(3, 3, [](int, int) {
                                    return Pixel{200, 100, 50};
                                })));
    for (int y = 0; y < alto * 8 / 9; ++y)
        for (int x = 0; x < ancho; ++x) {
            const Coordenadas c = enRepeticion(x + 0.5, y + 0.5, ancho, alto);
            const double ds = std::fabs(c.s - 0.5), dt = std::fabs(c.t - 0.5);
            const double fuera = 64 * std::max(ds, dt) - 32; // en píxeles
            if (std::fabs(fuera) < 0.6 && ds != dt) {        // las esquinas van achaflanadas
                EXPECT_TRUE(esColor(pixel(e.imagen, x, y), OSCURO)) << x << "," << y;
            } else if (fuera < -1 || (fuera > 1 && c.s > 0.1 && c.s < 0.7)) { // ahí no hay rótulos
                EXPECT_TRUE(iguales(pixel(e.imagen, x, y), {200, 100, 50})) << x << "," << y;
            }
        }
    const struct {
        std::u32string texto;
        double s, t;
    } rotulos[] = {{U"0", 0, 0}, {U"s=1", 1, 0}, {U"t=1", 0, 1}};
    for (const auto &r : rotulos) {
        const oraculo::Vec2 p = rotulo(e.imagen, r.texto, OSCURO);
        ASSERT_TRUE(hay(p));
        const Coordenadas c = enRepeticion(p.x, p.y, ancho, alto);
        EXPECT_LT(std::hypot(c.s - r.s, c.t - r.t), 0.3);
    }
}

// Una fotografía de 250 × 190, ampliada (256 píxeles). Son 750 bytes por fila: con GL_UNPACK_ALIGNMENT de 4,
// cada fila se torcería dos tercios de texel más.
TEST(Repeticion, UnAnchoQueNoEsMultiploDe4NoSeTuerce) {
    const int ancho = 960, alto = 720;
    const Imagen im = imagen(250, 190, alAzar);
    const Ejecucion e = ejecuta(REPETICION, "tecla 3", ancho, alto, argumentos(im));
    ASSERT_EQ(e.estado, 0) << e.errores;
    double maximo = 0;
    for (int y = 0; y < alto * 8 / 9; ++y)
        for (int x = 0; x < ancho; ++x) {
            const Coordenadas c = enRepeticion(x + 0.5, y + 0.5, ancho, alto);
            if (!deMarca(pixel(e.imagen, x, y)))
                maximo = std::max(maximo, distancia(pixel(e.imagen, x, y), bilineal(im, c.s, c.t)));
        }
    EXPECT_LE(maximo, 1);
}

// En una ventana de 201 × 135 el cuadrado [0, 1]² mide 48 píxeles y el centro de cada uno de los 4 × 8 texels
// cae en el centro de un píxel: ahí no hay nada que interpolar y el color es el del texel, exacto.
TEST(Repeticion, ElCentroDeUnTexelEsExacto) {
    const Imagen im = imagen(4, 8, alAzar);
    for (const char *tecla : {"tecla 3", "tecla 4"}) {
        const Ejecucion e = ejecuta(REPETICION, tecla, 201, 135, argumentos(im));
        ASSERT_EQ(e.estado, 0) << e.errores;
        for (int j = 0; j < 8; ++j)
            for (int i = 0; i < 4; ++i) // la esquina está en (76.5, 43.5)
                EXPECT_TRUE(iguales(pixel(e.imagen, 82 + 12 * i, 46 + 6 * j), pixel(im, i, j)))
                    << tecla << ", texel " << i << "," << j;
    }
}

// En una ventana tres veces más larga se ve más textura, no una textura deformada.
TEST(Repeticion, LaVentanaNoDeforma) {
    const Imagen im = imagen(5, 3, alAzar);
    for (const auto &[ancho, alto] : {std::pair(270, 90), {90, 270}}) {
        const Ejecucion e = ejecuta(REPETICION, "tecla 3", ancho, alto, argumentos(im));
        ASSERT_EQ(e.estado, 0) << e.errores;
        for (int y = 0; y < alto * 8 / 9; y += 7)
            for (int x = 0; x < ancho; x += 7) {
                const Coordenadas c = enRepeticion(x + 0.5, y + 0.5, ancho, alto);
                if (!deMarca(pixel(e.imagen, x, y))) {
                    EXPECT_LE(distancia(pixel(e.imagen, x, y), bilineal(im, c.s, c.t)), 1) << x << "," << y;
                }
            }
    }
}

// --- filtrado ---

namespace {

const int ANCHO = 240, ALTO = 180;

/// El suelo y = 0; la textura abarca 2 unidades y crece con X y hacia −Z.
Coordenadas enSuelo(double x, double y) {
    static const oraculo::Camara camara = oraculo::perspectiva(oraculo::orbita(0.12, 0.3, 3), 0.8, 0.1, 400);
    const oraculo::Rayo r = oraculo::rayo(camara, ANCHO, ALTO, x, y);
    const double d = -r.origen.y / r.direccion.y;
    const double X = r.origen.x + d * r.direccion.x, Z = r.origen.z + d * r.direccion.z;
    return {d > 0 && std::max(std::fabs(X), std::fabs(Z)) < 100, X / 2, -Z / 2};
}

const std::u32string FILTROS[4] = {U"1 vecino", U"2 lineal", U"3 mipmap", U"4 anisótropo"};

struct PixelDePrueba {
    int x, y;
    Vec3 color;
};
double rmse(const Imagen &a, const std::vector<PixelDePrueba> &referencia) {
    double suma = 0;
    for (const auto &[x, y, c] : referencia) {
        const Pixel p = pixel(a, x, y);
        suma += ((p.r - c.x) * (p.r - c.x) + (p.g - c.y) * (p.g - c.y) + (p.b - c.z) * (p.b - c.z)) / 3;
    }
    return std::sqrt(suma / static_cast<double>(referencia.size()));
}

/// Filas, desde abajo, en que todo es suelo.
int filasDeSuelo() {
    int y = 0;
    while (enSuelo(0, y + 1).hay && enSuelo(ANCHO, y + 1).hay)
        ++y;
    return y;
}

} // namespace

// La verdad es la media de 16 × 16 muestras por píxel de la textura (bilineal). Cada filtro se le parece más
// que el anterior: medido en Mesa 22.3, 36.8, 23.0, 12.2 y 6.5 niveles. Es también lo que se exige del anisótropo, que en cada controlador es otro.
TEST(Filtrado, CadaFiltroSeAcercaMasAlSobremuestreo) {
    const Imagen im = leeTextura(recurso("assets/mosaico.rgb"), 32, 32);
    const int filas = filasDeSuelo(), N = 16;
    ASSERT_GT(filas, 140);
    std::vector<PixelDePrueba> referencia;
    for (int y = 0; y < filas; ++y)
        for (int x = y % 3; x < ANCHO; x += 3) {
            Vec3 suma;
            for (int k = 0; k < N * N; ++k) {
                const Coordenadas c = enSuelo(x + (k % N + 0.5) / N, y + (k / N + 0.5) / N);
                suma = suma + bilineal(im, c.s, c.t);
            }
            referencia.push_back({x, y, 1.0 / (N * N) * suma});
        }
    double error[4];
    for (int k = 0; k < 4; ++k) {
        const Ejecucion e = ejecuta(FILTRADO, "tecla " + std::to_string(k + 1), ANCHO, ALTO);
        ASSERT_EQ(e.estado, 0) << e.errores;
        EXPECT_EQ(e.salida, "");
        error[k] = rmse(e.imagen, referencia);
        RecordProperty("rmse_" + std::to_string(k + 1), std::to_string(error[k]));
        for (int otro = 0; otro < 4; ++otro)
            EXPECT_EQ(hay(rotulo(e.imagen, FILTROS[otro], OSCURO, 0, filas)), otro == k) << k << " " << otro;
    }
    EXPECT_LT(error[1], 0.8 * error[0]); // poco: cuatro texels no curan nada donde un píxel abarca cientos
    EXPECT_LT(error[2], 0.6 * error[1]);
    EXPECT_LT(error[3], 0.6 * error[2]);
}

// Cerca de la cámara, donde un texel ocupa muchos píxeles, vecino y lineal se distinguen a simple vista.
TEST(Filtrado, CercaSeDistinguenVecinoYLineal) {
    const Ejecucion v = ejecuta(FILTRADO, "tecla 1", ANCHO, ALTO),
                    l = ejecuta(FILTRADO, "tecla 2", ANCHO, ALTO);
    int distintos = 0;
    for (int y = 0; y < ALTO / 3; ++y)
        for (int x = 0; x < ANCHO; ++x) {
            const Pixel p = pixel(v.imagen, x, y), q = pixel(l.imagen, x, y);
            distintos += std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b) > 60;
        }
    EXPECT_GT(distintos, ANCHO * ALTO / 3 / 5);
}

// Con v, los cuatro a la vez, en orden y con su nombre: lo mismo que cada uno en una ventana del tamaño de su panel. Otra v, o
// una cifra, vuelve a uno solo.
TEST(Filtrado, LosCuatroALaVez) {
    const int ancho = 121,
              alto = 91; // de cada panel, con una raya de un píxel entre ellos: empiezan todos en par
    const Ejecucion todos = ejecuta(FILTRADO, "tecla 3; tecla v", 2 * ancho + 1, 2 * alto + 1);
    ASSERT_EQ(todos.estado, 0) << todos.errores;
    for (int k = 0; k < 4; ++k) {
        const int x0 = k % 2 * (ancho + 1), y0 = (1 - k / 2) * (alto + 1);
        const Ejecucion uno = ejecuta(FILTRADO, "tecla " + std::to_string(k + 1), ancho, alto);
        int distintos = 0;
        for (int y = 0; y < alto * 3 / 4; ++y)
            for (int x = 0; x < ancho; ++x)
                distintos += !iguales(pixel(todos.imagen, x0 + x, y0 + y), pixel(uno.imagen, x, y));
        EXPECT_LE(distintos, ancho * alto / 100) << k;
        EXPECT_TRUE(hay(rotulo(todos.imagen, FILTROS[k], OSCURO, x0, y0, x0 + ancho, y0 + alto))) << k;
    }
    const Ejecucion tres = ejecuta(FILTRADO, "tecla 3", 60, 45);
    EXPECT_EQ(ejecuta(FILTRADO, "tecla 3; tecla v; tecla v", 60, 45).imagen.rgb, tres.imagen.rgb);
    EXPECT_EQ(ejecuta(FILTRADO, "tecla v; tecla 3", 60, 45).imagen.rgb, tres.imagen.rgb);
    EXPECT_NE(ejecuta(FILTRADO, "tecla v; tecla x", 60, 45).imagen.rgb,
              ejecuta(FILTRADO, "", 60, 45).imagen.rgb);
}

// Vecino y lineal no miran el tamaño del píxel: en su centro, el texel más cercano o el bilineal del nivel 0.
// En los vértices s y t valen ±50 y el último bit de un float vale allí 1/8192 de texel; con ocho de esos,
// a menos de 1/1024 de texel de una frontera puede salir el vecino, y el bilineal se desvía 1/1024 del salto
// entre vecinos.
TEST(Filtrado, VecinoYLinealSonExactosEnElCentroDelPixel) {
    const Imagen im = leeTextura(recurso("assets/mosaico.rgb"), 32, 32);
    const Ejecucion v = ejecuta(FILTRADO, "tecla 1", ANCHO, ALTO),
                    l = ejecuta(FILTRADO, "tecla 2", ANCHO, ALTO);
    int total = 0, vecinos = 0, distintos = 0, lejos = 0;
    double maximo = 0;
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < ANCHO; ++x) {
            const Coordenadas c = enSuelo(x + 0.5, y + 0.5);
            ASSERT_TRUE(c.hay);
            const double u = c.s * 32, w = c.t * 32, h = 1.0 / 1024 / 32;
            ++total;
            double salto = 0;
            for (const auto &[ds, dt] : {std::pair(h, h), {h, -h}, {-h, h}, {-h, -h}}) {
                const Vec3 d = bilineal(im, c.s + ds, c.t + dt) - bilineal(im, c.s, c.t);
                salto = std::max({salto, std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
            }
            const double error = distancia(pixel(l.imagen, x, y), bilineal(im, c.s, c.t));
            lejos += error > 1 + salto;
            maximo = std::max(maximo, error);
            if (std::min(std::fabs(u - std::round(u)), std::fabs(w - std::round(w))) < 1.0 / 1024)
                continue;
            distintos += distancia(pixel(v.imagen, x, y), vecino(im, c.s, c.t)) != 0;
            ++vecinos;
        }
    apuntaDiferencia(distintos ? 255 : 0);
    RecordProperty("lineal_maximo", std::to_string(maximo));
    EXPECT_EQ(distintos, 0) << "de " << vecinos;
    EXPECT_EQ(lejos, 0);
    EXPECT_GT(vecinos, total * 95 / 100);
}

// Sin la extensión lo dice en stdout, y la tecla 4 hace lo que la 3.
TEST(Filtrado, SinAnisotropia) {
    const Ejecucion con3 = ejecuta(FILTRADO, "tecla 3", 60, 45), con4 = ejecuta(FILTRADO, "tecla 4", 60, 45);
    setenv("MESA_EXTENSION_OVERRIDE", "-GL_EXT_texture_filter_anisotropic", 1);
    const Ejecucion sin3 = ejecuta(FILTRADO, "tecla 3", 60, 45), sin4 = ejecuta(FILTRADO, "tecla 4", 60, 45);
    unsetenv("MESA_EXTENSION_OVERRIDE");
    EXPECT_EQ(sin4.estado, 0) << sin4.errores;
    EXPECT_NE(sin4.salida.find("no tiene GL_EXT_texture_filter_anisotropic"), std::string::npos)
        << sin4.salida;
    const auto suelo = [](const Ejecucion &e) { // sin el rótulo, que está en el cielo
        return std::vector<unsigned char>(e.imagen.rgb.begin(), e.imagen.rgb.begin() + 3 * 60 * 30);
    };
    EXPECT_EQ(suelo(sin3), suelo(sin4));
    EXPECT_EQ(suelo(sin3), suelo(con3));
    EXPECT_NE(suelo(con3), suelo(con4));
    EXPECT_EQ(con4.salida, "");
}

// --- coordenadas ---

namespace {

/// Fórmulas de la parametrización, en coordenadas del objeto: p es un punto suyo y n su normal.
Coordenadas parametriza(int objeto, const Vec3 &p, const Vec3 &n) {
    const double angulo = std::atan2(p.y, p.x) / (2 * PI), s = angulo < 0 ? angulo + 1 : angulo;
    if (objeto == 3)
        return {true, s, std::acos(std::clamp(-p.z, -1.0, 1.0)) / PI};
    if (objeto == 2)
        return std::fabs(n.z) > 0.5 ? Coordenadas{true, 0.5 + p.x / 2, 0.5 + p.y / 2}
                                    : Coordenadas{true, s, p.z + 0.5};
    // las seis caras del cubo, una a una, como las ve quien las tiene delante con Y hacia arriba
    if (n.z > 0.5)
        return {true, 0.5 + p.x, 0.5 + p.y};
    if (n.z < -0.5)
        return {true, 0.5 - p.x, 0.5 + p.y};
    if (n.x > 0.5)
        return {true, 0.5 - p.z, 0.5 + p.y};
    if (n.x < -0.5)
        return {true, 0.5 + p.z, 0.5 + p.y};
    if (n.y > 0.5)
        return {true, 0.5 + p.x, 0.5 - p.z};
    return {true, 0.5 + p.x, 0.5 + p.z};
}

} // namespace

/// El panel de la derecha de la imagen, los dos tercios de su ancho, con el objeto; su lado menor abarca el ángulo.
const int ANCHO_OBJETO = ANCHO - ANCHO / 3;

oraculo::Camara camaraObjeto(int dx, int dy) {
    const double angulo =
        2 * std::atan(0.75 * std::tan(0.25)); // el de ¾ del lado menor, como dice el oráculo
    return oraculo::perspectiva(oraculo::orbita(0.6 - 0.01 * dx, 0.45 - 0.01 * dy, 5.6), angulo, 1, 100);
}
oraculo::Objeto objeto(int cual) {
    const oraculo::Mat4 depie = oraculo::gira({0, 1, 0}, -1.45) * oraculo::gira({1, 0, 0}, -PI / 2);
    return cual == 1   ? oraculo::caja(oraculo::escala(1.65))
           : cual == 2 ? oraculo::cilindro(depie * oraculo::escala({0.95, 0.95, 1.9}))
                       : oraculo::esfera(depie * oraculo::escala(1.35));
}
/// Arrastrar 1 píxel gira 0.01 rad: la derecha disminuye el azimut, y abajo aumenta la elevación.
std::string arrastra(int cual, int dx, int dy) {
    return "tecla " + std::to_string(cual) + "; boton IZQUIERDO abajo 0 0; arrastra " + std::to_string(dx) +
           " " + std::to_string(-dy);
}
/// El punto del objeto con esas coordenadas, según la parametrización; en el cubo, el de la cara +Z.
Vec3 conCoordenadas(int cual, double s, double t) {
    const double a = 2 * PI * s, latitud = PI * (t - 0.5);
    return cual == 1 ? Vec3{s - 0.5, t - 0.5, 0.5}
           : cual == 2
               ? Vec3{std::cos(a), std::sin(a), t - 0.5}
               : Vec3{std::cos(latitud) * std::cos(a), std::cos(latitud) * std::sin(a), std::sin(latitud)};
}

// Con una textura cuyo rojo es s, cuyo verde es t y cuyo azul es 255, la luz multiplica los tres por igual: el azul es la
// luz fija del capítulo 3, y s y t salen de rojo/azul y verde/azul. Contra la parametrización exacta (esfera y
// cilindro sin facetas), desde arriba y, por detrás, desde abajo.
TEST(Coordenadas, SeLeenEnLaImagenLasDeLaParametrizacion) {
    const std::vector<std::string> args = argumentos(imagen(256, 256, [](int x, int y) {
        return Pixel{x, y, 255};
    }));
    for (int cual = 1; cual <= 3; ++cual)
        for (const auto &[dx, dy] : {std::pair(0, 0), {314, 90}}) {
            const Ejecucion e = ejecuta(COORDENADAS, arrastra(cual, dx, dy), ANCHO, ALTO, args);
            ASSERT_EQ(e.estado, 0) << e.errores;

            const oraculo::Camara camara = camaraObjeto(dx, dy);
            const oraculo::Escena escena = {objeto(cual)};
            double luz = 0; // la del último punto visto
            const Ve ve = [&](double x, double y) {
                const oraculo::Impacto i =
                    oraculo::primerImpacto(escena, oraculo::rayo(camara, ANCHO_OBJETO, ALTO, x, y));
                if (!i)
                    return Coordenadas{};
                luz = 0.58 + 0.42 * oraculo::escalar(i.normal, {0.20, 0.78, 0.593});
                oraculo::Impacto enObjeto;
                enObjeto.corte = i.corte;
                const Vec3 p = oraculo::punto(escena[0].inv, i.punto);
                oraculo::superficie(escena[0], p, enObjeto);
                Coordenadas c = parametriza(cual, p, enObjeto.normal);
                c.cara = i.corte.cara;
                return c;
            };
            int dentro = 0, comparados = 0, malos = 0, malaLuz = 0;
            for (int y = 1; y < ALTO - 1; y += 3)
                for (int x = 1; x < ANCHO_OBJETO - 1; x += 2) {
                    const Coordenadas c = ve(x + 0.5, y + 0.5);
                    const double azul = 255 * luz;
                    dentro += c.hay;
                    // junto a la costura el filtro mezcla s = 1 con s = 0; de canto o en un polo caben muchos
                    // texels
                    const double rho = c.hay ? texelsPorPixel(ve, x, y, 256, 256) : 1e9;
                    const Pixel p = pixel(e.imagen, ANCHO / 3 + x, y);
                    if (rho > 14 || std::min({c.s, 1 - c.s, c.t, 1 - c.t}) < 0.06 || deMarca(p))
                        continue;
                    malaLuz += std::fabs(p.b - azul) > 1.5;
                    apuntaDiferencia(std::fabs(p.b - azul));
                    // el valor del texel i es i, así que en s vale 256·s − 0.5, más lo que se redondean los
                    // mipmaps (2i y 2i + 1 dan 2i + 1, y así en cada nivel: 0.5). Medio nivel de redondeo en
                    // p.r y p.b se agranda al dividir por la luz, y las facetas y el float mueven el punto
                    // hasta 0.1 píxeles
                    const double cota = 0.5 + 255.0 / p.b + 0.1 * rho;
                    const double s = 255.0 * p.r / p.b, t = 255.0 * p.g / p.b;
                    malos +=
                        std::fabs(s - (256 * c.s - 0.5)) > cota || std::fabs(t - (256 * c.t - 0.5)) > cota;
                    ++comparados;
                }
            EXPECT_EQ(malos, 0) << "objeto " << cual << ", arrastre " << dx << "," << dy << ", de "
                                << comparados;
            EXPECT_EQ(malaLuz, 0) << "objeto " << cual << ", arrastre " << dx << "," << dy << ", de "
                                  << comparados;
            EXPECT_GT(comparados, dentro / 2) << "objeto " << cual << ", arrastre " << dx << "," << dy;
        }
}

// El punto P = (0.1, 0.5) y los rótulos s y t, en la dirección en que crecen, sobre la imagen y sobre el objeto; por detrás,
// ninguno en el objeto.
TEST(Coordenadas, LosMismosPuntosEnLaImagenYEnElObjeto) {
    for (int cual = 1; cual <= 3; ++cual) {
        const Ejecucion e = ejecuta(COORDENADAS, "tecla " + std::to_string(cual), ANCHO, ALTO);
        const oraculo::Camara camara = camaraObjeto(0, 0);
        const oraculo::Mat4 M = objeto(cual).M;
        const auto enObjeto = [&](double s, double t) {
            const Vec3 p = oraculo::proyecta(camara, ANCHO_OBJETO, ALTO,
                                             oraculo::punto(M, 1.01 * conCoordenadas(cual, s, t)));
            return oraculo::Vec2{ANCHO / 3 + p.x, p.y};
        };
        // el cuadrado de lado 1 en un panel de 80 × 180: 4/3 de 0.41 a cada lado del centro
        const double unidad = ANCHO / 3 / (2 * 0.41 * 4 / 3);
        const auto enImagen = [&](double s, double t) {
            return oraculo::Vec2{ANCHO / 6 + unidad * (s - 0.5), ALTO / 2 + unidad * (t - 0.5)};
        };
        const auto comprueba = [&](const char *donde, auto en, int x0, int x1) {
            const oraculo::Vec2 P = en(0.1, 0.5), s = en(0.24, 0.5), t = en(0.1, 0.8);
            int delPunto = 0; // de 3 × 3: el rótulo y las flechas pueden llevarse alguno
            for (int k = 0; k < 9; ++k)
                delPunto += esColor(
                    pixel(e.imagen, static_cast<int>(P.x) + k % 3 - 1, static_cast<int>(P.y) + k / 3 - 1),
                    OSCURO);
            EXPECT_GE(delPunto, 4) << donde << cual;
            const auto cerca = [&](const oraculo::Vec2 &r, const oraculo::Vec2 &p) {
                return hay(r) && std::hypot(r.x - p.x, r.y - p.y) < 9.5; // entra un rótulo de 5 × 7 a su lado
            };
            EXPECT_TRUE(cerca(rotulo(e.imagen, U"P", OSCURO, x0, 0, x1), P)) << donde << cual;
            EXPECT_TRUE(cerca(rotulo(e.imagen, U"s", ROJO, x0, 0, x1), s)) << donde << cual;
            EXPECT_TRUE(cerca(rotulo(e.imagen, U"t", VERDE, x0, 0, x1), t)) << donde << cual;
        };
        comprueba("imagen ", enImagen, 0, ANCHO / 3);
        comprueba("objeto ", enObjeto, ANCHO / 3, ANCHO);
        EXPECT_TRUE(hay(rotulo(e.imagen, U"s = 0.1", OSCURO, 0, 0, ANCHO / 3)));
        EXPECT_TRUE(hay(rotulo(e.imagen, U"t = 0.5", OSCURO, 0, 0, ANCHO / 3)));
        const Ejecucion detras = ejecuta(COORDENADAS, arrastra(cual, 314, 0), ANCHO, ALTO);
        for (const auto &[texto, color] : {std::pair(U"P", OSCURO), {U"s", ROJO}, {U"t", VERDE}})
            EXPECT_FALSE(hay(rotulo(detras.imagen, texto, color, ANCHO / 3))) << cual;
    }
}

// A la izquierda, la imagen entera, derecha y sin deformar, con la luz de su cara.
TEST(Coordenadas, ALaIzquierdaLaImagen) {
    const Imagen im = imagen(4, 4, alAzar);
    const Ejecucion e = ejecuta(COORDENADAS, "", ANCHO, ALTO, argumentos(im));
    const double unidad = ANCHO / 3 / (2 * 0.41 * 4 / 3), luz = 0.58 + 0.42 * 0.593;
    int comparados = 0;
    double maximo = 0;
    for (int y = 0; y < ALTO; ++y)
        for (int x = 0; x < ANCHO / 3; ++x) {
            const double s = 0.5 + (x + 0.5 - ANCHO / 6) / unidad, t = 0.5 + (y + 0.5 - ALTO / 2) / unidad;
            const Pixel p = pixel(e.imagen, x, y);
            if (deMarca(p))
                continue;
            const bool dentro = s > 0 && s < 1 && t > 0 && t < 1;
            maximo = std::max(
                maximo, distancia(p, dentro ? luz * bilineal(im, s, t)
                                            : 255.0 * Vec3{FONDO_CLARO.r, FONDO_CLARO.g, FONDO_CLARO.b}));
            ++comparados;
        }
    EXPECT_LE(maximo, 1);
    EXPECT_GT(comparados, ANCHO / 3 * ALTO * 9 / 10);
}

// --- multitextura ---

namespace {

struct Texturas {
    Imagen ladrillo, musgo, mascara, luz;
};
/// Lo que ha de verse en (s, t) de la pared.
Vec3 mezcla(const Texturas &x, double s, double t, bool conMusgo, bool conLuz) {
    Vec3 c = bilineal(x.ladrillo, 2 * s, 1.5 * t);
    if (conMusgo) {
        const double m = bilineal(x.mascara, s, t, false, false).x / 255;
        c = (1 - m) * c + m * bilineal(x.musgo, 2 * s, 1.5 * t);
    }
    return conLuz ? 1 / 255.0 * (c * bilineal(x.luz, s, t, false, false)) : c;
}
/// (s, t) de la pared de 4 × 3, vista de frente en el panel de la derecha, siete décimos del ancho.
Coordenadas enPared(double x, double y, int ancho, int alto) {
    const int columna = ancho * 3 / 10, panel = ancho - columna;
    const double unidad = panel / (2 * 5 * std::tan(0.62 / 2) * 4 / 3);
    const Coordenadas c{true, 0.5 + (x - columna - 0.5 * panel) / unidad / 4,
                        0.5 + (y - 0.5 * alto) / unidad / 3};
    return {c.s > 0 && c.s < 1 && c.t > 0 && c.t < 1, c.s, c.t};
}
void comparaPared(const Texturas &x, int ancho, int alto, int salto) {
    for (int tecla = 1; tecla <= 3; ++tecla) {
        const Ejecucion e = ejecuta(MULTITEXTURA, "tecla " + std::to_string(tecla), ancho, alto);
        ASSERT_EQ(e.estado, 0) << e.errores;
        double maximo = 0;
        int dentro = 0;
        for (int j = salto / 2; j < alto; j += salto)
            for (int i = ancho * 3 / 10 + salto / 2; i < ancho; i += salto) {
                const Coordenadas c = enPared(i + 0.5, j + 0.5, ancho, alto);
                dentro += c.hay;
                const Vec3 fondo = 255.0 * Vec3{FONDO_OSCURO.r, FONDO_OSCURO.g, FONDO_OSCURO.b};
                maximo =
                    std::max(maximo, distancia(pixel(e.imagen, i, j),
                                               c.hay ? mezcla(x, c.s, c.t, tecla != 2, tecla != 1) : fondo));
            }
        apuntaDiferencia(maximo);
        EXPECT_LE(maximo, 1) << "tecla " << tecla;
        EXPECT_GT(dentro, ancho * alto / salto / salto * 4 / 10); // la pared llena el panel
    }
}

} // namespace

// Las texturas de verdad, en una ventana tan grande que ninguna se reduce (512 texels en 629 píxeles): la
// mezcla, en la CPU, de cuatro bilineales. Cada textura está en su unidad y cada sampler2D lee la suya.
TEST(Multitextura, LaMezclaCalculadaEnLaCpu) {
    const auto lee = [](const char *nombre, int ancho, int alto) {
        return leeTextura(recurso("assets/" + std::string(nombre) + ".rgb"), ancho, alto);
    };
    comparaPared(
        {lee("ladrillo", 256, 256), lee("musgo", 256, 256), lee("mascara", 128, 96), lee("luz", 64, 48)}, 960,
        720, 5);
}

// Texturas propias, que el programa lee de $LAB_RAIZ: colores lisos y una máscara que recorre todos los
// valores, a 240 × 180. Sin detalle, los mipmaps no cambian nada y se comprueban todos los píxeles. A la izquierda,
// de arriba abajo, lo que hay en cada unidad, con su número y su nombre: en gris, lo que la mezcla no usa.
TEST(Multitextura, TodosLosValoresDeLaMascaraYLasCuatroUnidades) {
    const auto liso = [](const Pixel &p) { return [p](int, int) { return p; }; };
    const Texturas x = {imagen(256, 256, liso({230, 120, 10})), imagen(256, 256, liso({20, 180, 90})),
                        imagen(128, 96,
                               [](int i, int) {
                                   return Pixel{2 * i, 77, 200};
                               }),
                        imagen(64, 48, [](int, int j) {
                            return Pixel{255 - 5 * j, 128, 5 * j};
                        })};
    const fs::path raiz = carpetaTemporal() / "raiz_ch06";
    const std::pair<std::string, const Imagen *> unidades[] = {
        {"ladrillo", &x.ladrillo}, {"musgo", &x.musgo}, {"mascara", &x.mascara}, {"luz", &x.luz}};
    for (const auto &[nombre, im] : unidades)
        escribeRgb(raiz / "assets" / (nombre + ".rgb"), *im);
    const ConRaiz conRaiz(raiz);
    comparaPared(x, 240, 180, 1);
    for (int tecla = 1; tecla <= 3; ++tecla) {
        const Ejecucion e = ejecuta(MULTITEXTURA, "tecla " + std::to_string(tecla));
        for (int k = 0; k < 4; ++k) {
            const auto &[nombre, im] = unidades[k];
            const int x0 = 0, x1 = 72, y0 = 181 * (3 - k) / 4, y1 = 181 * (4 - k) / 4 - 1; // su panel
            const bool usada = k == 0 || (k == 3 ? tecla != 1 : tecla != 2);
            const oraculo::Vec2 unidad = rotulo(
                                    e.imagen, U"unidad " + std::u32string(1, U'0' + static_cast<char32_t>(k)),
                                    usada ? BLANCO : GRIS, x0, y0, x1, y1),
                                suNombre = rotulo(e.imagen, std::u32string(nombre.begin(), nombre.end()),
                                                  usada ? BLANCO : GRIS, x0, y0, x1, y1);
            EXPECT_TRUE(hay(unidad) && hay(suNombre) && suNombre.y < unidad.y) << tecla << nombre;
            // el centro de la mitad de arriba y el de la de abajo, donde no hay rótulo; la textura, entera, mide 56 × 42
            for (const double t : {0.08, 0.92}) {
                const int px = x1 / 4, py = static_cast<int>(0.5 * (y0 + y1) + 41.4 * (t - 0.5));
                const double s = 0.5 + (px + 0.5 - 36) / 55.3,
                             tReal = 0.5 + (py + 0.5 - 0.5 * (y0 + y1)) / 41.5;
                EXPECT_LE(distancia(pixel(e.imagen, px, py), bilineal(*im, s, tReal)), 3) << nombre << t;
            }
        }
    }
}
