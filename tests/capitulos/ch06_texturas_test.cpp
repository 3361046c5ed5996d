// Comprobaciones independientes del capítulo 6. El color esperado se calcula aquí, en doble precisión: qué
// (s, t) ve cada píxel, trazando su rayo con el oráculo, y qué da ahí la textura según la especificación de
// OpenGL.
#include "ejecuta.h"
#include "malla.h"
#include "oraculo/oraculo.h"
#include "rutas.h"
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

// Cada píxel interior donde la textura se amplía: bilineal exacto por Phong, sobre la misma malla. La textura
// mide 5 × 3: sus filas no llegan a un múltiplo de 4 bytes, y sin GL_UNPACK_ALIGNMENT las de arriba saldrían
// torcidas. 2 niveles: el redondeo a 8 bits y el pow de la GPU.
TEST(TexturaObjeto, TexelPorIluminacionContraElOraculo) {
    const int ancho = 240, alto = 180;
    const Imagen im = imagen(5, 3, alAzar);
    const Ejecucion e = ejecuta(TEXTURA_OBJETO, "", ancho, alto, argumentos(im));
    ASSERT_EQ(e.estado, 0) << e.errores;

    const oraculo::Camara camara = oraculo::perspectiva(oraculo::orbita(0.25, 0.45, 6), 0.47, 1, 100);
    const oraculo::Escena escena = {oraculo::malla(
        oraculo::gira({1, 0, 0}, -1.2), toro(1, 0.5f, segmentosPara(600, 0.25f), segmentosPara(200, 0.25f)))};
    const oraculo::Luz luz{{-3, 6, 8}};
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
    RecordProperty("maximo", std::to_string(maximo));
    RecordProperty("rmse", std::to_string(std::sqrt(suma / comparados)));
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
    const std::string f = argumentos(imagen(7, 5, alAzar))[0];
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

/// (s, t) del punto (x, y) de la ventana: el lado menor mide 2.8125.
Coordenadas enRepeticion(double x, double y, int ancho, int alto) {
    const double unidad = std::min(ancho, alto) / 2.8125;
    return {true, 0.5 + (x - 0.5 * ancho) / unidad, 0.5 + (y - 0.5 * alto) / unidad};
}
/// A menos de `margen` píxeles de uno de los cuatro lados del marco.
bool enMarco(const Coordenadas &c, double unidad, double margen) {
    const double m = margen / unidad;
    if (c.s < -m || c.s > 1 + m || c.t < -m || c.t > 1 + m)
        return false;
    return c.s < m || c.s > 1 - m || c.t < m || c.t > 1 - m;
}

} // namespace

// Todos los píxeles, con las cuatro repeticiones: fract o clamp de la coordenada y bilineal. 1 nivel: el
// redondeo (0.5) y el de los pesos del filtro en float.
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
        for (int y = 0; y < alto; ++y)
            for (int x = 0; x < ancho; ++x) {
                const Coordenadas c = enRepeticion(x + 0.5, y + 0.5, ancho, alto);
                if (enMarco(c, alto / 2.8125, 2.5))
                    continue;
                maximo = std::max(maximo,
                                  distancia(pixel(e.imagen, x, y), bilineal(im, c.s, c.t, repiteS, repiteT)));
                ++comparados;
            }
        EXPECT_LE(maximo, 1) << caso.ancho << "×" << caso.alto << ", tecla " << caso.tecla;
        EXPECT_GT(comparados, ancho * alto * 9 / 10);
    }
}

// Una fotografía de 250 × 190, ampliada (256 píxeles). Son 750 bytes por fila: con GL_UNPACK_ALIGNMENT de 4,
// cada fila se torcería dos tercios de texel más.
TEST(Repeticion, UnAnchoQueNoEsMultiploDe4NoSeTuerce) {
    const int lado = 720;
    const Imagen im = imagen(250, 190, alAzar);
    const Ejecucion e = ejecuta(REPETICION, "tecla 3", lado, lado, argumentos(im));
    ASSERT_EQ(e.estado, 0) << e.errores;
    double maximo = 0;
    for (int y = 0; y < lado; ++y)
        for (int x = 0; x < lado; ++x) {
            const Coordenadas c = enRepeticion(x + 0.5, y + 0.5, lado, lado);
            if (!enMarco(c, lado / 2.8125, 5))
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
        for (int y = 0; y < alto; y += 7)
            for (int x = 0; x < ancho; x += 7) {
                const Coordenadas c = enRepeticion(x + 0.5, y + 0.5, ancho, alto);
                const double unidad = std::min(ancho, alto) / 2.8125;
                if (!enMarco(c, unidad, 3)) {
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
    static const oraculo::Camara camara =
        oraculo::perspectiva(oraculo::orbita(0.12, 0.27, 3.6), 0.8, 0.1, 400);
    const oraculo::Rayo r = oraculo::rayo(camara, ANCHO, ALTO, x, y);
    const double d = -r.origen.y / r.direccion.y;
    const double X = r.origen.x + d * r.direccion.x, Z = r.origen.z + d * r.direccion.z;
    return {d > 0 && std::max(std::fabs(X), std::fabs(Z)) < 100, X / 2, -Z / 2};
}

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
// que el anterior: medido, 26.5, 26.2, 12.1 y 6.3 niveles.
TEST(Filtrado, CadaFiltroSeAcercaMasAlSobremuestreo) {
    const Imagen im = leeTextura(recurso("assets/baldosas.rgb"), 256, 256);
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
    }
    EXPECT_LT(error[1],
              error[0]); // poco: interpolar entre cuatro texels no cura nada donde un píxel abarca cientos
    EXPECT_LT(error[2], 0.6 * error[1]);
    EXPECT_LT(error[3], 0.6 * error[2]);
}

// Vecino y lineal no miran el tamaño del píxel: en su centro, el texel más cercano o el bilineal del nivel 0.
// En los vértices s y t valen ±50 y el último bit de un float vale allí 1/1024 de texel; con cuatro de esos,
// a menos de 1/256 de texel de una frontera puede salir el vecino, y el bilineal se desvía 1/256 del salto
// entre vecinos.
TEST(Filtrado, VecinoYLinealSonExactosEnElCentroDelPixel) {
    const Imagen im = leeTextura(recurso("assets/baldosas.rgb"), 256, 256);
    const Ejecucion v = ejecuta(FILTRADO, "tecla 1", ANCHO, ALTO),
                    l = ejecuta(FILTRADO, "tecla 2", ANCHO, ALTO);
    int total = 0, vecinos = 0, distintos = 0, lejos = 0;
    double maximo = 0;
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < ANCHO; ++x) {
            const Coordenadas c = enSuelo(x + 0.5, y + 0.5);
            ASSERT_TRUE(c.hay);
            const double u = c.s * 256, w = c.t * 256, h = 1.0 / 256 / 256;
            ++total;
            double salto = 0;
            for (const auto &[ds, dt] : {std::pair(h, h), {h, -h}, {-h, h}, {-h, -h}}) {
                const Vec3 d = bilineal(im, c.s + ds, c.t + dt) - bilineal(im, c.s, c.t);
                salto = std::max({salto, std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
            }
            const double error = distancia(pixel(l.imagen, x, y), bilineal(im, c.s, c.t));
            lejos += error > 1 + salto;
            maximo = std::max(maximo, error);
            if (std::min(std::fabs(u - std::round(u)), std::fabs(w - std::round(w))) < 1.0 / 256)
                continue;
            distintos += distancia(pixel(v.imagen, x, y), vecino(im, c.s, c.t)) != 0;
            ++vecinos;
        }
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
    EXPECT_EQ(sin3.imagen.rgb, sin4.imagen.rgb);
    EXPECT_EQ(sin3.imagen.rgb, con3.imagen.rgb);
    EXPECT_NE(con3.imagen.rgb, con4.imagen.rgb);
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

// Con una textura cuyo rojo es s, cuyo verde es t y cuyo azul es 255, la luz multiplica los tres por igual y
// s y t salen de rojo/azul y verde/azul. Contra la parametrización exacta (esfera y cilindro sin facetas),
// desde arriba y, por detrás, desde abajo.
TEST(Coordenadas, SeLeenEnLaImagenLasDeLaParametrizacion) {
    const std::vector<std::string> args = argumentos(imagen(256, 256, [](int x, int y) {
        return Pixel{x, y, 255};
    }));
    for (int objeto = 1; objeto <= 3; ++objeto)
        for (const auto &[dx, dy] : {std::pair(0, 0), {314, 90}}) {
            // arrastrar 1 píxel gira 0.01 rad: la derecha disminuye el azimut, y abajo aumenta la elevación
            const std::string guion = "tecla " + std::to_string(objeto) +
                                      "; boton IZQUIERDO abajo 0 0; arrastra " + std::to_string(dx) + " " +
                                      std::to_string(-dy);
            const Ejecucion e = ejecuta(COORDENADAS, guion, ANCHO, ALTO, args);
            ASSERT_EQ(e.estado, 0) << e.errores;

            const oraculo::Camara camara =
                oraculo::perspectiva(oraculo::orbita(0.6 - 0.01 * dx, 0.45 - 0.01 * dy, 5.9), 0.5, 1, 100);
            const oraculo::Mat4 depie = oraculo::gira({0, 1, 0}, -0.65) * oraculo::gira({1, 0, 0}, -PI / 2);
            const oraculo::Escena escena = {objeto == 1 ? oraculo::caja(oraculo::escala(1.65))
                                            : objeto == 2
                                                ? oraculo::cilindro(depie * oraculo::escala({1, 1, 2}))
                                                : oraculo::esfera(depie * oraculo::escala(1.35))};
            const Ve ve = [&](double x, double y) {
                const oraculo::Impacto i =
                    oraculo::primerImpacto(escena, oraculo::rayo(camara, ANCHO, ALTO, x, y));
                if (!i)
                    return Coordenadas{};
                oraculo::Impacto enObjeto;
                enObjeto.corte = i.corte;
                const Vec3 p = oraculo::punto(escena[0].inv, i.punto);
                oraculo::superficie(escena[0], p, enObjeto);
                Coordenadas c = parametriza(objeto, p, enObjeto.normal);
                c.cara = i.corte.cara;
                return c;
            };
            int dentro = 0, comparados = 0, malos = 0;
            for (int y = 1; y < ALTO - 1; y += 3)
                for (int x = 1; x < ANCHO - 1; x += 2) {
                    const Coordenadas c = ve(x + 0.5, y + 0.5);
                    dentro += c.hay;
                    // junto a la costura el filtro mezcla s = 1 con s = 0; de canto o en un polo caben muchos
                    // texels
                    const double rho = c.hay ? texelsPorPixel(ve, x, y, 256, 256) : 1e9;
                    if (rho > 14 || std::min({c.s, 1 - c.s, c.t, 1 - c.t}) < 0.06)
                        continue;
                    const Pixel p = pixel(e.imagen, x, y);
                    ASSERT_GE(p.b, 110) << "la luz ambiente es 0.45";
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
            EXPECT_EQ(malos, 0) << "objeto " << objeto << ", arrastre " << dx << "," << dy << ", de "
                                << comparados;
            EXPECT_GT(comparados, dentro / 2) << "objeto " << objeto << ", arrastre " << dx << "," << dy;
        }
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
/// (s, t) de la pared de 4 × 3, vista de frente.
Coordenadas enPared(double x, double y, int ancho, int alto) {
    const double unidad = std::min(ancho, alto) / (2 * 5 * std::tan(0.583 / 2));
    const Coordenadas c{true, 0.5 + (x - 0.5 * ancho) / unidad / 4, 0.5 + (y - 0.5 * alto) / unidad / 3};
    return {c.s > 0 && c.s < 1 && c.t > 0 && c.t < 1, c.s, c.t};
}
void comparaPared(const Texturas &x, int ancho, int alto, int salto) {
    for (int tecla = 1; tecla <= 3; ++tecla) {
        const Ejecucion e = ejecuta(MULTITEXTURA, "tecla " + std::to_string(tecla), ancho, alto);
        ASSERT_EQ(e.estado, 0) << e.errores;
        double maximo = 0;
        for (int j = salto / 2; j < alto; j += salto)
            for (int i = salto / 2; i < ancho; i += salto) {
                const Coordenadas c = enPared(i + 0.5, j + 0.5, ancho, alto);
                ASSERT_TRUE(c.hay);
                maximo = std::max(
                    maximo, distancia(pixel(e.imagen, i, j), mezcla(x, c.s, c.t, tecla != 2, tecla != 1)));
            }
        EXPECT_LE(maximo, 1) << "tecla " << tecla;
    }
}

} // namespace

// Las texturas de verdad, en una ventana tan grande que ninguna se reduce (512 texels en 640 píxeles): la
// mezcla, en la CPU, de cuatro bilineales. Cada textura está en su unidad y cada sampler2D lee la suya.
TEST(Multitextura, LaMezclaCalculadaEnLaCpu) {
    const auto lee = [](const char *nombre, int ancho, int alto) {
        return leeTextura(recurso("assets/" + std::string(nombre) + ".rgb"), ancho, alto);
    };
    comparaPared(
        {lee("ladrillo", 256, 256), lee("musgo", 256, 256), lee("mascara", 128, 96), lee("luz", 64, 48)}, 640,
        480, 3);
}

// Texturas propias, que el programa lee de $LAB_RAIZ: colores lisos y una máscara que recorre todos los
// valores, a 240 × 180. Sin detalle, los mipmaps no cambian nada y se comprueban todos los píxeles.
TEST(Multitextura, TodosLosValoresDeLaMascara) {
    const Texturas x = {imagen(256, 256,
                               [](int, int) {
                                   return Pixel{230, 120, 10};
                               }),
                        imagen(256, 256,
                               [](int, int) {
                                   return Pixel{20, 180, 90};
                               }),
                        imagen(128, 96,
                               [](int i, int) {
                                   return Pixel{2 * i, 77, 200};
                               }),
                        imagen(64, 48, [](int, int j) {
                            return Pixel{255 - 5 * j, 128, 5 * j};
                        })};
    const fs::path raiz = carpetaTemporal() / "raiz_ch06";
    escribeRgb(raiz / "assets/ladrillo.rgb", x.ladrillo);
    escribeRgb(raiz / "assets/musgo.rgb", x.musgo);
    escribeRgb(raiz / "assets/mascara.rgb", x.mascara);
    escribeRgb(raiz / "assets/luz.rgb", x.luz);
    setenv("LAB_RAIZ", raiz.c_str(), 1);
    comparaPared(x, 240, 180, 1);
    unsetenv("LAB_RAIZ");
}
