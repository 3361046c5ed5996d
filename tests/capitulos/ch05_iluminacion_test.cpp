// Los programas del capítulo 5 contra trazado de rayos en doble precisión. Las escenas, los materiales y las
// luces están escritos otra vez. Cada escena se traza dos veces: con la misma malla que dibuja el programa, y
// entonces no debe haber más error que el redondeo a 8 bits, y con las formas exactas, que dicen cuánto
// cuesta la malla. Los rótulos y los trazos se comprueban aparte y se quitan antes de comparar.
#include "colores.h"
#include "ejecuta.h"
#include "encima.h"
#include "malla.h"
#include "oraculo/oraculo.h"
#include <cmath>
#include <cstdio>
#include <functional>
#include <gtest/gtest.h>
#include <iomanip>
#include <iostream>
#include <map>

using oraculo::Camara;
using oraculo::Comparacion;
using oraculo::Escena;
using oraculo::gira;
using oraculo::ImagenRef;
using oraculo::Impacto;
using oraculo::Luz;
using oraculo::Mat4;
using oraculo::Material;
using oraculo::Tono;
using oraculo::traslada;
using oraculo::Vec3;

namespace {

const double PI = oraculo::PI;
const Vec3 FONDO{0.16, 0.17, 0.20}, BLANCA{1, 1, 1};
const Vec3 X{1, 0, 0}, Y{0, 1, 0}, Z{0, 0, 1};

Mat4 escala(double s) {
    return oraculo::escala(s);
}
Mat4 escala(double x, double y, double z) {
    return oraculo::escala({x, y, z});
}

Luz posicional(const Vec3 &p) {
    Luz luz;
    luz.posicion = p;
    return luz;
}
Luz direccional(const Vec3 &haciaLuz) {
    Luz luz = posicional(haciaLuz);
    luz.w = 0;
    return luz;
}
Luz foco(const Vec3 &p, const Vec3 &apunta, double delta, double exponente) {
    Luz luz = posicional(p);
    luz.foco = true, luz.S = oraculo::unitario(apunta - p), luz.delta = delta, luz.exponente = exponente;
    return luz;
}

/// Si el cono del foco contiene p: separa en zonas lo que cambia dentro de una cara.
bool enElCono(const Luz &luz, const Vec3 &p) {
    const Vec3 v = oraculo::unitario(p - luz.posicion);
    return std::atan2(oraculo::longitud(oraculo::vectorial(v, luz.S)), oraculo::escalar(v, luz.S)) <=
           luz.delta;
}

/// Imagen de una escena con un material por objeto y luz ambiente (1, 1, 1): ecuación 5.7 en cada píxel.
ImagenRef traza(const Escena &escena, const std::vector<Material> &materiales, const std::vector<Luz> &luces,
                const Camara &camara, const Vec3 &fondo, int ancho = 240, int alto = 180) {
    return oraculo::render(escena, camara, ancho, alto, [&](const Impacto &i) -> Tono {
        if (!i)
            return fondo;
        int zona = 0;
        for (const Luz &luz : luces)
            zona = 2 * zona + (luz.foco && enElCono(luz, i.punto));
        return {oraculo::phong(materiales[static_cast<std::size_t>(i.objeto)], BLANCA, luces, i.punto,
                               i.normal, -i.rayo.direccion),
                zona};
    });
}

/// `o`, con otra transformación.
oraculo::Objeto en(const Mat4 &M, oraculo::Objeto o) {
    o.M = M, o.inv = oraculo::inversa(M);
    return o;
}
/// Las formas curvas: la malla de n segmentos o, con n = 0, la exacta.
oraculo::Objeto unaEsfera(const Mat4 &M, int n) {
    static std::map<int, oraculo::Objeto> mallas;
    if (n == 0)
        return oraculo::esfera(M);
    return en(M, mallas.try_emplace(n, oraculo::malla(Mat4(), esfera(n))).first->second);
}
oraculo::Objeto unToro(const Mat4 &M, double radio, double radioTubo, int n, int m) {
    if (n == 0)
        return oraculo::toro(M, radio, radioTubo);
    return oraculo::malla(M, toro(static_cast<float>(radio), static_cast<float>(radioTubo), n, m));
}

/// Una ejecución con varias capturas: la imagen que queda tras cada guion, que sigue al anterior.
std::vector<Imagen> imagenes(const std::string &programa, const std::vector<std::string> &guiones,
                             int ancho = 240, int alto = 180) {
    const std::string base = (carpetaTemporal() / "ch05_").string();
    std::string guion;
    for (std::size_t i = 0; i < guiones.size(); ++i)
        guion += guiones[i] + "; captura " + base + std::to_string(i) + ".ppm; ";
    const Ejecucion e = ejecuta("ch05_iluminacion/" + programa, guion, ancho, alto);
    if (e.estado != 0 || !e.errores.empty())
        throw std::runtime_error(programa + ": " + e.errores);
    std::vector<Imagen> resultado;
    for (std::size_t i = 0; i < guiones.size(); ++i) {
        resultado.push_back(leePpm(base + std::to_string(i) + ".ppm"));
        std::remove((base + std::to_string(i) + ".ppm").c_str());
    }
    return resultado;
}

/// Compara y escribe el resultado; `tope` en niveles, para el interior. Con la misma malla, en la banda solo
/// pueden fallar los píxeles cuyo centro está a menos de 1/512 de la silueta, que la GPU redondea a una
/// rejilla de 1/256: como la banda tiene de 2 a 3 píxeles de ancho, uno de cada 500. Con la forma exacta la
/// silueta es otra, y la banda no se exige.
void comprueba(const std::string &que, const Imagen &imagen, const ImagenRef &ref, double tope,
               bool mismaMalla) {
    const Comparacion c = oraculo::compara(imagen, ref);
    std::cout << que << (mismaMalla ? ", misma malla: " : ", forma exacta: ") << c << "\n";
    EXPECT_LE(c.maximo, tope) << que << ": " << c;
    EXPECT_TRUE(!mismaMalla || c.bandaLejos <= c.banda / 500) << que << ": " << c;
    EXPECT_GT(c.interior, ref.ancho * ref.alto / 2) << que << ": " << c;
}

const double MISMA_MALLA = 1, EXACTA = 2; // niveles: los objetivos de la comparación

} // namespace

// --- componentes_phong -------------------------------------------------------------------------------------

namespace {

const Material CERAMICA = {{0.08, 0.20, 0.38}, {0.14, 0.36, 0.62}, {0.75, 0.75, 0.75}, 30};
const Material LATON = {{0.42, 0.23, 0.05}, {0.58, 0.36, 0.08}, {0.60, 0.55, 0.45}, 30};

const int N_CERAMICA = segmentosEsfera(230), N_ANILLO = segmentosEsfera(400), M_ANILLO = segmentosEsfera(60);
const Vec3 POSICION_PHONG{-3.5, 4, 6};

ImagenRef componentes(int cuantos, bool mismaMalla, double azimut = 0, double elevacion = 0) {
    Luz luz = posicional(POSICION_PHONG);
    luz.Ld = cuantos >= 2 ? BLANCA : Vec3{}, luz.Ls = cuantos >= 3 ? BLANCA : Vec3{};
    const Escena escena = {
        unaEsfera(Mat4(), mismaMalla ? N_CERAMICA : 0),
        unToro(gira(Z, 0.35) * gira(X, -1.15), 1.55, 0.22, mismaMalla ? N_ANILLO : 0, M_ANILLO)};
    return traza(escena, {CERAMICA, LATON}, {luz},
                 oraculo::perspectiva(oraculo::orbita(azimut, elevacion, 10), 0.31, 1, 100), FONDO);
}

/// Arriba a la izquierda está el nombre de cada componente, y ninguno más.
Imagen sinNombres(const Imagen &imagen, const ImagenRef &ref, int cuantos) {
    SinEncima sin(imagen, ref);
    const char *const nombres[] = {"ambiente", "+ difusa", "+ especular"};
    for (int k = 0; k < 3; ++k)
        EXPECT_EQ(sin.rotulo(nombres[k], BLANCO, 48, 172 - 10 * k), k < cuantos) << nombres[k];
    return sin.limpia;
}

} // namespace

TEST(ComponentesPhong, ContraTrazadoDeRayos) {
    const auto gpu = imagenes("componentes_phong", {"tecla 1", "tecla 2", "tecla 3"});
    const char *const nombres[] = {"a", "b", "c"};
    for (int k = 0; k < 3; ++k)
        for (const bool mismaMalla : {true, false}) {
            const ImagenRef ref = componentes(k + 1, mismaMalla);
            comprueba(nombres[k], sinNombres(gpu[static_cast<std::size_t>(k)], ref, k + 1), ref,
                      mismaMalla ? MISMA_MALLA : EXACTA, mismaMalla);
        }
}

// La luz está en el mundo: al girar la cámara cambian sus coordenadas de la cámara, y el brillo se mueve.
TEST(ComponentesPhong, LaLuzNoGiraConLaCamara) {
    const auto gpu =
        imagenes("componentes_phong",
                 {"boton IZQUIERDO abajo 100 90; arrastra 140 120; boton IZQUIERDO arriba 140 120"});
    const ImagenRef ref = componentes(3, true, -0.4, 0.3);
    comprueba("girada", sinNombres(gpu[0], ref, 3), ref, MISMA_MALLA, true);
}

namespace {

/// Si hay ese color en el píxel o en sus vecinos.
bool hayCerca(const Imagen &imagen, const Vec3 &p, const glm::vec3 &color) {
    bool hay = false;
    for (int k = 0; k < 9; ++k)
        hay = hay ||
              esColor(imagen, static_cast<int>(p.x) + k % 3 - 1, static_cast<int>(p.y) + k / 3 - 1, color);
    return hay;
}

/// Lo que se ve del panel derecho de `vectores` (480×360) si el punto elegido es P: el plano de N y L, N hacia arriba y L a
/// la izquierda. Caben 3.6 unidades a lo alto y el centro está 0.25 bajo P.
struct DeLado {
    Vec3 P, N, L, R, V, derecha;
    explicit DeLado(const Vec3 &p, const Vec3 &ojo = {0, 0, 10}) : P(p), N(p) {
        L = oraculo::unitario(POSICION_PHONG - P), V = oraculo::unitario(ojo - P);
        R = 2 * oraculo::escalar(N, L) * N - L;
        derecha = oraculo::unitario(oraculo::escalar(N, L) * N - L);
    }
    /// Del punto P + v, en píxeles.
    Vec3 enPanel(const Vec3 &v) const {
        return {241 + 119.5 + 100 * oraculo::escalar(v, derecha), 180 + 100 * (oraculo::escalar(v, N) + 0.25),
                0};
    }
    static std::string grados(const std::string &nombre, const Vec3 &a, const Vec3 &b) {
        const double angulo = std::atan2(oraculo::longitud(oraculo::vectorial(a, b)), oraculo::escalar(a, b));
        return nombre + " = " + std::to_string(std::lround(angulo * 180 / PI)) + "°";
    }
    /// La flecha del vector llega a su punta con su color y su letra está encima.
    void compruebaVector(const Imagen &imagen, const std::string &letra, const Vec3 &v,
                         const glm::vec3 &color) const {
        const Vec3 punta = enPanel(1.2 * v);
        EXPECT_TRUE(seLee(imagen, letra, color, punta.x, punta.y + 13, 4)) << letra;
        int vistos = 0; // con ángulos pequeños, su nombre tapa un trozo
        for (const double t : {0.5, 0.6, 0.7, 0.8, 0.9, 1.0})
            vistos += hayCerca(imagen, enPanel(t * v), color);
        EXPECT_GE(vistos, 5) << letra;
    }
};

/// El panel izquierdo mide 239×360: a lo ancho abarca lo mismo que una ventana 4:3.
Camara camaraDelPanel() {
    return oraculo::perspectiva(oraculo::orbita(0, 0, 10), 0.31, 1, 100);
}

} // namespace

// Figura 5.2 y ecuación 5.5: en tres puntos elegidos con un clic, los vectores y los ángulos que dan las ecuaciones.
TEST(ComponentesPhong, VectoresYAngulosEnElPuntoElegido) {
    const glm::ivec2 clics[] = {{119, 170}, {100, 150}, {130, 160}};
    std::vector<std::string> guiones;
    for (const glm::ivec2 &c : clics) {
        const std::string en = std::to_string(c.x) + " " + std::to_string(c.y);
        guiones.push_back((guiones.empty() ? "tecla n; " : "") + ("boton IZQUIERDO abajo " + en) +
                          "; boton IZQUIERDO arriba " + en);
    }
    guiones.push_back(
        "boton IZQUIERDO abajo 100 150; arrastra 101 150; boton IZQUIERDO arriba 101 150"); // arrastrar no elige
    guiones.push_back("boton IZQUIERDO abajo 3 3; boton IZQUIERDO arriba 3 3");             // y fuera tampoco
    const auto gpu = imagenes("componentes_phong", guiones, 480, 360);
    for (std::size_t i = 0; i < 5; ++i) {
        const glm::ivec2 &c = clics[std::min<std::size_t>(i, 2)];
        const Impacto impacto = oraculo::primerImpacto(
            {oraculo::esfera(Mat4())}, oraculo::rayo(camaraDelPanel(), 239, 360, c.x + 0.5, 359.5 - c.y));
        ASSERT_TRUE(impacto);
        const DeLado d(impacto.punto, i < 3 ? Vec3{0, 0, 10} : camaraDelPanel().ojo + Vec3{-0.1, 0, 0});
        d.compruebaVector(gpu[i], "N", d.N, BLANCO);
        d.compruebaVector(gpu[i], "L", d.L, AMARILLO);
        d.compruebaVector(gpu[i], "R", d.R, ROJO);
        d.compruebaVector(gpu[i], "V", d.V, VERDE);
        const Vec3 numeros = d.enPanel(-0.4 * d.N);
        EXPECT_TRUE(seLee(gpu[i], DeLado::grados("θ", d.L, d.N), BLANCO, numeros.x, numeros.y - 13, 20)) << i;
        EXPECT_TRUE(seLee(gpu[i], DeLado::grados("Φ", d.R, d.V), BLANCO, numeros.x, numeros.y - 33, 20)) << i;
        // la P, a la derecha de su punto
        EXPECT_TRUE(i >= 3 || seLee(gpu[i], "P", OSCURO, c.x + 11, 359.5 - c.y, 4)) << i;
        const Vec3 theta = d.enPanel(0.56 * oraculo::unitario(d.L + d.N)),
                   phi = d.enPanel(0.875 * oraculo::unitario(d.R + d.V));
        EXPECT_TRUE(seLee(gpu[i], "θ", AMARILLO, theta.x, theta.y, 4)) << i;
        EXPECT_TRUE(seLee(gpu[i], "Φ", ROJO, phi.x, phi.y, 4)) << i;
    }
}

// De espaldas a la luz θ pasa de 90 grados y no hay R ni Φ.
TEST(ComponentesPhong, DeEspaldasALaLuzNoHayR) {
    const auto gpu =
        imagenes("componentes_phong",
                 {"tecla n; boton IZQUIERDO abajo 172 200; boton IZQUIERDO arriba 172 200"}, 480, 360);
    const Impacto impacto = oraculo::primerImpacto({oraculo::esfera(Mat4())},
                                                   oraculo::rayo(camaraDelPanel(), 239, 360, 172.5, 159.5));
    ASSERT_TRUE(impacto);
    const DeLado d(impacto.punto);
    ASSERT_LT(oraculo::escalar(d.N, d.L), 0);
    const Vec3 numeros = d.enPanel(-0.4 * d.N);
    EXPECT_TRUE(seLee(gpu[0], DeLado::grados("θ", d.L, d.N), BLANCO, numeros.x, numeros.y - 13, 20));
    EXPECT_TRUE(leeRotulo(gpu[0], "R", ROJO).empty());
    EXPECT_TRUE(leeRotulo(gpu[0], "Φ", ROJO).empty());
}

// --- exponente_brillo --------------------------------------------------------------------------------------

namespace {

struct EsferaBrillo {
    Vec3 centro;
    double radio;
    int alfa;
    Mat4 M() const {
        return traslada(centro) * escala(radio);
    }
};
const EsferaBrillo ESFERAS_BRILLO[] = {{{-2.12, 1.5, 0}, 1, 1},
                                       {{0, 1.5, 0}, 1, 5},
                                       {{2.12, 1.5, 0}, 1, 20},
                                       {{-1.5, -1.02, 0}, 1.45, 100},
                                       {{1.5, -1.02, 0}, 1.45, 500}};
const Camara CAMARA_BRILLO = oraculo::perspectiva(oraculo::orbita(0, 0, 17), 0.31, 1, 100);

/// Cada esfera lleva escrita su α, 0.7 radios por debajo del centro. Sin ellas, en una imagen con la referencia en su lugar.
Imagen sinAlfas(const Imagen &imagen, const ImagenRef &ref) {
    SinEncima sin(imagen, ref);
    for (const EsferaBrillo &e : ESFERAS_BRILLO) {
        const Vec3 p =
            oraculo::proyecta(CAMARA_BRILLO, imagen.ancho, imagen.alto, e.centro - Vec3{0, 0.7 * e.radio, 0});
        EXPECT_TRUE(sin.rotulo("α = " + std::to_string(e.alfa), BLANCO, p.x, p.y, 2)) << e.alfa;
    }
    return sin.limpia;
}

} // namespace

// En cada esfera, lo que queda al quitar ambiente y difusa es Ks·cos^alfa.
TEST(ExponenteBrillo, PerfilContraCosenoElevadoAAlfa) {
    const Vec3 ka{0.09, 0.02, 0.03}, kd{0.44, 0.07, 0.10}, L = oraculo::unitario({-0.45, 0.60, 1});
    const double ks = 0.85;
    Escena escena;
    for (const EsferaBrillo &e : ESFERAS_BRILLO)
        escena.push_back(oraculo::esfera(e.M()));
    const Camara &camara = CAMARA_BRILLO;
    const Ejecucion e = ejecuta("ch05_iluminacion/exponente_brillo", "", 480, 360);
    ASSERT_EQ(e.estado, 0) << e.errores;
    double maximo[5] = {}, brillo[5] = {};
    for (int y = 0; y < 360; ++y)
        for (int x = 0; x < 480; ++x) {
            const Impacto i =
                oraculo::primerImpacto(escena, oraculo::rayo(camara, 480, 360, x + 0.5, y + 0.5));
            if (!i || oraculo::escalar(i.normal, -i.rayo.direccion) < 0.15 || i.normal.y < -0.5)
                continue; // fondo, silueta y la parte de abajo, donde está el rótulo
            const double NL = std::max(oraculo::escalar(i.normal, L), 0.0);
            const Vec3 R = 2 * NL * i.normal - L;
            const double coseno = std::max(oraculo::escalar(R, -i.rayo.direccion), 0.0);
            const auto k = static_cast<std::size_t>(i.objeto);
            const double esperado = NL > 0 ? std::pow(coseno, ESFERAS_BRILLO[k].alfa) : 0;
            const double verde = pixel(e.imagen, x, y).g / 255.0;
            const double medido = (verde - ka.y - NL * kd.y) / ks;
            if (verde < 1)
                maximo[k] = std::max(maximo[k], 255 * ks * std::fabs(medido - esperado));
            brillo[k] = std::max(brillo[k], medido);
        }
    for (std::size_t k = 0; k < 5; ++k) {
        std::cout << "alfa " << ESFERAS_BRILLO[k].alfa << ": error máximo " << maximo[k]
                  << " niveles; brillo " << brillo[k] << "\n";
        EXPECT_LE(maximo[k], 2) << ESFERAS_BRILLO[k].alfa;
        EXPECT_GT(brillo[k], 0.9) << ESFERAS_BRILLO[k].alfa;
    }
}

TEST(ExponenteBrillo, ContraTrazadoDeRayos) {
    const auto gpu = imagenes("exponente_brillo", {"espera 0"});
    for (const bool mismaMalla : {true, false}) {
        Escena escena;
        std::vector<Material> materiales;
        for (const EsferaBrillo &e : ESFERAS_BRILLO) {
            escena.push_back(unaEsfera(e.M(), mismaMalla ? segmentosEsfera(200) : 0));
            materiales.push_back(
                {{0.09, 0.02, 0.03}, {0.44, 0.07, 0.10}, {0.85, 0.85, 0.85}, static_cast<double>(e.alfa)});
        }
        const ImagenRef ref =
            traza(escena, materiales, {direccional({-0.45, 0.60, 1})}, CAMARA_BRILLO, FONDO);
        comprueba("cinco alfas", sinAlfas(gpu[0], ref), ref, mismaMalla ? MISMA_MALLA : EXACTA, mismaMalla);
    }
}

// --- materiales --------------------------------------------------------------------------------------------

namespace {

/// La tabla 5.1 tal como se imprime: el último número es su alfa.
const Material TABLA[12] = {{{0.022, 0.17, 0.02}, {0.08, 0.61, 0.08}, {0.63, 0.73, 0.63}, 0.6},  // esmeralda
                            {{0.14, 0.22, 0.16}, {0.54, 0.89, 0.63}, {0.32, 0.32, 0.32}, 0.10},  // jade
                            {{0.05, 0.05, 0.07}, {0.18, 0.17, 0.23}, {0.33, 0.33, 0.35}, 0.30},  // obsidiana
                            {{0.25, 0.21, 0.21}, {1.0, 0.83, 0.83}, {0.30, 0.30, 0.30}, 0.09},   // perla
                            {{0.18, 0.01, 0.01}, {0.61, 0.04, 0.04}, {0.73, 0.63, 0.63}, 0.60},  // rubí
                            {{0.10, 0.19, 0.17}, {0.39, 0.74, 0.69}, {0.29, 0.31, 0.31}, 0.10},  // turquesa
                            {{0.21, 0.13, 0.05}, {0.71, 0.43, 0.18}, {0.39, 0.27, 0.17}, 0.20},  // bronce
                            {{0.19, 0.07, 0.02}, {0.71, 0.27, 0.08}, {0.26, 0.14, 0.09}, 0.10},  // cobre
                            {{0.25, 0.20, 0.07}, {0.75, 0.61, 0.23}, {0.63, 0.56, 0.37}, 0.40},  // oro
                            {{0.20, 0.20, 0.20}, {0.51, 0.51, 0.51}, {0.51, 0.51, 0.51}, 0.40},  // plata
                            {{0.0, 0.0, 0.0}, {0.55, 0.55, 0.55}, {0.70, 0.70, 0.70}, 0.25},     // plástico
                            {{0.05, 0.05, 0.05}, {0.50, 0.50, 0.50}, {0.70, 0.70, 0.70}, 0.08}}; // goma

const Vec3 LUZ_MATERIALES{-0.9, 0.9, 1};
const Camara CAMARA_MATERIALES = oraculo::perspectiva(oraculo::orbita(0, 0, 26, {0, -0.25, 0}), 0.31, 1, 100);

std::vector<Material> tabla(double porAlfa) {
    std::vector<Material> m(TABLA, TABLA + 12);
    for (Material &material : m)
        material.alfa *= porAlfa;
    return m;
}

const char *const NOMBRES_MATERIALES[12] = {"Esmeralda", "Jade",     "Obsidiana", "Perla",
                                            "Rubí",      "Turquesa", "Bronce",    "Cobre",
                                            "Oro",       "Plata",    "Plástico",  "Goma"};

Vec3 centroMaterial(int i) {
    return {2.6 * (i % 4 - 1.5), 2.65 * (1 - i / 4), 0};
}

Escena doceEsferas(int n) {
    Escena escena;
    for (int i = 0; i < 12; ++i)
        escena.push_back(unaEsfera(traslada(centroMaterial(i)), n));
    return escena;
}

/// Bajo la esfera está el nombre de su material.
void quitaNombre(SinEncima &sin, std::size_t i, const Vec3 &centro, double radio) {
    const Vec3 p =
        oraculo::proyecta(CAMARA_MATERIALES, sin.limpia.ancho, sin.limpia.alto, centro - Vec3{0, radio, 0});
    EXPECT_TRUE(sin.rotulo(NOMBRES_MATERIALES[i], BLANCO, p.x, p.y - 6, 3)) << NOMBRES_MATERIALES[i];
}

} // namespace

TEST(Materiales, CentroDeCadaEsferaContraLaEcuacion56) {
    const Ejecucion e = ejecuta("ch05_iluminacion/materiales");
    ASSERT_EQ(e.estado, 0) << e.errores;
    const std::vector<Material> materiales = tabla(128);
    const Escena escena = doceEsferas(0);
    for (int i = 0; i < 12; ++i) {
        const Vec3 p = oraculo::proyecta(CAMARA_MATERIALES, 240, 180, centroMaterial(i));
        const int x = static_cast<int>(p.x), y = static_cast<int>(p.y);
        const Impacto centro =
            oraculo::primerImpacto(escena, oraculo::rayo(CAMARA_MATERIALES, 240, 180, x + 0.5, y + 0.5));
        ASSERT_EQ(centro.objeto, i);
        const Vec3 color =
            oraculo::phong(materiales[static_cast<std::size_t>(i)], BLANCA, {direccional(LUZ_MATERIALES)},
                           centro.punto, centro.normal, -centro.rayo.direccion);
        EXPECT_LE(oraculo::diferencia(e.imagen, x, y, color), 1) << "material " << i;
    }
}

TEST(Materiales, ContraTrazadoDeRayos) {
    const Luz luz = direccional(LUZ_MATERIALES);
    std::vector<std::string> guiones(13, "tecla n"); // el decimotercero vuelve a ser el primero
    guiones.push_back("tecla t");
    const auto gpu = imagenes("materiales", guiones);
    for (std::size_t i = 0; i < 13; ++i) {
        const ImagenRef ref =
            traza({unaEsfera(escala(3), 0)}, {tabla(128)[i % 12]}, {luz}, CAMARA_MATERIALES, FONDO);
        SinEncima sin(gpu[i], ref);
        quitaNombre(sin, i % 12, {}, 3);
        comprueba("material " + std::to_string(i), sin.limpia, ref, EXACTA, false);
    }
    for (const bool mismaMalla : {true, false}) {
        const ImagenRef ref = traza(doceEsferas(mismaMalla ? segmentosEsfera(95) : 0), tabla(128), {luz},
                                    CAMARA_MATERIALES, FONDO);
        SinEncima sin(gpu[13], ref);
        for (std::size_t i = 0; i < 12; ++i)
            quitaNombre(sin, i, centroMaterial(static_cast<int>(i)), 1);
        comprueba("todos", sin.limpia, ref, mismaMalla ? MISMA_MALLA : EXACTA, mismaMalla);
    }
}

// El brillo de la tabla va de 0.08 a 0.6. Tomado por alfa, el especular cubre toda la mitad iluminada: más de
// la tercera parte de cada esfera, también de la plata, sería brillo. Como fracción de 128 es una mancha, y
// la goma (0.08) sale con alfa 10, no 0.08.
TEST(Materiales, ElBrilloDeLaTablaEsUnaFraccionDe128) {
    const auto parteBrillante = [&](double porAlfa, std::size_t i) {
        const Escena escena = {unaEsfera(escala(3), 0)};
        const Material soloBrillo = {{}, {}, {1, 1, 1}, TABLA[i].alfa * porAlfa};
        const ImagenRef ref =
            traza(escena, {soloBrillo}, {direccional(LUZ_MATERIALES)}, CAMARA_MATERIALES, {});
        int brillan = 0, total = 0;
        for (const oraculo::PixelRef &p : ref.pixeles)
            total += p.objeto == 0, brillan += p.color.x > 0.5;
        return static_cast<double>(brillan) / total;
    };
    for (std::size_t i = 0; i < 12; ++i) {
        std::cout << "material " << i << ": brilla el " << 100 * parteBrillante(1, i)
                  << " % con la tabla por alfa y el " << 100 * parteBrillante(128, i) << " % por 128\n";
        EXPECT_GT(parteBrillante(1, i), 0.33);
        EXPECT_LT(parteBrillante(128, i), 0.06);
    }
    EXPECT_NEAR(TABLA[11].alfa * 128, 10, 0.5); // 10/128 = 0.078, que redondeado es el 0.08 de la tabla
}

// --- fuentes -----------------------------------------------------------------------------------------------

namespace {

const Vec3 POSICION{-0.9, 3.3, 1.1}, APUNTA{0.3, 0, 0};
const double DELTA = PI / 6;
const Camara CAMARA_FUENTES =
    oraculo::perspectiva(oraculo::orbita(0.35, 0.5, 19, {0, 0.75, 0}), 0.35, 1, 100);
const Mat4 TUMBADO = gira(X, -PI / 2);

/// El cono de radio y altura 1 con n caras y sus normales, que suben 45 grados. En el vértice exacto no hay normal, y la que
/// se interpola en una cara depende de cuántas haya: por eso no sirve oraculo::cono.
oraculo::Objeto conoDeCaras(const Mat4 &M, std::size_t n) {
    std::vector<oraculo::VerticeRef> vertices;
    std::vector<oraculo::Triangulos::Indices> indices;
    for (std::size_t i = 0; i <= n; ++i) {
        const double a = 2 * PI * static_cast<double>(i) / static_cast<double>(n);
        const Vec3 normal = oraculo::unitario({std::cos(a), std::sin(a), 1});
        vertices.push_back({{std::cos(a), std::sin(a), 0}, normal});
        vertices.push_back({{0, 0, 1}, normal});
        if (i > 0)
            indices.push_back({2 * i - 2, 2 * i, 2 * i + 1});
    }
    return oraculo::malla(M, vertices, indices);
}

/// Suelo y objetos: las formas exactas o, con n y m segmentos, las mallas.
ImagenRef fuentes(int tipo, double exponente, double delta, bool mismaMalla) {
    const Vec3 S = oraculo::unitario(APUNTA - POSICION);
    const int n = segmentosEsfera(100);
    const Escena escena = {
        oraculo::plano(TUMBADO * escala(6)),
        unaEsfera(traslada({0.3, 0.8, 0.2}) * escala(0.8), mismaMalla ? n : 0),
        conoDeCaras(traslada({2.0, 0, -1.2}) * TUMBADO * escala(0.8, 0.8, 1.9), static_cast<std::size_t>(n)),
        oraculo::caja(traslada({-1.7, 0.6, -1.1}) * gira(Y, 0.5) * escala(1.2)),
        unToro(traslada({1.5, 0.25, 1.9}) * TUMBADO, 0.7, 0.25, mismaMalla ? segmentosEsfera(400) : 0,
               segmentosEsfera(100)),
    };
    const std::vector<Material> materiales = {
        {{0.20, 0.21, 0.23}, {0.62, 0.64, 0.68}, {0.15, 0.15, 0.15}, 20},
        {{0.18, 0.05, 0.05}, {0.75, 0.18, 0.16}, {0.60, 0.60, 0.60}, 50},
        {{0.05, 0.15, 0.07}, {0.18, 0.62, 0.28}, {0.50, 0.50, 0.50}, 50},
        {{0.05, 0.10, 0.20}, {0.16, 0.40, 0.80}, {0.60, 0.60, 0.60}, 50},
        {{0.19, 0.11, 0.03}, {0.80, 0.46, 0.10}, {0.50, 0.50, 0.50}, 50},
    };
    const Luz luz = tipo == 1   ? posicional(POSICION)
                    : tipo == 2 ? direccional(-S)
                                : foco(POSICION, APUNTA, delta, exponente);
    ImagenRef ref = traza(escena, materiales, {luz}, CAMARA_FUENTES, FONDO, 320, 240);
    for (std::size_t k = 0; k < ref.pixeles.size();
         ++k) // entre dos caras del cono hay un salto de normal: son zonas
        if (ref.pixeles[k].objeto == 2) {
            const double x = static_cast<double>(k % 320) + 0.5, y = static_cast<double>(k / 320) + 0.5;
            const Impacto i = oraculo::primerImpacto(escena, oraculo::rayo(CAMARA_FUENTES, 320, 240, x, y));
            ref.pixeles[k].zona += 2 * i.corte.triangulo;
        }
    return ref;
}

/// La fuente dibujada: un punto, tres flechas paralelas a S, o un punto, el cono de ese ángulo y S. Comprueba que está y la
/// quita, con los rótulos. De lo que no tapan los objetos se debe ver casi todo.
Imagen sinFuente(const Imagen &imagen, const ImagenRef &ref, int tipo, int grados,
                 const std::string &nombre) {
    SinEncima sin(imagen, ref);
    const Vec3 S = oraculo::unitario(APUNTA - POSICION), u = oraculo::unitario(oraculo::vectorial(S, X)),
               v = oraculo::vectorial(S, u);
    const Vec3 p = oraculo::proyecta(CAMARA_FUENTES, 320, 240, POSICION);
    if (tipo == 2)
        for (const Vec3 &donde : {Vec3{-0.8, 0, -0.5}, Vec3{}, Vec3{0.8, 0, 0.5}})
            EXPECT_GT(
                sin.trazo(CAMARA_FUENTES, {POSICION + donde, POSICION + donde + 1.4 * S}, AMARILLO, 4.5),
                0.9);
    else
        EXPECT_EQ(sin.trazo(CAMARA_FUENTES, {POSICION, POSICION + 0.001 * S}, AMARILLO, 4.5), 1);
    if (tipo == 3) {
        const double delta = grados * PI / 180;
        std::vector<Vec3> borde;
        for (int i = 0; i <= 64; ++i) {
            const double a = i * PI / 32;
            borde.push_back(POSICION + 1.4 * (std::cos(delta) * S +
                                              std::sin(delta) * (std::cos(a) * u + std::sin(a) * v)));
            sin.trazo(CAMARA_FUENTES, {POSICION, borde.back()}, AMARILLO);
        }
        EXPECT_TRUE(sin.trazo(CAMARA_FUENTES, borde, AMARILLO) > 0.75 || grados == 0) << grados;
        EXPECT_GT(sin.trazo(CAMARA_FUENTES, {POSICION, POSICION + 1.8 * S}, BLANCO, 4.5), 0.75);
        const Vec3 punta = oraculo::proyecta(CAMARA_FUENTES, 320, 240, POSICION + 1.82 * S);
        EXPECT_TRUE(sin.rotulo("S", BLANCO, punta.x + 6, punta.y, 4)) << grados;
        EXPECT_TRUE(sin.rotulo("δ = " + std::to_string(grados) + "°", BLANCO, p.x - 25, p.y, 6)) << grados;
    }
    EXPECT_TRUE(sin.rotulo(nombre, BLANCO, 316 - 3 * static_cast<double>(nombre.size()), 228, 4)) << nombre;
    return sin.limpia;
}

} // namespace

TEST(Fuentes, LosTresTiposContraTrazadoDeRayos) {
    const auto gpu = imagenes("fuentes", {"tecla 1", "tecla 2", "tecla 3"}, 320, 240);
    const char *const nombres[] = {"posicional", "direccional", "foco, exponente 4"};
    for (int tipo = 1; tipo <= 3; ++tipo)
        for (const bool mismaMalla : {true, false}) {
            const ImagenRef ref = fuentes(tipo, 4, DELTA, mismaMalla);
            comprueba(nombres[tipo - 1],
                      sinFuente(gpu[static_cast<std::size_t>(tipo - 1)], ref, tipo, 30, nombres[tipo - 1]),
                      ref, mismaMalla ? MISMA_MALLA : EXACTA, mismaMalla);
        }
}

TEST(Fuentes, ElExponenteConcentraLaLuz) {
    const auto gpu =
        imagenes("fuentes",
                 {"tecla 3; tecla +; tecla +", "tecla -; tecla -; tecla -; tecla -; tecla -; tecla -",
                  "tecla +; tecla +; tecla +; tecla +; tecla +; tecla +; tecla +; tecla +"},
                 320, 240);
    const double exponentes[] = {16, 0.5, 64};
    const char *const nombres[] = {"foco, exponente 16", "foco, exponente 0.5", "foco, exponente 64"};
    for (std::size_t i = 0; i < 3; ++i) {
        const ImagenRef ref = fuentes(3, exponentes[i], DELTA, true);
        comprueba(nombres[i], sinFuente(gpu[i], ref, 3, 30, nombres[i]), ref, MISMA_MALLA, true);
    }
}

// Las teclas , y . cierran y abren el cono de 5 en 5 grados, entre 0 y 90, y con él lo iluminado.
TEST(Fuentes, ElAnguloDelCono) {
    std::string veinte = "tecla .";
    for (int i = 0; i < 20; ++i)
        veinte += "; tecla .";
    std::string otrosVeinte = veinte;
    std::replace(otrosVeinte.begin(), otrosVeinte.end(), '.', ',');
    const auto gpu =
        imagenes("fuentes", {"tecla 3; tecla ,", "tecla .; tecla .; tecla .", veinte, otrosVeinte}, 320, 240);
    const int grados[] = {25, 40, 90, 0};
    for (std::size_t i = 0; i < 4; ++i) {
        const ImagenRef ref = fuentes(3, 4, grados[i] * PI / 180, true);
        comprueba("δ = " + std::to_string(grados[i]),
                  sinFuente(gpu[i], ref, 3, grados[i], "foco, exponente 4"), ref, MISMA_MALLA, true);
    }
}

// Por mucho que se arrastre, la cámara no baja del suelo: la cara de abajo, sin luz, no se ve.
TEST(Fuentes, NoSeMiraDesdeDebajoDelSuelo) {
    const auto gpu = imagenes(
        "fuentes", {"boton IZQUIERDO abajo 100 200; arrastra 100 -2000; boton IZQUIERDO arriba 100 -2000"});
    Camara camara = oraculo::perspectiva(oraculo::orbita(0.35, 0.05, 19, {0, 0.75, 0}), 0.35, 1, 100);
    const Vec3 p =
        oraculo::proyecta(camara, 240, 180, {0.3, 0.8, 0.2}); // la esfera roja, vista desde casi el suelo
    const Pixel rojo = pixel(gpu[0], static_cast<int>(p.x), static_cast<int>(p.y));
    EXPECT_GT(rojo.r, 2 * rojo.g);
    const Vec3 bajo = oraculo::proyecta(camara, 240, 180, {0.3, 0, 2.9});
    EXPECT_TRUE(esColor(gpu[0], static_cast<int>(bajo.x), static_cast<int>(bajo.y) - 3, FONDO_OSCURO));
}

// El borde del cono en el suelo: cada píxel está iluminado si y solo si el ángulo exacto con el eje es menor
// que delta, salvo los que el borde cruza. La pantalla del foco y los objetos quedan fuera.
TEST(Fuentes, BordeDelConoContraElAnguloExacto) {
    const int ancho = 800, alto = 600;
    const Ejecucion e = ejecuta("ch05_iluminacion/fuentes", "tecla 3", ancho, alto);
    ASSERT_EQ(e.estado, 0) << e.errores;
    const Luz luz = foco(POSICION, APUNTA, DELTA, 4);
    const double enElBorde = std::pow(std::cos(DELTA), 4); // lo que aún alumbra el foco junto al borde
    int dentro = 0, fuera = 0, dudosos = 0, mal = 0;
    const Escena suelo = {oraculo::plano(TUMBADO * escala(6))};
    const auto angulo = [&](double px, double py) {
        const Impacto i = oraculo::primerImpacto(suelo, oraculo::rayo(CAMARA_FUENTES, ancho, alto, px, py));
        const Vec3 v = oraculo::unitario(i.punto - luz.posicion);
        return i ? std::atan2(oraculo::longitud(oraculo::vectorial(v, luz.S)), oraculo::escalar(v, luz.S))
                 : 9;
    };
    for (int y = 0; y < alto; ++y)
        for (int x = 0; x < ancho; ++x) {
            const double a = angulo(x + 0.5, y + 0.5);
            const Pixel p = pixel(e.imagen, x, y);
            // solo el suelo, que es gris azulado: el ambiente es (51, 54, 59)
            if (a > 1.2 || std::abs(p.g - p.r - 2) > 3 || std::abs(p.b - p.g - 5) > 5 || p.r > 240 ||
                esColor(e.imagen, x, y, OSCURO))
                continue;
            double minimo = a, maximo = a;
            for (const double dx : {0.0, 1.0})
                for (const double dy : {0.0, 1.0}) {
                    minimo = std::min(minimo, angulo(x + dx, y + dy));
                    maximo = std::max(maximo, angulo(x + dx, y + dy));
                }
            const bool iluminado = p.r > 63;
            if (maximo < DELTA)
                ++dentro, mal += !iluminado;
            else if (minimo > DELTA)
                ++fuera, mal += iluminado;
            else
                ++dudosos;
        }
    std::cout << "cono: " << dentro << " px dentro, " << fuera << " fuera, " << dudosos << " en el borde, "
              << mal << " mal; en el borde llega " << enElBorde << "\n";
    EXPECT_EQ(mal, 0);
    EXPECT_GT(dentro, 10000);
    EXPECT_GT(fuera, 10000);
    EXPECT_LT(dudosos, 1500);
}

// --- atenuacion --------------------------------------------------------------------------------------------

namespace {

const Camara CAMARA_ATENUACION =
    oraculo::perspectiva(oraculo::orbita(-0.45, 0.3, 21, {3.0, 1.2, 0}), 0.28, 1, 100);
const Material SUELO_ATENUACION = {{0.05, 0.05, 0.06}, {0.55, 0.57, 0.60}, {}, 1};

Escena escenaAtenuacion(int n) {
    Escena escena = {oraculo::plano(traslada({3, -0.42, 0}) * TUMBADO * escala(7.2, 2, 1)),
                     unaEsfera(escala(0.2), n)};
    for (int d = 1; d <= 6; ++d)
        escena.push_back(unaEsfera(traslada({static_cast<double>(d), 0, 0}) * escala(0.42), n));
    return escena;
}

Luz luzAtenuacion(int modo) {
    Luz luz = posicional({0, 0, 0});
    luz.b = modo == 2 ? 1 / 3.0 : 0, luz.c = modo == 3 ? 1 / 9.0 : 0;
    return luz;
}

/// El punto de la curva: empieza a 0.8 sobre la fila, y 1 son 2.2 de alto.
Vec3 enCurva(int modo, double d) {
    const Luz luz = luzAtenuacion(modo);
    return {d, 0.8 + 2.2 / (luz.a + luz.b * d + luz.c * d * d), 0};
}

/// Los ejes, las tres curvas (la elegida, amarilla), el valor sobre cada esfera, su distancia y la fórmula: comprueba que
/// están y los quita.
Imagen sinCurvas(const Imagen &imagen, const ImagenRef &ref, int modo) {
    SinEncima sin(imagen, ref);
    const auto rotulo = [&](const std::string &texto, const Vec3 &punto, double dx, double dy,
                            const glm::vec3 &color) {
        const Vec3 p = oraculo::proyecta(CAMARA_ATENUACION, imagen.ancho, imagen.alto, punto);
        EXPECT_TRUE(sin.rotulo(texto, color, p.x + dx, p.y + dy, 4)) << texto;
    };
    EXPECT_GT(sin.trazo(CAMARA_ATENUACION, {{0, 0.8, 0}, {0, 0.8 + 1.2 * 2.2, 0}}, BLANCO, 4.5), 0.9);
    EXPECT_GT(sin.trazo(CAMARA_ATENUACION, {{0, 0.8, 0}, {6.8, 0.8, 0}}, BLANCO, 4.5), 0.9);
    for (int k = 1; k <= 3; ++k) {
        std::vector<Vec3> curva;
        for (double d = 0; d < 6.6; d += 0.1)
            curva.push_back(enCurva(k, d));
        EXPECT_GT(sin.trazo(CAMARA_ATENUACION, curva, k == modo ? AMARILLO : GRIS), 0.8) << k;
    }
    for (int d = 1; d <= 6; ++d) {
        const Vec3 valor = enCurva(modo, d);
        EXPECT_GT(sin.trazo(CAMARA_ATENUACION, {{valor.x, 0.8, 0}, valor}, AMARILLO), 0.9) << d;
        sin.trazo(CAMARA_ATENUACION, {valor, valor + Vec3{0, 0.001, 0}}, AMARILLO, 3.5);
        rotulo(std::to_string(d), {valor.x, -0.42, 1}, 0, -6, BLANCO);
    }
    rotulo("1", {0, 3, 0}, -6, 0, BLANCO);
    rotulo("d", {6.8, 0.8, 0}, 6, 0, BLANCO);
    const char *const formulas[] = {"1", "1/(1 + d/3)", "1/(1 + d²/9)"};
    rotulo(formulas[modo - 1], {3, 0.8 + 1.2 * 2.2, 0}, 0, 6, AMARILLO);
    return sin.limpia;
}

} // namespace

TEST(Atenuacion, ContraTrazadoDeRayos) {
    const auto gpu = imagenes("atenuacion", {"tecla 1", "tecla 2", "tecla 3"});
    for (int modo = 1; modo <= 3; ++modo)
        for (const bool mismaMalla : {true, false}) {
            const Escena escena = escenaAtenuacion(mismaMalla ? segmentosEsfera(70) : 0);
            std::vector<Material> materiales = {SUELO_ATENUACION, {{1.00, 0.93, 0.60}, {}, {}, 1}};
            materiales.resize(escena.size(),
                              {{0.14, 0.08, 0.02}, {0.84, 0.50, 0.12}, {0.30, 0.30, 0.30}, 20});
            const ImagenRef ref = traza(escena, materiales, {luzAtenuacion(modo)}, CAMARA_ATENUACION, FONDO);
            comprueba("modo " + std::to_string(modo),
                      sinCurvas(gpu[static_cast<std::size_t>(modo - 1)], ref, modo), ref,
                      mismaMalla ? MISMA_MALLA : EXACTA, mismaMalla);
        }
}

// A lo largo de una línea del suelo, el factor que se deduce de la imagen es 1/(a + b·d + c·d²). La cota:
// medio nivel de redondeo en la imagen, dividido por lo que el suelo refleja.
TEST(Atenuacion, FactorALoLargoDeUnaLinea) {
    const int ancho = 640, alto = 480;
    const Escena escena = escenaAtenuacion(0);
    const auto gpu = imagenes("atenuacion", {"tecla 1", "tecla 2", "tecla 3"}, ancho, alto);
    for (int modo = 1; modo <= 3; ++modo) {
        const Luz luz = luzAtenuacion(modo);
        double peor = 0, cerca = 1e9, lejos = 0;
        int puntos = 0;
        for (double x = -0.5; x <= 6.5; x += 0.02) {
            const Vec3 p = oraculo::proyecta(CAMARA_ATENUACION, ancho, alto, {x, -0.42, 0.75});
            const int px = static_cast<int>(std::floor(p.x)), py = static_cast<int>(std::floor(p.y));
            if (px < 0 || px >= ancho)
                continue;
            const Impacto i = oraculo::primerImpacto(
                escena, oraculo::rayo(CAMARA_ATENUACION, ancho, alto, px + 0.5, py + 0.5));
            ASSERT_EQ(i.objeto, 0) << "la línea debe estar despejada";
            const Vec3 v = -i.punto;
            const double d = oraculo::longitud(v), NL = v.y / d;
            const int rojo = pixel(gpu[static_cast<std::size_t>(modo - 1)], px, py).r;
            if (rojo == 255)
                continue; // saturado
            const double medido = (rojo / 255.0 - SUELO_ATENUACION.ka.x) / (SUELO_ATENUACION.kd.x * NL);
            const double exacto = 1 / (luz.a + luz.b * d + luz.c * d * d);
            const double cota = 0.51 / (255 * SUELO_ATENUACION.kd.x * NL);
            EXPECT_LE(std::fabs(medido - exacto), cota) << "modo " << modo << ", d = " << d;
            peor = std::max(peor, std::fabs(medido - exacto) / cota);
            cerca = std::min(cerca, d), lejos = std::max(lejos, d);
            ++puntos;
        }
        std::cout << "modo " << modo << ": " << puntos << " puntos de d = " << cerca << " a " << lejos
                  << "; peor error, " << peor << " de la cota\n";
        EXPECT_GT(puntos, 150);
        EXPECT_GT(lejos, 6);
    }
}

// --- varias_luces ------------------------------------------------------------------------------------------

namespace {

std::vector<Luz> tresFocos(bool roja, bool verde, bool azul) {
    const bool encendida[] = {roja, verde, azul};
    const Vec3 colores[] = {{1.0, 0.08, 0.05}, {0.08, 1.0, 0.10}, {0.06, 0.12, 1.0}};
    const double exponentes[] = {2, 3, 4};
    std::vector<Luz> luces;
    for (int i = 0; i < 3; ++i) {
        const double a = (-150 + 120 * i) * PI / 180;
        const Vec3 hacia{std::cos(a), 0, -std::sin(a)};
        Luz luz = foco(3 * hacia + Vec3{0, 5, 0}, 1.1 * hacia, 0.40, exponentes[i]);
        luz.Ld = luz.Ls = encendida[i] ? colores[i] : Vec3{};
        luz.a = 0.6, luz.b = 0.04, luz.c = 0.01;
        luces.push_back(luz);
    }
    return luces;
}

const Camara CAMARA_VARIAS = oraculo::perspectiva(oraculo::orbita(0, 0.8, 17.5, {0, -0.3, 0}), 0.36, 1, 100);

ImagenRef variasLuces(const std::vector<Luz> &luces, bool mismaMalla) {
    const Escena escena = {
        oraculo::cilindro(traslada({0, -0.1, 0}) * TUMBADO * escala(3.7, 3.7, 0.2)),
        unaEsfera(traslada({0, 0.8, 0}) * escala(0.8), mismaMalla ? segmentosEsfera(100) : 0)};
    const Material mate = {{0.13, 0.13, 0.14}, {0.80, 0.80, 0.80}, {}, 1},
                   brillante = {{0.12, 0.12, 0.13}, {0.60, 0.60, 0.60}, {0.30, 0.30, 0.30}, 40};
    return traza(escena, {mate, brillante}, luces, CAMARA_VARIAS, FONDO);
}

/// Dónde va el rótulo de cada luz: en el disco, hacia su foco.
Vec3 rotuloDeLuz(int i) {
    const double a = (-150 + 120 * i) * PI / 180;
    return oraculo::proyecta(CAMARA_VARIAS, 240, 180, {2.5 * std::cos(a), 0, -2.5 * std::sin(a)});
}

} // namespace

TEST(VariasLuces, ContraTrazadoDeRayos) {
    const auto gpu = imagenes("varias_luces", {"espera 0", "tecla 2; tecla 3", "tecla 1; tecla 2; tecla 3"});
    const bool encendidas[3][3] = {{true, true, true}, {true, false, false}, {false, true, true}};
    const char *const nombres[] = {"1 roja", "2 verde", "3 azul"}, *const apagadas[] = {
                                                                       "1 apagada", "2 apagada", "3 apagada"};
    for (const bool mismaMalla : {true, false})
        for (std::size_t k = 0; k < 3; ++k) {
            const bool *const e = encendidas[k];
            const ImagenRef ref = variasLuces(tresFocos(e[0], e[1], e[2]), mismaMalla);
            SinEncima sin(gpu[k], ref);
            for (int i = 0; i < 3; ++i) {
                const Vec3 p = rotuloDeLuz(i);
                EXPECT_TRUE(sin.rotulo(e[i] ? nombres[i] : apagadas[i], e[i] ? BLANCO : GRIS, p.x, p.y, 2))
                    << i;
            }
            comprueba("luces " + std::to_string(k), sin.limpia, ref, mismaMalla ? MISMA_MALLA : EXACTA,
                      mismaMalla);
        }
}

// Todas = roja + verde + azul − 2·ambiente, píxel a píxel. Cada imagen está redondeada a medio nivel, y son
// seis sumandos contando dos veces la ambiente: la diferencia no puede pasar de 3.
TEST(VariasLuces, LaImagenDeTodasEsLaSuma) {
    const auto gpu = imagenes(
        "varias_luces", {"espera 0", "tecla 2; tecla 3", "tecla 1; tecla 2", "tecla 2; tecla 3", "tecla 3"});
    const auto &todas = gpu[0].rgb, &roja = gpu[1].rgb, &verde = gpu[2].rgb, &azul = gpu[3].rgb,
               &ambiente = gpu[4].rgb;
    int mayor = 0, saturados = 0, mayorUnaAmbiente = 0;
    for (std::size_t i = 0; i < todas.size(); ++i) {
        const int x = static_cast<int>(i / 3 % 240), y = static_cast<int>(i / 720);
        bool rotulo = false;
        for (int k = 0; k < 3; ++k)
            rotulo = rotulo || (std::fabs(x - rotuloDeLuz(k).x) < 32 && std::fabs(y - rotuloDeLuz(k).y) < 6);
        if (rotulo)
            continue;
        saturados += todas[i] == 255;
        const int suma = roja[i] + verde[i] + azul[i];
        mayor = std::max(mayor, std::abs(todas[i] - (suma - 2 * ambiente[i])));
        mayorUnaAmbiente = std::max(mayorUnaAmbiente, std::abs(todas[i] - suma));
    }
    std::cout << "superposición: diferencia máxima " << mayor << " niveles; contando la ambiente tres veces, "
              << mayorUnaAmbiente << "; " << saturados << " componentes saturados\n";
    EXPECT_EQ(saturados, 0);
    EXPECT_LE(mayor, 3);
    EXPECT_GT(mayorUnaAmbiente, 50);
}

// --- sombreado ---------------------------------------------------------------------------------------------

namespace {

const Material TURQUESA = {{0.05, 0.14, 0.14}, {0.12, 0.50, 0.50}, {0.75, 0.75, 0.75}, 16};
const Luz LUZ_SOMBREADO = posicional({-3, 4, 6});
const Mat4 M_ESFERA = traslada({-0.95, 0.25, 0}) * gira(X, -1.2);
const Camara CAMARA_SOMBREADO = oraculo::perspectiva(oraculo::orbita(0, 0, 12), 0.27, 1, 100);

/// Imagen de cada modelo (plano, Gouraud, Phong) con 6·2^k segmentos: la 3·k + modelo.
std::vector<Imagen> imagenesSombreado(int cuantasSubdivisiones, int ancho, int alto) {
    std::vector<std::string> guiones;
    for (int k = 0; k < cuantasSubdivisiones; ++k) {
        guiones.push_back((k == 0 ? "tecla -" : "tecla +") + std::string("; tecla 1"));
        guiones.push_back("tecla 2");
        guiones.push_back("tecla 3");
    }
    return imagenes("sombreado", guiones, ancho, alto);
}

} // namespace

// El error de cada modelo de sombreado contra la esfera exacta, por subdivisión, en los píxeles a más de uno
// de las dos siluetas (la de la esfera y la de su malla, que con pocos segmentos queda dentro).
TEST(Sombreado, ErrorContraLaEsferaAnalitica) {
    const int ancho = 320, alto = 240;
    const Escena exacta = {oraculo::esfera(M_ESFERA)};
    const ImagenRef ref = traza(exacta, {TURQUESA}, {LUZ_SOMBREADO}, CAMARA_SOMBREADO, FONDO, ancho, alto);
    const char *const nombres[] = {"plano", "Gouraud", "Phong"};
    const auto gpu = imagenesSombreado(6, ancho, alto);
    double rmse[3][6], maximo[3][6];
    std::cout << "esfera analítica; error en niveles: máximo (rmse)\nsegmentos      plano            Gouraud "
                 "         Phong\n";
    for (int k = 0, n = 6; k < 6; ++k, n *= 2) {
        const ImagenRef conMalla = traza({oraculo::malla(M_ESFERA, esfera(n))}, {TURQUESA}, {LUZ_SOMBREADO},
                                         CAMARA_SOMBREADO, FONDO, ancho, alto);
        std::cout << std::setw(6) << n << std::fixed << std::setprecision(2);
        for (int modelo = 0; modelo < 3; ++modelo) {
            const Imagen &imagen = gpu[static_cast<std::size_t>(3 * k + modelo)];
            double suma = 0;
            int pixeles = 0;
            maximo[modelo][k] = 0;
            for (int y = 1; y + 1 < alto; ++y)
                for (int x = 1; x < ancho / 2 - 4; ++x) { // a la derecha está el toro
                    bool interior = true;
                    for (int v = y - 1; v <= y + 1; ++v)
                        for (int u = x - 1; u <= x + 1; ++u)
                            interior = interior && ref.en(u, v).objeto == 0 && conMalla.en(u, v).objeto == 0;
                    if (!interior)
                        continue;
                    const double d = oraculo::diferencia(imagen, x, y, ref.en(x, y).color);
                    maximo[modelo][k] = std::max(maximo[modelo][k], d);
                    suma += d * d;
                    ++pixeles;
                }
            ASSERT_GT(pixeles, 8000);
            rmse[modelo][k] = std::sqrt(suma / pixeles);
            std::cout << std::setw(10) << maximo[modelo][k] << " (" << std::setw(5) << rmse[modelo][k] << ")";
        }
        std::cout << "\n" << std::defaultfloat << std::setprecision(6);
    }
    for (int modelo = 0; modelo < 3; ++modelo)
        for (int k = 1; k < 6; ++k)
            // el redondeo a 8 bits es un suelo de 0.29 de rmse
            EXPECT_LT(rmse[modelo][k], std::max(rmse[modelo][k - 1], 0.35))
                << nombres[modelo] << " " << (6 << k);
    for (int k = 0; k < 6; ++k) {
        EXPECT_LT(rmse[2][k], rmse[1][k] + 0.01) << (6 << k);
        EXPECT_LT(rmse[1][k], rmse[0][k]) << (6 << k);
    }
    EXPECT_LE(maximo[2][5], 2);
}

namespace {

/// Un modelo (1 plano, 2 Gouraud, 3 Phong) sobre la MISMA malla de n segmentos, en doble precisión: Phong con la normal
/// interpolada y normalizada; Gouraud con los tres colores interpolados; plano con el color del primer vértice de cada
/// triángulo (facetas lo pone el último, el que manda) y la normal del triángulo.
ImagenRef sombreado(int modelo, int n, const Vec3 &enEsfera, const Vec3 &enToro, const Camara &camara,
                    int ancho, int alto) {
    const Material coral = {{0.20, 0.08, 0.05}, {0.62, 0.26, 0.17}, {0.70, 0.70, 0.70}, 16};
    const Material materiales[] = {TURQUESA, coral};
    const Escena escena = {oraculo::malla(traslada(enEsfera) * gira(X, -1.2), esfera(n)),
                           oraculo::malla(traslada(enToro) * gira(X, -0.7), toro(0.68f, 0.30f, n, n / 2))};
    return oraculo::render(escena, camara, ancho, alto, [&](const Impacto &i) -> Tono {
        if (!i)
            return FONDO;
        const auto cual = static_cast<std::size_t>(i.objeto);
        const oraculo::Objeto &o = escena[cual];
        const auto ilumina = [&](const Vec3 &p, const Vec3 &normal) {
            return oraculo::phong(materiales[cual], BLANCA, {LUZ_SOMBREADO}, p, normal,
                                  oraculo::unitario(camara.ojo - p));
        };
        if (modelo == 3)
            return ilumina(i.punto, i.normal);
        const auto &indices = o.triangulos->indices[static_cast<std::size_t>(i.corte.triangulo)];
        const auto vertice = [&](std::size_t k) -> const oraculo::VerticeRef & {
            return o.triangulos->vertices[indices[k]];
        };
        const auto enMundo = [&](std::size_t k) { return oraculo::punto(o.M, vertice(k).posicion); };
        // cada polígono, una zona: entre dos hay un salto de color en el sombreado plano
        if (modelo == 1)
            return {ilumina(enMundo(0), i.normalCara), i.corte.triangulo / 2};
        Vec3 color{};
        const double b[] = {1 - i.corte.b1 - i.corte.b2, i.corte.b1, i.corte.b2};
        for (std::size_t k = 0; k < 3; ++k)
            color = color + b[k] * ilumina(enMundo(k), oraculo::transformaNormal(o.inv, vertice(k).normal));
        return color;
    });
}

const char *const MODELOS_SOMBREADO[] = {"Plano", "Gouraud", "Phong"};

/// El rótulo del modelo está abajo, en el centro.
Imagen sinModelo(const Imagen &imagen, const ImagenRef &ref, int modelo) {
    SinEncima sin(imagen, ref);
    EXPECT_TRUE(
        sin.rotulo(MODELOS_SOMBREADO[modelo - 1], BLANCO, 0.5 * imagen.ancho, imagen.alto > 300 ? 13 : 7, 3))
        << MODELOS_SOMBREADO[modelo - 1];
    return sin.limpia;
}

} // namespace

TEST(Sombreado, CadaModeloContraSuMallaEnDoble) {
    const auto gpu = imagenesSombreado(3, 320, 240);
    for (int veces = 0; veces < 3; ++veces)
        for (int modelo = 1; modelo <= 3; ++modelo) {
            const int n = 6 << veces;
            const ImagenRef ref =
                sombreado(modelo, n, {-0.95, 0.25, 0}, {0.98, -0.35, 0.5}, CAMARA_SOMBREADO, 320, 240);
            const Imagen &imagen = gpu[static_cast<std::size_t>(3 * veces + modelo - 1)];
            const Comparacion c = oraculo::compara(sinModelo(imagen, ref, modelo), ref);
            std::cout << n << " segmentos, modelo " << modelo << ": " << c << "\n";
            EXPECT_LE(c.maximo, MISMA_MALLA) << n << " segmentos, modelo " << modelo << ": " << c;
            EXPECT_EQ(c.bandaLejos, 0);
        }
}

// Con v, los tres a la vez y en su orden: en un panel alto, la esfera está encima del toro y la vista abarca 0.142 radianes a
// lo alto de una ventana 4:3, es decir, 4/3 de su tangente a lo ancho.
TEST(Sombreado, LosTresPanelesContraSuMallaEnDoble) {
    const auto gpu = imagenes("sombreado", {"tecla v"}, 480, 360);
    const Camara camara = oraculo::perspectiva(oraculo::orbita(0, 0, 12), 0.142, 1, 100);
    const int desde[] = {0, 160, 321, 482};
    for (int modelo = 1; modelo <= 3; ++modelo) {
        const int ancho = desde[modelo] - desde[modelo - 1] - 2;
        const ImagenRef ref = sombreado(modelo, 12, {0, 0.8, 0}, {0, -0.95, 0.5}, camara, ancho, 360);
        const Imagen panel = oraculo::recorta(gpu[0], desde[modelo - 1], 0, ancho, 360);
        const Comparacion c = oraculo::compara(sinModelo(panel, ref, modelo), ref);
        std::cout << "panel " << modelo << ": " << c << "\n";
        EXPECT_LE(c.maximo, MISMA_MALLA) << c;
        EXPECT_LE(c.bandaLejos, c.banda / 500);
    }
}

// La subdivisión tiene tope por los dos lados.
TEST(Sombreado, LaSubdivisionTieneTopes) {
    const auto gpu = imagenes("sombreado", {"espera 0", "tecla -", "tecla -; tecla -", "tecla +",
                                            "tecla +; tecla +; tecla +; tecla +", "tecla +; tecla +"});
    EXPECT_EQ(gpu[1].rgb, gpu[2].rgb);
    EXPECT_EQ(gpu[3].rgb, gpu[0].rgb);
    EXPECT_EQ(gpu[4].rgb, gpu[5].rgb);
    EXPECT_NE(gpu[0].rgb, gpu[1].rgb);
    EXPECT_NE(gpu[0].rgb, gpu[4].rgb);
    for (const auto &[k, n] : {std::pair<std::size_t, int>(2, 6), {5, 192}}) {
        const ImagenRef ref =
            sombreado(1, n, {-0.95, 0.25, 0}, {0.98, -0.35, 0.5}, CAMARA_SOMBREADO, 240, 180);
        const Comparacion c = oraculo::compara(sinModelo(gpu[k], ref, 1), ref);
        EXPECT_LE(c.maximo, MISMA_MALLA) << n << " segmentos: " << c;
        EXPECT_LE(c.bandaLejos, c.banda / 500) << n << " segmentos: " << c;
    }
}

// --- grua_iluminada ----------------------------------------------------------------------------------------

namespace {

/// El suelo, la zapata y la grúa del ejercicio 3.5 con sus medidas, girada `giro`, la carga a `lejos` del pie y a esa altura.
Escena grua(double giro, double lejos = 5, double altura = 4) {
    const Mat4 G = gira(Y, giro);
    const double cable = 10 - altura - 0.5;
    return {oraculo::caja(traslada({0, -0.1, 0}) * escala(12, 0.2, 12)),
            oraculo::caja(traslada({0, 0.2, 0}) * escala(2.4, 0.4, 2.4)),
            oraculo::caja(traslada({0, 5, 0}) * escala(0.8, 10, 0.8)),
            oraculo::caja(G * traslada({2.5, 10.4, 0}) * escala(10, 0.8, 0.8)),
            oraculo::caja(G * traslada({-1.8, 9.3, 0}) * escala(1.4)),
            oraculo::caja(G * traslada({lejos, 10 - cable / 2, 0}) * escala(0.12, cable, 0.12)),
            oraculo::caja(G * traslada({lejos, altura, 0}))};
}

const Material PINTURA = {{0.25, 0.18, 0.03}, {0.68, 0.50, 0.08}, {0.60, 0.60, 0.60}, 15};
const std::vector<Material> MATERIALES_GRUA = {
    {{0.13, 0.17, 0.12}, {0.46, 0.58, 0.42}, {0.25, 0.25, 0.25}, 12},
    {{0.12, 0.13, 0.14}, {0.45, 0.47, 0.50}, {0.05, 0.05, 0.05}, 5},
    PINTURA,
    PINTURA,
    {{0.12, 0.13, 0.14}, {0.45, 0.47, 0.50}, {0.05, 0.05, 0.05}, 5},
    {{0.06, 0.06, 0.07}, {0.20, 0.21, 0.24}, {0.70, 0.70, 0.70}, 80},
    {{0.22, 0.05, 0.05}, {0.68, 0.14, 0.12}, {0.60, 0.60, 0.60}, 30}};
const Luz LUZ_GRUA = posicional({3.5, 8.5, 5.5});
const Camara CAMARA_GRUA = oraculo::perspectiva(oraculo::orbita(0.5, 0.25, 27, {1.0, 4.2, 0}), 0.6, 1, 100);
const Vec3 FONDO_GRUA{0.87, 0.93, 0.98};

/// Gouraud exacto en una cara rectangular partida en dos triángulos por la diagonal (0,0)-(1,1) de (s,t).
ImagenRef gruaGouraud(const Escena &escena, const Camara &camara = CAMARA_GRUA, int ancho = 240) {
    return oraculo::render(escena, camara, ancho, 180, [&](const Impacto &i) -> Tono {
        if (!i)
            return FONDO_GRUA;
        const auto cual = static_cast<std::size_t>(i.objeto);
        const int eje = i.corte.cara / 2;
        const double lado = i.corte.cara % 2 ? 0.5 : -0.5;
        const auto esquina = [&](double s, double t) {
            double p[3];
            p[eje] = lado, p[(eje + 1) % 3] = s - 0.5, p[(eje + 2) % 3] = 2 * lado * (t - 0.5);
            const Vec3 enMundo = oraculo::punto(escena[cual].M, {p[0], p[1], p[2]});
            return oraculo::phong(MATERIALES_GRUA[cual], BLANCA, {LUZ_GRUA}, enMundo, i.normal,
                                  oraculo::unitario(camara.ojo - enMundo));
        };
        const bool abajo = i.s >= i.t;
        const double mayor = std::max(i.s, i.t), menor = std::min(i.s, i.t);
        return (1 - mayor) * esquina(0, 0) + (mayor - menor) * esquina(abajo ? 1 : 0, abajo ? 0 : 1) +
               menor * esquina(1, 1);
    });
}

ImagenRef gruaPhong(const Escena &escena, const Camara &camara = CAMARA_GRUA, int ancho = 240) {
    return traza(escena, MATERIALES_GRUA, {LUZ_GRUA}, camara, FONDO_GRUA, ancho);
}

/// Quita el nombre del modelo, arriba a la izquierda, y la cuadrícula, que debe estar salvo donde la tapan la grúa y la zapata.
Imagen sinCuadricula(const Imagen &imagen, const ImagenRef &ref, const Camara &camara,
                     const std::string &modelo) {
    SinEncima sin(imagen, ref);
    EXPECT_TRUE(sin.rotulo(modelo, OSCURO, 3 * static_cast<double>(modelo.size()) + 3, 173, 4)) << modelo;
    for (int k = -6; k <= 6; k += 2)
        for (const bool aLoAncho : {true, false}) {
            const auto en = [&](double u) {
                return aLoAncho ? Vec3{u, 0.02, 1.0 * k} : Vec3{1.0 * k, 0.02, u};
            };
            EXPECT_GT(sin.trazo(camara, {en(-6), en(6)}, OSCURO, 1.6), 0.7) << k;
        }
    return sin.limpia;
}

void compruebaGrua(const std::string &que, const Imagen &imagen, const ImagenRef &ref,
                   const std::string &modelo, const Camara &camara = CAMARA_GRUA) {
    comprueba(que, sinCuadricula(imagen, ref, camara, modelo), ref, MISMA_MALLA, true);
}

} // namespace

TEST(GruaIluminada, CarasContraLaEcuacion56) {
    const auto gpu =
        imagenes("grua_iluminada", {"espera 0", "tecla g", "tecla d; tecla d; tecla d", "tecla g"});
    compruebaGrua("Gouraud", gpu[0], gruaGouraud(grua(0)), "Gouraud");
    compruebaGrua("Phong", gpu[1], gruaPhong(grua(0)), "Phong");
    compruebaGrua("Phong, girada", gpu[2], gruaPhong(grua(-0.3)), "Phong");
    compruebaGrua("Gouraud, girada", gpu[3], gruaGouraud(grua(-0.3)), "Gouraud");
}

// Cada tecla, en su sentido: q acerca la carga al pie y e la aleja; w la sube y s la baja; a y d giran.
TEST(GruaIluminada, CadaTeclaMueveLoSuyo) {
    const auto gpu = imagenes("grua_iluminada",
                              {"tecla g; tecla q; tecla q", "tecla e; tecla e; tecla e; tecla e",
                               "tecla w; tecla w; tecla w", "tecla s; tecla s; tecla s; tecla s; tecla s",
                               "tecla a; tecla a; tecla a"});
    const Escena escenas[] = {grua(0, 4, 4), grua(0, 6, 4), grua(0, 6, 5.5), grua(0, 6, 3), grua(0.3, 6, 3)};
    for (std::size_t i = 0; i < 5; ++i)
        compruebaGrua(std::string(1, "qewsa"[i]), gpu[i], gruaPhong(escenas[i]), "Phong");
}

// Con v, Gouraud a la izquierda y Phong a la derecha; en cada panel, más estrecho que 4:3, cabe lo mismo a lo ancho.
TEST(GruaIluminada, LosDosPaneles) {
    const auto gpu = imagenes("grua_iluminada", {"tecla v"}, 480, 180);
    compruebaGrua("Gouraud", oraculo::recorta(gpu[0], 0, 0, 239, 180), gruaGouraud(grua(0), CAMARA_GRUA, 239),
                  "Gouraud", CAMARA_GRUA);
    compruebaGrua("Phong", oraculo::recorta(gpu[0], 240, 0, 240, 180), gruaPhong(grua(0), CAMARA_GRUA, 240),
                  "Phong");
}
