// Comprobaciones independientes de los programas del capítulo 8: cada uno contra su escena trazada con el oráculo, que la
// describe aquí por su cuenta, en doble precisión.
#include "ch08_oraculo.h"
#include "ch08_texturas_avanzadas/mapa_alturas.h"
#include "ch08_texturas_avanzadas/mapa_normales.h"
#include "ch08_texturas_avanzadas/textura3d.h"
#include "colores.h"
#include "ejecuta.h"
#include "malla.h"
#include "oraculo/oraculo.h"
#include "rutas.h"
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>

namespace fs = std::filesystem;
using oraculo::Impacto;
using oraculo::PI;
using oraculo::Vec3;

namespace {

const std::string CARPETA = "ch08_texturas_avanzadas/";

Vec3 doble(const glm::vec3 &v) {
    return {v.x, v.y, v.z};
}
bool es(const Pixel &p, const Vec3 &color) {
    const int c[3] = {p.r, p.g, p.b};
    for (int k = 0; k < 3; ++k)
        if (std::fabs(c[k] - 255 * color[k]) > 1)
            return false;
    return true;
}
double distancia(const Vec3 &a, const Vec3 &b) {
    return std::max({std::fabs(a.x - b.x), std::fabs(a.y - b.y), std::fabs(a.z - b.z)});
}

/// Errores, en niveles, de los píxeles que se comparan.
struct Errores {
    int comparados = 0, grandes = 0;
    double maximo = 0, suma = 0;
    void anade(double d, double grande = 2) {
        ++comparados;
        grandes += d > grande;
        maximo = std::max(maximo, d);
        suma += d * d;
    }
    double rmse() const {
        return std::sqrt(suma / comparados);
    }
    void apunta() const {
        apuntaDiferencia(maximo, rmse());
        testing::Test::RecordProperty("comparados", comparados);
        testing::Test::RecordProperty("grandes", grandes);
    }
};

} // namespace

// --- cubemap ---

namespace {

/// Las seis fotos, según su nombre: hacia dónde mira cada una quien está en el centro mirando a −Z con +Y arriba, y qué tiene a
/// la derecha y arriba. Las del cielo y el suelo se hacen echando atrás o adelante la cabeza.
struct Foto {
    const char *nombre;
    Vec3 hacia, derecha, arriba;
};
const Foto FOTOS[6] = {
    {"delante", {0, 0, -1}, {1, 0, 0}, {0, 1, 0}}, {"derecha", {1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
    {"detras", {0, 0, 1}, {-1, 0, 0}, {0, 1, 0}},  {"izquierda", {-1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
    {"arriba", {0, 1, 0}, {1, 0, 0}, {0, 0, 1}},   {"abajo", {0, -1, 0}, {1, 0, 0}, {0, 0, -1}}};

/// Qué foto se ve en una dirección y en qué punto de ella, de −1 a 1.
struct EnFoto {
    int foto;
    double a, b;
};
EnFoto enFoto(const Vec3 &d) {
    int mejor = 0;
    for (int i = 1; i < 6; ++i)
        if (escalar(d, FOTOS[i].hacia) > escalar(d, FOTOS[mejor].hacia))
            mejor = i;
    const Foto &f = FOTOS[mejor];
    const double lejos = escalar(d, f.hacia);
    return {mejor, escalar(d, f.derecha) / lejos, escalar(d, f.arriba) / lejos};
}

/// Fotos de prueba: rojo crece hacia la derecha y verde hacia arriba, y filtrarlas no las cambia; el azul dice cuál es.
Vec3 colorDePrueba(const EnFoto &e) {
    return {0.5 + 0.4 * e.a, 0.5 + 0.4 * e.b, 0.1 + 0.15 * e.foto};
}

/// Mientras vive, los programas leen las fotos de prueba.
struct FotosDePrueba {
    const fs::path raiz = carpetaTemporal() / "fotos";
    const ConRaiz conRaiz{raiz};

    FotosDePrueba() {
        fs::create_directories(raiz / "assets");
        const int n = 256;
        for (int i = 0; i < 6; ++i) {
            std::ofstream f(raiz / "assets" / (std::string("entorno_") + FOTOS[i].nombre + ".rgb"),
                            std::ios::binary);
            for (int y = n - 1; y >= 0; --y) // la fila de arriba, primero
                for (int x = 0; x < n; ++x) {
                    const Vec3 c = colorDePrueba({i, (2 * x + 1.0) / n - 1, (2 * y + 1.0) / n - 1});
                    for (int k = 0; k < 3; ++k)
                        f.put(static_cast<char>(std::lround(255 * c[k])));
                }
        }
    }
};

const Vec3 METAL{0.97, 0.91, 0.80};
const oraculo::Mat4 GIRO_TORO = oraculo::gira({0, 0, 1}, 0.35) * oraculo::gira({1, 0, 0}, -1.05);

oraculo::Camara camaraCubemap(double azimut, double elevacion) {
    return oraculo::perspectiva(oraculo::orbita(azimut, elevacion, 4.7), 0.75, 0.5, 100);
}

/// Compara con la imagen los píxeles lejos de aristas del cubo y de donde el reflejo cambia muy deprisa. `refleja` da la
/// dirección en que se mira el mapa.
Errores comparaReflejo(const Imagen &im, const oraculo::Camara &camara, const oraculo::Escena &escena,
                       const std::function<Vec3(const Impacto &)> &refleja, int alto) {
    struct Visto {
        int zona;
        EnFoto e;
        Vec3 color;
    };
    const auto ve = [&](int x, int y) {
        const Impacto i = primerImpacto(escena, rayo(camara, im.ancho, im.alto, x + 0.5, y + 0.5));
        const EnFoto e = enFoto(i ? refleja(i) : i.rayo.direccion);
        return Visto{6 * i.objeto + e.foto, e, i ? METAL * colorDePrueba(e) : colorDePrueba(e)};
    };
    Errores errores;
    for (int y = alto; y < im.alto - 1; y += 3)
        for (int x = 1; x < im.ancho - 1; x += 3) {
            const Visto c = ve(x, y);
            bool borde = std::max(std::fabs(c.e.a), std::fabs(c.e.b)) > 0.93;
            for (const auto &[dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                const Visto v = ve(x + dx, y + dy);
                borde = borde || v.zona != c.zona || distancia(v.color, c.color) > 0.03;
            }
            if (!borde)
                errores.anade(oraculo::diferencia(im, x, y, c.color));
        }
    return errores;
}

oraculo::Escena toroExacto() {
    return {oraculo::toro(GIRO_TORO, 1, 0.5)};
}
Vec3 porFragmento(const Impacto &i) {
    return refleja(i.rayo.direccion, i.normal);
}

} // namespace

// El reflejo y el fondo, con las fotos de prueba, desde tres sitios: si el entorno girase con la cámara, o una cara estuviera
// en otro sitio, del revés o en espejo, los colores serían otros.
TEST(Cubemap, ReflejoYFondoContraTrazadoDeRayos) {
    const FotosDePrueba fotos;
    const struct {
        const char *guion;
        double azimut, elevacion;
    } casos[] = {{"", 0.35, 0.06},
                 {"boton IZQUIERDO abajo 200 100; arrastra 400 100", 0.35 - 1, 0.06},
                 {"boton IZQUIERDO abajo 200 100; arrastra 40 260", 0.35 + 0.8, 0.06 + 0.8},
                 {"boton IZQUIERDO abajo 200 300; arrastra 80 60", 0.35 + 0.6, 0.06 - 1.2}};
    for (const auto &c : casos) {
        const Ejecucion e = ejecuta(CARPETA + "cubemap", c.guion, 480, 360);
        ASSERT_EQ(e.estado, 0) << e.errores;
        const Errores errores =
            comparaReflejo(e.imagen, camaraCubemap(c.azimut, c.elevacion), toroExacto(), porFragmento, 1);
        errores.apunta();
        EXPECT_GT(errores.comparados, 8000) << c.guion;
        EXPECT_LE(errores.maximo, 4) << c.guion; // dos redondeos a 8 bits y el nivel de mipmap
        EXPECT_LE(errores.rmse(), 0.8) << c.guion;
    }
}

// Por vértice, la dirección que se interpola es la reflejada en cada vértice, y se nota.
TEST(Cubemap, PorVerticeYPorFragmento) {
    const FotosDePrueba fotos;
    const int lado = 360;
    const Ejecucion e = ejecuta(CARPETA + "cubemap", "tecla v", 2 * lado, lado);
    ASSERT_EQ(e.estado, 0) << e.errores;
    const Malla malla = toro(1, 0.5f, 36, 18); // pocas facetas, para que se note
    const oraculo::Escena escena = {oraculo::malla(GIRO_TORO, malla)};
    const oraculo::Camara camara = camaraCubemap(0.35, 0.06);
    const auto porVertice = [&](const Impacto &i) {
        Vec3 suma;
        const double b[3] = {1 - i.corte.b1 - i.corte.b2, i.corte.b1, i.corte.b2};
        for (int k = 0; k < 3; ++k) {
            const Vertice &v =
                malla.vertices[malla.indices[static_cast<std::size_t>(3 * i.corte.triangulo + k)]];
            const Vec3 hacia = punto(GIRO_TORO, doble(v.posicion)) - camara.ojo;
            suma = suma + b[k] * refleja(hacia, oraculo::transformaNormal(escena[0].inv, doble(v.normal)));
        }
        return suma;
    };
    const Imagen izquierda = oraculo::recorta(e.imagen, 0, 0, lado - 1, lado),
                 derecha = oraculo::recorta(e.imagen, lado + 1, 0, lado - 1, lado);
    const int rotulo = 60; // los rótulos, abajo
    const Errores a = comparaReflejo(izquierda, camara, escena, porFragmento, rotulo),
                  b = comparaReflejo(derecha, camara, escena, porVertice, rotulo),
                  cruzado = comparaReflejo(derecha, camara, escena, porFragmento, rotulo);
    b.apunta();
    EXPECT_LE(a.maximo, 5);
    EXPECT_LE(b.maximo, 5);
    EXPECT_LE(a.rmse(), 1);
    EXPECT_LE(b.rmse(), 1);
    EXPECT_GT(cruzado.maximo, 15);
}

// El mapa desplegado: en cada casilla, su foto, derecha; de izquierda a derecha −X −Z +X +Z, con +Y encima de −Z y −Y debajo.
TEST(Cubemap, Desplegado) {
    const FotosDePrueba fotos;
    const int ancho = 960, alto = 720, lado = 228;
    const Ejecucion e = ejecuta(CARPETA + "cubemap", "tecla c", ancho, alto);
    ASSERT_EQ(e.estado, 0) << e.errores;
    const struct {
        int foto, columna, fila; // desde el centro, en medios lados
    } casillas[] = {{3, -3, 0}, {0, -1, 0}, {1, 1, 0}, {2, 3, 0}, {4, -1, 2}, {5, -1, -2}};
    for (const auto &c : casillas)
        for (const double a : {-0.9, -0.3, 0.4, 0.9})
            for (const double b : {-0.2, 0.3, 0.9}) { // abajo está el rótulo
                const int x = ancho / 2 + static_cast<int>(lado * (c.columna + a) / 2),
                          y = alto / 2 + static_cast<int>(lado * (c.fila + b) / 2);
                EXPECT_LE(oraculo::diferencia(e.imagen, x, y, colorDePrueba({c.foto, a, b})), 3)
                    << FOTOS[c.foto].nombre << ' ' << a << ' ' << b;
            }
}

// Las fotos de verdad se continúan unas a otras: a los dos lados de cada arista se ve casi lo mismo, y mucho más parecido
// que si una estuviera en espejo.
TEST(Cubemap, LasFotosNoTienenCostura) {
    Imagen fotos[6];
    for (int i = 0; i < 6; ++i)
        fotos[i] = leeTextura(recurso(std::string("assets/entorno_") + FOTOS[i].nombre + ".rgb"), 256, 256);
    const auto color = [&](const Vec3 &d) {
        const EnFoto e = enFoto(d);
        const auto texel = [](double c) { return std::clamp(static_cast<int>(128 * (c + 1)), 0, 255); };
        const Pixel p = pixel(fotos[e.foto], texel(e.a), texel(e.b));
        return Vec3{double(p.r), double(p.g), double(p.b)};
    };
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < i; ++j) {
            if (escalar(FOTOS[i].hacia, FOTOS[j].hacia) < -0.5)
                continue;
            const Vec3 arista = vectorial(FOTOS[i].hacia, FOTOS[j].hacia);
            double suma = 0;
            for (int k = 0; k < 256; ++k) {
                const Vec3 medio = FOTOS[i].hacia + FOTOS[j].hacia + ((k + 0.5) / 128 - 1) * arista,
                           paso = 0.002 * (FOTOS[i].hacia - FOTOS[j].hacia);
                const Vec3 d = color(medio + paso) - color(medio - paso);
                suma += (std::fabs(d.x) + std::fabs(d.y) + std::fabs(d.z)) / 3;
            }
            EXPECT_LT(suma / 256, 8) << FOTOS[i].nombre << ' ' << FOTOS[j].nombre;
        }
}

// La ecuación 8.1 no es la tabla de OpenGL: con x positiva intercambia las dos coordenadas y les da la vuelta, un espejo; con x
// negativa, gira la cara un cuarto de vuelta.
TEST(Erratas, Ecuacion81) {
    for (const double x : {1.0, -1.0})
        for (const double y : {-0.7, 0.1, 0.6})
            for (const double z : {-0.4, 0.2, 0.9}) {
                const double u = (y + x) / (2 * x), v = (z + x) / (2 * x);
                const oraculo::CaraCubo c = oraculo::caraDelCubo({x, y, z});
                EXPECT_NEAR(u, x > 0 ? 1 - c.t : c.t, 1e-15);
                EXPECT_NEAR(v, 1 - c.s, 1e-15);
            }
}

// --- enrejado ---

// Con tres tallas: los barrotes de fuera, los de detrás vistos por dentro, iluminados con la normal opuesta, y el fondo.
TEST(Enrejado, HuecosContraFract) {
    const int ancho = 480, alto = 360;
    const oraculo::Camara camara = oraculo::perspectiva(oraculo::orbita(0.4, 0.35, 6), 0.4, 1, 100);
    const oraculo::Escena escena = {oraculo::esfera(oraculo::gira({1, 0, 0}, -PI / 2))};
    const oraculo::Luz luz{{-4, 6, 5}};
    const oraculo::Material fuera{0.22 * doble(NARANJA), 0.80 * doble(NARANJA), {0.55, 0.55, 0.55}, 50},
        dentro{0.25 * doble(AZUL), 0.80 * doble(AZUL), {}, 1};
    for (const auto &[guion, talla] : {std::pair<const char *, double>{"", 0.35},
                                       {"tecla -; tecla -; tecla -; tecla -", 0.15},
                                       {"tecla +; tecla +; tecla +; tecla +; tecla +; tecla +", 0.65}}) {
        const Ejecucion e = ejecuta(CARPETA + "enrejado", guion, ancho, alto);
        ASSERT_EQ(e.estado, 0) << e.errores;
        struct Visto {
            int que; // 0 el fondo, 1 fuera, 2 dentro
            Vec3 color;
        };
        const auto ve = [&](double x, double y) {
            oraculo::Rayo r = rayo(camara, ancho, alto, x, y);
            for (const int que : {1, 2}) {
                const Impacto i = primerImpacto(escena, r);
                if (!i)
                    break;
                const double s = i.s * 24 - std::floor(i.s * 24), t = i.t * 12 - std::floor(i.t * 12);
                if (s <= talla || t <= talla)
                    return Visto{que, oraculo::phong(que == 1 ? fuera : dentro, {1, 1, 1}, {luz}, i.punto,
                                                     que == 1 ? i.normal : -i.normal, haciaOjo(i))};
                r.minimo = i.distancia + 1e-9;
            }
            return Visto{0, doble(FONDO_CLARO)};
        };
        Errores errores;
        int vistos[3] = {};
        for (int y = 1; y < alto - 40; y += 2) // arriba está el rótulo
            for (int x = 1; x < ancho - 1; x += 2) {
                const Visto v = ve(x + 0.5, y + 0.5);
                bool borde = false;
                for (const double dx : {-1.0, -0.5, 0.0, 0.5, 1.0})
                    for (const double dy : {-1.0, -0.5, 0.0, 0.5, 1.0})
                        borde = borde || ve(x + 0.5 + dx, y + 0.5 + dy).que != v.que;
                if (borde)
                    continue;
                ++vistos[v.que];
                errores.anade(oraculo::diferencia(e.imagen, x, y, v.color));
            }
        errores.apunta();
        EXPECT_LE(errores.maximo, 3) << talla;
        EXPECT_LE(errores.rmse(), 0.6) << talla;
        EXPECT_GT(vistos[1], 1000) << talla;
        EXPECT_GT(vistos[2], 100) << talla;
    }
}

TEST(Enrejado, ConTallaUnoEstaEnteraYConCeroNoHayNada) {
    std::string mas, menos;
    for (int i = 0; i < 30; ++i)
        mas += "tecla +; ", menos += "tecla -; ";
    const Imagen llena = ejecuta(CARPETA + "enrejado", mas + "tecla +", 240, 180).imagen,
                 vacia = ejecuta(CARPETA + "enrejado", menos + "tecla -", 240, 180).imagen;
    int fondo = 0, algo = 0;
    for (int y = 60; y < 120; ++y)
        for (int x = 90; x < 150; ++x) {
            fondo += es(pixel(llena, x, y), doble(FONDO_CLARO));
            algo += !es(pixel(vacia, x, y), doble(FONDO_CLARO));
        }
    EXPECT_EQ(fondo, 0);
    EXPECT_EQ(algo, 0);
}

// --- textura3d ---

namespace {

double escalon(double desde, double hasta, double x) { // smoothstep
    const double u = std::clamp((x - desde) / (hasta - desde), 0.0, 1.0);
    return u * u * (3 - 2 * u);
}
Vec3 mezcla(const Vec3 &a, const Vec3 &b, double t) {
    return (1 - t) * a + t * b;
}

/// De qué color es el bloque en p: madera (0), mármol (1) o el ruido tal cual (2).
Vec3 colorBloque(int elegido, const std::vector<unsigned char> &texels, const Vec3 &p) {
    const auto ruido = [&](double escala, double corre) {
        return definicion::trilineal(texels, escala * p + Vec3{corre, corre, corre});
    };
    if (elegido == 0) {
        const double x = p.x + 0.08 * p.y + 0.22 * (ruido(0.4, 0) - 0.5) + 0.22,
                     z = p.z + 0.08 * p.y + 0.22 * (ruido(0.4, 0.5) - 0.5) + 0.10, r = 13 * std::hypot(x, z),
                     anillo = r - std::floor(r), tardia = anillo * anillo * (1 - escalon(0.86, 1, anillo)),
                     hebras = definicion::trilineal(texels, Vec3{6 * p.x, 0.35 * p.y, 6 * p.z});
        return mezcla({0.87, 0.63, 0.37}, {0.48, 0.25, 0.11},
                      std::clamp(1.15 * tardia + 0.9 * (hebras - 0.45), 0.0, 1.0));
    }
    if (elegido == 1) {
        const double torcido = ruido(0.35, 0) + 0.4 * ruido(0.9, 0.3),
                     onda = std::fabs(std::sin(5 * (p.x + 0.7 * p.y + 0.4 * p.z) + 6 * torcido)),
                     veta = std::pow(1 - onda, 3) * escalon(0.25, 0.65, ruido(0.7, 0.6));
        const Vec3 fondo =
            mezcla({0.97, 0.96, 0.94}, {0.74, 0.77, 0.82}, escalon(0.35, 0.75, ruido(0.3, 0.25)));
        return mezcla(fondo, {0.24, 0.28, 0.34}, std::min(1.2 * veta, 1.0));
    }
    const double valor = ruido(1, 0);
    return {valor, valor, valor};
}

} // namespace

// Cada texel contra la definición del ruido en su centro; medio nivel por redondear.
TEST(Textura3d, CadaTexelContraLaFuncion) {
    const std::vector<unsigned char> texels = texelsRuido();
    ASSERT_EQ(texels.size(), 262144u);
    std::size_t recortados = 0;
    for (std::size_t i = 0; i < texels.size(); i += 37) {
        const glm::dvec3 p(i % 64, i / 64 % 64, i / 4096);
        const double valor = 0.5 + 0.5 * definicion::turbulencia((p + 0.5) / 16.0, 3, glm::ivec3(4));
        EXPECT_NEAR(texels[i], 255 * std::clamp(valor, 0.0, 1.0), 0.501) << i;
        recortados += valor < 0 || valor > 1;
    }
    EXPECT_LT(recortados, 100u); // de 7 000
}

// De la última capa a la primera se pasa igual de suavemente que de cada una a la siguiente.
TEST(Textura3d, PeriodicaSinCostura) {
    const std::vector<unsigned char> t = texelsRuido();
    for (const int salto : {1, 64, 4096}) {
        double dentro = 0, costura = 0;
        for (int i = 0; i < 262144; ++i) {
            const int capa = i / salto % 64;
            const auto siguiente = static_cast<std::size_t>(capa == 63 ? i - 63 * salto : i + salto);
            (capa == 63 ? costura : dentro) +=
                std::fabs(t[static_cast<std::size_t>(i)] - double(t[siguiente]));
        }
        EXPECT_NEAR(costura / 4096, dentro / (63 * 4096), 0.25 * dentro / (63 * 4096)) << salto;
    }
}

// El bloque y el peón de cada material, donde la textura se amplía: trilineal en los puntos del bloque, por Phong. `detalle`: las
// veces que el material más repite la textura. Una tecla + deshace una −.
TEST(Textura3d, CadaMaterialContraTrazadoDeRayos) {
    const std::vector<unsigned char> texels = texelsRuido();
    const int ancho = 960, alto = 720;
    const oraculo::Camara camara =
        oraculo::perspectiva(oraculo::orbita(0.45, 0.32, 9.9, {0.05, 0, 0}), 0.4, 1, 100);
    const oraculo::Luz luz{{-3, 6, 8}};
    const auto pieza = [](const Vec3 &donde, const Vec3 &talla) { // el eje, hacia +Y
        return oraculo::traslada(donde) * oraculo::gira({1, 0, 0}, -PI / 2) * oraculo::escala(talla);
    };
    const oraculo::Escena escena = {oraculo::caja(pieza({-1.15, 0, 0}, {1.5, 1.5, 2.6})),
                                    oraculo::cilindro(pieza({1.15, -1.19, 0}, {0.85, 0.85, 0.22})),
                                    oraculo::cono(pieza({1.15, -1.08, 0}, {0.74, 0.74, 2.1})),
                                    oraculo::esfera(pieza({1.15, 0.78, 0}, {0.52, 0.52, 0.52})),
                                    oraculo::toro(pieza({1.15, -1.0, 0}, {1.45, 1.45, 1}), 0.42, 0.14),
                                    oraculo::toro(pieza({1.15, 0.28, 0}, {0.85, 0.85, 0.6}), 0.42, 0.14)};
    const struct {
        const char *guion;
        int elegido;
        double S1, detalle;
    } casos[] = {{"tecla 3", 2, 0.5, 1},
                 {"tecla 3; tecla -", 2, 0.25, 1},
                 {"tecla 2; tecla -; tecla +", 1, 0.5, 1},
                 {"tecla -; tecla -", 0, 0.125, 6}};
    for (const auto &[guion, elegido, S1, detalle] : casos) {
        SCOPED_TRACE(guion);
        const Ejecucion e = ejecuta(CARPETA + "textura3d", guion, ancho, alto);
        ASSERT_EQ(e.estado, 0) << e.errores;
        Errores bloque, tallado; // este, de facetas
        int porObjeto[6] = {};
        for (int y = 1; y < alto - 60; y += 7)
            for (int x = 1; x < ancho - 1; x += 7) {
                const auto ve = [&](double dx, double dy) {
                    return primerImpacto(escena, rayo(camara, ancho, alto, x + 0.5 + dx, y + 0.5 + dy));
                };
                const Impacto i = ve(0, 0);
                if (!i)
                    continue;
                bool lejos = true; // de bordes, y donde un píxel es menor que un texel
                for (const double dx : {-1.5, 1.5})
                    for (const double dy : {-1.5, 1.5}) {
                        const Impacto v = ve(dx, dy);
                        lejos = lejos && v.objeto == i.objeto && v.corte.cara == i.corte.cara &&
                                longitud(v.punto - i.punto) * S1 * detalle * 64 < 1.5;
                    }
                if (!lejos)
                    continue;
                const Vec3 color = colorBloque(elegido, texels, S1 * i.punto);
                const double brillo = elegido == 1 ? 0.45 : 0.15;
                const oraculo::Material m{0.35 * color, 0.75 * color, {brillo, brillo, brillo}, 40};
                (i.objeto ? tallado : bloque)
                    .anade(oraculo::diferencia(
                        e.imagen, x, y, oraculo::phong(m, {1, 1, 1}, {luz}, i.punto, i.normal, haciaOjo(i))));
                ++porObjeto[i.objeto];
            }
        bloque.apunta();
        EXPECT_LE(bloque.maximo, 2) << S1;
        EXPECT_LE(bloque.rmse(), 0.5) << S1;
        EXPECT_LE(tallado.maximo, 6) << S1;
        EXPECT_LE(tallado.rmse(), elegido == 1 ? 1 : 0.8) << S1; // el mármol brilla el triple
        for (const int n : {porObjeto[0], porObjeto[2], porObjeto[3]})
            EXPECT_GT(n, 100) << S1;
    }
}

// La madera y el mármol son del color de la madera y del mármol, y su veta pasa de una cara del bloque a otra.
TEST(Textura3d, MaderaYMarmol) {
    const Imagen madera = ejecuta(CARPETA + "textura3d", "tecla 2; tecla 1", 480, 360).imagen,
                 marmol = ejecuta(CARPETA + "textura3d", "tecla 2", 480, 360).imagen;
    double rojo = 0, azul = 0, gris = 0, croma = 0;
    int n = 0;
    for (int y = 100; y < 280; ++y)
        for (int x = 70; x < 160; ++x, ++n) {
            const Pixel a = pixel(madera, x, y), b = pixel(marmol, x, y);
            rojo += a.r, azul += a.b, gris += b.g, croma += std::abs(b.r - b.b);
        }
    EXPECT_GT(rojo, 1.8 * azul);
    EXPECT_GT(gris / n, 130);
    EXPECT_LT(croma / n, 25);
}

// --- bump ---

namespace {

/// Altura del bulto que se repite en (s, t), en lados del mapa: mapa_normales.h dice el radio y la altura.
double alturaBulto(double s, double t) {
    const double u = (s - std::floor(s) - 0.5) / 0.42, v = (t - std::floor(t) - 0.5) / 0.42,
                 q = 1 - u * u - v * v;
    return q > 0 ? 0.15 * q * q : 0;
}

/// Normal de la superficie desplazada de verdad, P + h·N, por diferencias en doble. P(s, t) y N(s, t) en el mundo.
Vec3 normalDesplazada(const std::function<Vec3(double, double)> &P,
                      const std::function<Vec3(double, double)> &N,
                      const std::function<double(double, double)> &h, double s, double t) {
    const double d = 1e-5;
    const auto Q = [&](double a, double b) { return P(a, b) + h(a, b) * N(a, b); };
    const Vec3 n = unitario(vectorial(Q(s + d, t) - Q(s - d, t), Q(s, t + d) - Q(s, t - d)));
    return escalar(n, N(s, t)) < 0 ? -n : n;
}

struct EscenaBump {
    oraculo::Camara camara =
        oraculo::perspectiva(oraculo::orbita(0.3, 0.55, 10.2, {0, -0.35, 0}), 0.45, 1, 100);
    oraculo::Mat4 Mplano = oraculo::traslada({0, -1, 0}) * oraculo::gira({1, 0, 0}, -PI / 2) *
                           oraculo::escala({4.4, 3.6, 1}),
                  Mesfera = oraculo::gira({1, 0, 0}, -PI / 2) * oraculo::escala({1.2, 1.2, 0.96});
    oraculo::Escena escena = {oraculo::plano(Mplano), oraculo::esfera(Mesfera)};
    oraculo::Luz luz{{-5, 4, 2}};
    oraculo::Material material[2] = {{{0.17, 0.20, 0.24}, {0.50, 0.58, 0.68}, {0.20, 0.20, 0.20}, 20},
                                     {{0.26, 0.14, 0.09}, {0.80, 0.42, 0.26}, {0.40, 0.40, 0.40}, 40}};

    Vec3 normal(const Impacto &i) const {
        if (i.objeto == 0)
            return normalDesplazada(
                [&](double s, double t) {
                    return punto(Mplano, {s - 0.5, t - 0.5, 0});
                },
                [](double, double) {
                    return Vec3{0, 1, 0};
                },
                [](double s, double t) { return 0.4 * alturaBulto(11 * s, 9 * t); }, i.s, i.t);
        const auto local = [](double s, double t) {
            return Vec3{std::sin(PI * t) * std::cos(2 * PI * s), std::sin(PI * t) * std::sin(2 * PI * s),
                        -std::cos(PI * t)};
        };
        return normalDesplazada(
            [&](double s, double t) { return punto(Mesfera, local(s, t)); },
            [&](double s, double t) { return oraculo::transformaNormal(escena[1].inv, local(s, t)); },
            [](double s, double t) { return 0.34 * alturaBulto(20 * s, 10 * t); }, i.s, i.t);
    }
};

} // namespace

// En cada objeto, la luz sobre la superficie desplazada de verdad (con su normal, en el punto sin desplazar). En el plano no
// hay más error que el mapa de 8 bits y su filtro; en la bola, además, lo que §8.4 desprecia: que al alejarse de ella, h, la
// superficie se agranda (h llega al 5 % del radio).
TEST(Bump, LaLuzDeLaSuperficieDesplazada) {
    const int ancho = 1280, alto = 960;
    const EscenaBump escena;
    for (const bool con : {true, false}) {
        const Ejecucion e = ejecuta(CARPETA + "bump", con ? "" : "tecla b", ancho, alto);
        ASSERT_EQ(e.estado, 0) << e.errores;
        Errores errores[2];
        for (int y = 2; y < alto - 80; y += 5)
            for (int x = 2; x < ancho - 2; x += 5) {
                const auto ve = [&](int dx, int dy) {
                    return primerImpacto(escena.escena,
                                         rayo(escena.camara, ancho, alto, x + dx + 0.5, y + dy + 0.5));
                };
                const Impacto i = ve(0, 0);
                if (!i || (i.objeto == 1 &&
                           -escalar(i.rayo.direccion, i.normal) < 0.3)) // de refilón, el mipmap alisa
                    continue;
                bool borde = false;
                for (const int d : {-2, 2})
                    borde = borde || ve(d, 0).objeto != i.objeto || ve(0, d).objeto != i.objeto;
                if (borde || (i.objeto == 1 && (i.t > 0.92 || i.t < 0.08)))
                    continue;
                const Vec3 N = con ? escena.normal(i) : i.normal;
                errores[i.objeto].anade(
                    oraculo::diferencia(e.imagen, x, y,
                                        oraculo::phong(escena.material[i.objeto], {1, 1, 1}, {escena.luz},
                                                       i.punto, N, haciaOjo(i))),
                    8);
            }
        for (int k = 0; k < 2; ++k) {
            RecordProperty((con ? "con" : "sin") + std::string(k ? "_bola" : "_plano"),
                           std::to_string(errores[k].maximo) + " " + std::to_string(errores[k].rmse()) + " " +
                               std::to_string(errores[k].grandes) + "/" +
                               std::to_string(errores[k].comparados));
            EXPECT_GT(errores[k].comparados, 3000);
            errores[k].apunta();
        }
        EXPECT_LE(errores[0].rmse(), con ? 1.5 : 0.5);
        EXPECT_LE(errores[1].rmse(), con ? 3.5 : 0.8);
        EXPECT_LE(errores[0].maximo, con ? 9 : 2);
        EXPECT_LE(errores[1].grandes, con ? errores[1].comparados / 20 : 0);
    }
}

// Junto al polo los bultos se aprietan: ni un píxel suelto (NaN sale negro o blanco), y la luz media, la de la bola lisa.
TEST(Bump, ElPolo) {
    const std::string desdeArriba =
        "boton IZQUIERDO abajo 100 10; arrastra 100 470; rueda +1 1 1; rueda +1 1 1";
    const Imagen con = ejecuta(CARPETA + "bump", desdeArriba, 640, 480).imagen,
                 sin = ejecuta(CARPETA + "bump", "tecla b; " + desdeArriba, 640, 480).imagen;
    // el polo está en (0, 0.96, 0): se busca con la cámara casi en la vertical
    const oraculo::Camara camara =
        oraculo::perspectiva(oraculo::orbita(0.3, 1.55, 10.2 / 1.21, {0, -0.35, 0}), 0.45, 1, 100);
    const Vec3 p = oraculo::proyecta(camara, 640, 480, {0, 0.96, 0});
    double mediaCon = 0, mediaSin = 0;
    for (int dy = -12; dy <= 12; ++dy)
        for (int dx = -12; dx <= 12; ++dx) {
            const Pixel a = pixel(con, static_cast<int>(p.x) + dx, static_cast<int>(p.y) + dy),
                        b = pixel(sin, static_cast<int>(p.x) + dx, static_cast<int>(p.y) + dy);
            EXPECT_GT(a.r, 40);
            EXPECT_FALSE(a.r == 255 && a.g == 255 && a.b == 255);
            EXPECT_GT(b.r, b.b + 20); // es la bola
            mediaCon += a.r / 625.0, mediaSin += b.r / 625.0;
        }
    EXPECT_NEAR(mediaCon, mediaSin, 0.12 * mediaSin);
}

// Las dos mitades de la ventana son los dos dibujos.
TEST(Bump, Comparados) {
    const Imagen im = ejecuta(CARPETA + "bump", "tecla v", 640, 320).imagen;
    const auto variacion = [&](int x0) {
        double suma = 0;
        for (int y = 60; y < 200; ++y)
            for (int x = x0 + 40; x < x0 + 280; ++x)
                suma += std::abs(pixel(im, x, y).g - pixel(im, x + 1, y).g);
        return suma;
    };
    EXPECT_GT(variacion(320), 2 * variacion(0));
}

// --- bump_ruido ---

namespace {

const Vec3 HACIA_SOL = oraculo::unitario({0.1219, 0.0975, -0.9877});

Vec3 cielo(const Vec3 &d) {
    const double sol = std::max(escalar(d, HACIA_SOL), 0.0);
    Vec3 c = mezcla({1.00, 0.62, 0.30}, {0.74, 0.42, 0.50}, escalon(0, 0.22, d.y));
    c = mezcla(c, {0.14, 0.20, 0.44}, escalon(0.10, 0.65, d.y));
    c = c + (0.45 * std::pow(sol, 24) + 0.5 * std::pow(sol, 400)) * Vec3{1, 0.55, 0.20};
    c = mezcla(c, {1, 0.95, 0.75}, escalon(0.9990, 0.9993, sol));
    const double llano = std::hypot(d.x, d.z),
                 cumbre = 0.055 + 0.07 * definicion::turbulencia({3 * d.x / llano, 3 * d.z / llano, 0.5}, 3);
    const Vec3 colina = mezcla({0.42, 0.26, 0.30}, {0.13, 0.11, 0.20}, escalon(0, 0.09, d.y));
    return mezcla(colina, c, escalon(-0.002, 0.002, d.y - cumbre));
}
/// Lo que se ve en una dirección desde `ojo`; la inclinación de las olas, por diferencias.
Vec3 lago(const Vec3 &ojo, const Vec3 &d, double tiempo) {
    if (d.y >= 0)
        return cielo(d);
    const double lejos = -ojo.y / d.y, h = 1e-5;
    const double x = ojo.x + lejos * d.x, z = ojo.z + lejos * d.z;
    const auto ola = [&](double a, double b) {
        return definicion::turbulencia({0.55 * a, 0.55 * b, tiempo}, 4, {0, 0, 64});
    };
    const double alisa = 0.10 / (1 + 0.0012 * lejos * lejos);
    const Vec3 N = oraculo::unitario({-alisa * (ola(x + h, z) - ola(x - h, z)) / (2 * h), 1,
                                      -alisa * (ola(x, z + h) - ola(x, z - h)) / (2 * h)});
    Vec3 R = refleja(d, N);
    R.y = std::fabs(R.y);
    const double fresnel = 0.02 + 0.98 * std::pow(1 - std::clamp(-escalar(d, N), 0.0, 1.0), 5);
    const Vec3 agua = mezcla({0.02, 0.10, 0.16}, {0.05, 0.24, 0.28}, std::clamp(0.5 + ola(x, z), 0.0, 1.0));
    return mezcla(agua, cielo(R), fresnel) +
           0.8 * std::pow(std::max(escalar(R, HACIA_SOL), 0.0), 300) * Vec3{1, 0.75, 0.45};
}

} // namespace

// El lago en doble, a los 0 s y 2 s después. Donde lo que se ve cambia deprisa (olas lejanas, contorno de las colinas) cuenta
// la última cifra del float: se apartan los píxeles cuyo color cambia al moverse una centésima de píxel.
TEST(BumpRuido, ContraElLagoEnDoble) {
    const oraculo::Camara camara =
        oraculo::perspectiva(oraculo::orbita(0, 0.13, 12, {0, 0.6, 0}), 0.75, 1, 100);
    std::string casiUnPeriodo; // el tiempo se repite a los 160 s
    for (int i = 0; i < 319; ++i)
        casiUnPeriodo += "tecla t; ";
    for (const auto &[guion, segundos] : {std::pair<std::string, double>{"", 0},
                                          {"espera 2000", 2},
                                          {casiUnPeriodo + "tecla Espacio", 159.5}}) {
        const int ancho = segundos > 100 ? 120 : 480, alto = 3 * ancho / 4, paso = ancho / 40;
        const Ejecucion e = ejecuta(CARPETA + "bump_ruido", guion, ancho, alto);
        ASSERT_EQ(e.estado, 0) << e.errores;
        Errores errores;
        for (int y = 1; y < alto; y += paso)
            for (int x = 1; x < ancho; x += paso) {
                const auto color = [&](double dx, double dy) {
                    return lago(camara.ojo, rayo(camara, ancho, alto, x + 0.5 + dx, y + 0.5 + dy).direccion,
                                0.4 * segundos);
                };
                const Vec3 c = color(0, 0);
                if (distancia(c, color(0.01, 0)) < 0.004 && distancia(c, color(0, 0.01)) < 0.004)
                    errores.anade(oraculo::diferencia(e.imagen, x, y, c));
            }
        errores.apunta();
        EXPECT_GT(errores.comparados, 700) << guion;
        EXPECT_LE(errores.maximo, 3) << guion;
        EXPECT_LE(errores.rmse(), 0.6) << guion;
    }
}

TEST(BumpRuido, ElTiempoSeParaYVuelveAEmpezar) {
    const auto foto = [](const std::string &guion) {
        return ejecuta(CARPETA + "bump_ruido", guion, 80, 60).imagen.rgb;
    };
    const auto inicio = foto("");
    EXPECT_EQ(foto("tecla Espacio; espera 2000"), inicio);
    EXPECT_NE(foto("tecla Espacio; espera 2000; tecla Espacio; espera 2000"), inicio);
    std::string periodo; // 64 celdas a 0.4 por segundo: 160 s
    for (int i = 0; i < 320; ++i)
        periodo += "tecla t; ";
    EXPECT_EQ(foto(periodo + "tecla Espacio"), inicio);
}

// --- desplazamiento ---

namespace {

double alturaIslaExacta(double s, double t) {
    const double r = 2.1 * std::hypot(s - 0.5, t - 0.5), isla = escalon(0, 1, 1 - r);
    return std::clamp(isla * (0.62 + 0.75 * definicion::turbulencia({5 * s, 5 * t, 2.5}, 6)), 0.0, 1.0);
}
Vec3 colorIsla(double h) {
    Vec3 c = mezcla({0.16, 0.42, 0.66}, {0.88, 0.79, 0.55}, escalon(0.004, 0.012, h));
    c = mezcla(c, {0.34, 0.55, 0.20}, escalon(0.04, 0.09, h));
    c = mezcla(c, {0.47, 0.42, 0.38}, escalon(0.30, 0.48, h));
    return mezcla(c, {0.97, 0.98, 1.00}, escalon(0.56, 0.68, h));
}

/// El plano desplazado, con la altura de cada vértice en `s`. Cada cuadrado se parte por la diagonal que elija plano().
oraculo::Objeto isla(double amplitud) {
    const int n = 193;
    std::vector<double> h;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            h.push_back(alturaIslaExacta(i / (n - 1.0), j / (n - 1.0)));
    const auto en = [&](int i, int j) {
        return h[static_cast<std::size_t>(std::clamp(j, 0, n - 1) * n + std::clamp(i, 0, n - 1))];
    };
    const Malla llano = plano(n - 1);
    std::vector<oraculo::VerticeRef> vertices;
    for (const Vertice &v : llano.vertices) {
        const int i = static_cast<int>(std::lround((v.posicion.x + 0.5) * (n - 1))),
                  j = static_cast<int>(std::lround((v.posicion.y + 0.5) * (n - 1)));
        const double dx = amplitud * (en(i + 1, j) - en(i - 1, j)) * (n - 1) / 2,
                     dy = amplitud * (en(i, j + 1) - en(i, j - 1)) * (n - 1) / 2;
        vertices.push_back({{i / (n - 1.0) - 0.5, j / (n - 1.0) - 0.5, amplitud * en(i, j)},
                            oraculo::unitario({-dx, -dy, 1}),
                            en(i, j),
                            0});
    }
    std::vector<oraculo::Triangulos::Indices> indices;
    for (std::size_t k = 0; k + 2 < llano.indices.size(); k += 3)
        indices.push_back({llano.indices[k], llano.indices[k + 1], llano.indices[k + 2]});
    return oraculo::malla(oraculo::gira({1, 0, 0}, -PI / 2) * oraculo::escala(2), std::move(vertices),
                          std::move(indices));
}

} // namespace

TEST(Desplazamiento, ElMapaEsLaIsla) {
    const std::vector<float> mapa = mapaAlturas();
    ASSERT_EQ(mapa.size(), 193u * 193u);
    for (std::size_t k = 0; k < mapa.size(); k += 11)
        EXPECT_NEAR(double(mapa[k]), alturaIslaExacta(double(k % 193) / 192, double(k / 193) / 192), 1e-5);
    EXPECT_EQ(mapa[0], 0); // el borde, a nivel del mar
    EXPECT_GT(*std::max_element(mapa.begin(), mapa.end()), 0.7f);
}

// La isla con tres amplitudes: posiciones (el contorno y lo que tapa), normales y color.
TEST(Desplazamiento, ContraLaMallaDesplazadaEnLaCpu) {
    const int ancho = 480, alto = 360;
    const oraculo::Camara camara =
        oraculo::perspectiva(oraculo::orbita(0.35, 0.42, 4.5, {-0.1, 0.04, 0}), 0.5, 0.5, 50);
    const oraculo::Luz luz{{-3, 2.2, 1}, 0};
    for (const auto &[guion, amplitud] : {std::pair<const char *, double>{"", 0.25},
                                          {"tecla +; tecla +; tecla +", 0.40},
                                          {"tecla -; tecla -; tecla -; tecla -; tecla -; tecla -", 0}}) {
        const Ejecucion e = ejecuta(CARPETA + "desplazamiento", guion, ancho, alto);
        ASSERT_EQ(e.estado, 0) << e.errores;
        const oraculo::Escena escena = {isla(amplitud)};
        const auto color = [&](const Impacto &i) {
            if (!i)
                return doble(CIELO);
            const Vec3 c = colorIsla(i.s);
            return oraculo::phong({0.35 * c, 0.85 * c, {0.06, 0.06, 0.06}, 15}, {1, 1, 1}, {luz}, i.punto,
                                  i.normal, haciaOjo(i));
        };
        Errores errores;
        for (int y = 1; y < alto - 40; y += 3)
            for (int x = 1; x < ancho - 1; x += 3) {
                const auto ve = [&](double dx, double dy) {
                    return primerImpacto(escena, rayo(camara, ancho, alto, x + 0.5 + dx, y + 0.5 + dy));
                };
                const Impacto i = ve(0, 0);
                const Vec3 c = color(i);
                bool borde = false; // el contorno de un monte, o un color que cambia en una décima de píxel
                for (const auto &[dx, dy] : {std::pair{0.1, 0.0}, {-0.1, 0.0}, {0.0, 0.1}, {0.0, -0.1}}) {
                    const Impacto v = ve(dx, dy);
                    borde = borde || v.objeto != i.objeto || distancia(color(v), c) > 0.02 ||
                            (i && longitud(v.punto - i.punto) > 0.02);
                }
                if (!borde)
                    errores.anade(oraculo::diferencia(e.imagen, x, y, c));
            }
        errores.apunta();
        EXPECT_GT(errores.comparados, 10000) << amplitud;
        EXPECT_LE(errores.maximo, 5) << amplitud;
        EXPECT_LE(errores.rmse(), 0.6) << amplitud;
    }
}
