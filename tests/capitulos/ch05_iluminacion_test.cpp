// Los programas del capítulo 5 contra trazado de rayos en doble precisión. Las escenas, los materiales y las
// luces están escritos otra vez. Cada escena se traza dos veces: con la misma malla que dibuja el programa, y
// entonces no debe haber más error que el redondeo a 8 bits, y con las formas exactas, que dicen cuánto
// cuesta la malla.
#include "ejecuta.h"
#include "malla.h"
#include "oraculo/oraculo.h"
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <iomanip>
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
const Vec3 FONDO{0.16, 0.17, 0.20}, NEGRO{0.10, 0.11, 0.13}, BLANCA{1, 1, 1};
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

const int N_CERAMICA = segmentosPara(250, 0.1f), N_ANILLO = segmentosPara(400, 0.1f),
          M_ANILLO = segmentosPara(60, 0.1f);

ImagenRef componentes(int cuantos, bool mismaMalla, double azimut = 0, double elevacion = 0) {
    Luz luz = posicional({-3.5, 4, 6});
    luz.Ld = cuantos >= 2 ? BLANCA : Vec3{}, luz.Ls = cuantos >= 3 ? BLANCA : Vec3{};
    const Escena escena = {
        unaEsfera(Mat4(), mismaMalla ? N_CERAMICA : 0),
        unToro(gira(Z, 0.35) * gira(X, -1.15), 1.55, 0.22, mismaMalla ? N_ANILLO : 0, M_ANILLO)};
    return traza(escena, {CERAMICA, LATON}, {luz},
                 oraculo::perspectiva(oraculo::orbita(azimut, elevacion, 10), 0.31, 1, 100), FONDO);
}

} // namespace

TEST(ComponentesPhong, ContraTrazadoDeRayos) {
    const auto gpu = imagenes("componentes_phong", {"tecla 1", "tecla 2", "tecla 3"});
    const char *const nombres[] = {"a", "b", "c"};
    for (int k = 0; k < 3; ++k)
        for (const bool mismaMalla : {true, false})
            comprueba(nombres[k], gpu[static_cast<std::size_t>(k)], componentes(k + 1, mismaMalla),
                      mismaMalla ? MISMA_MALLA : EXACTA, mismaMalla);
}

// La luz está en el mundo: al girar la cámara cambian sus coordenadas de la cámara, y el brillo se mueve.
TEST(ComponentesPhong, LaLuzNoGiraConLaCamara) {
    const auto gpu =
        imagenes("componentes_phong",
                 {"boton IZQUIERDO abajo 100 90; arrastra 140 120; boton IZQUIERDO arriba 140 120"});
    comprueba("girada", gpu[0], componentes(3, true, -0.4, 0.3), MISMA_MALLA, true);
}

// --- exponente_brillo --------------------------------------------------------------------------------------

namespace {

struct EsferaBrillo {
    Vec3 centro;
    double alfa;
};
const EsferaBrillo ESFERAS_BRILLO[] = {{{-2.15, 0.95, 0}, 1},
                                       {{0, 0.95, 0}, 5},
                                       {{2.15, 0.95, 0}, 20},
                                       {{-1.075, -0.95, 0}, 100},
                                       {{1.075, -0.95, 0}, 500}};

} // namespace

// En cada esfera, lo que queda al quitar ambiente y difusa es Ks·cos^alfa.
TEST(ExponenteBrillo, PerfilContraCosenoElevadoAAlfa) {
    const Vec3 ka{0.09, 0.02, 0.03}, kd{0.44, 0.07, 0.10}, L = oraculo::unitario({-0.45, 0.60, 1});
    const double ks = 0.85;
    Escena escena;
    for (const EsferaBrillo &e : ESFERAS_BRILLO)
        escena.push_back(oraculo::esfera(traslada(e.centro)));
    const Camara camara = oraculo::perspectiva(oraculo::orbita(0, 0, 16), 0.30, 1, 100);
    const Ejecucion e = ejecuta("ch05_iluminacion/exponente_brillo", "", 480, 360);
    ASSERT_EQ(e.estado, 0) << e.errores;
    double maximo[5] = {}, brillo[5] = {};
    for (int y = 0; y < 360; ++y)
        for (int x = 0; x < 480; ++x) {
            const Impacto i =
                oraculo::primerImpacto(escena, oraculo::rayo(camara, 480, 360, x + 0.5, y + 0.5));
            if (!i || oraculo::escalar(i.normal, -i.rayo.direccion) < 0.15)
                continue; // fondo y silueta
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
            escena.push_back(unaEsfera(traslada(e.centro), mismaMalla ? segmentosPara(150, 0.05f) : 0));
            materiales.push_back({{0.09, 0.02, 0.03}, {0.44, 0.07, 0.10}, {0.85, 0.85, 0.85}, e.alfa});
        }
        comprueba("cinco alfas", gpu[0],
                  traza(escena, materiales, {direccional({-0.45, 0.60, 1})},
                        oraculo::perspectiva(oraculo::orbita(0, 0, 16), 0.30, 1, 100), FONDO),
                  mismaMalla ? MISMA_MALLA : EXACTA, mismaMalla);
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
const Camara CAMARA_MATERIALES = oraculo::perspectiva(oraculo::orbita(0, 0, 22), 0.31, 1, 100);

std::vector<Material> tabla(double porAlfa) {
    std::vector<Material> m(TABLA, TABLA + 12);
    for (Material &material : m)
        material.alfa *= porAlfa;
    return m;
}

const int N_MATERIALES = segmentosPara(300, 0.1f);

Escena doceEsferas(int n) {
    Escena escena;
    for (int i = 0; i < 12; ++i)
        escena.push_back(unaEsfera(traslada({2.2 * (i % 4 - 1.5), 2.2 * (1 - i / 4), 0}), n));
    return escena;
}

} // namespace

TEST(Materiales, CentroDeCadaEsferaContraLaEcuacion56) {
    const Ejecucion e = ejecuta("ch05_iluminacion/materiales");
    ASSERT_EQ(e.estado, 0) << e.errores;
    const std::vector<Material> materiales = tabla(128);
    const Escena escena = doceEsferas(0);
    for (int i = 0; i < 12; ++i) {
        const Vec3 p =
            oraculo::proyecta(CAMARA_MATERIALES, 240, 180, {2.2 * (i % 4 - 1.5), 2.2 * (1 - i / 4), 0});
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
    const Vec3 fondo{0.26, 0.27, 0.30};
    std::vector<std::string> guiones(13, "tecla n"); // el decimotercero vuelve a ser el primero
    guiones.push_back("tecla t");
    const auto gpu = imagenes("materiales", guiones);
    for (std::size_t i = 0; i < 13; ++i)
        comprueba("material " + std::to_string(i), gpu[i],
                  traza({unaEsfera(escala(3), 0)}, {tabla(128)[i % 12]}, {luz}, CAMARA_MATERIALES, fondo),
                  EXACTA, false);
    for (const bool mismaMalla : {true, false})
        comprueba(
            "todos", gpu[13],
            traza(doceEsferas(mismaMalla ? N_MATERIALES : 0), tabla(128), {luz}, CAMARA_MATERIALES, fondo),
            mismaMalla ? MISMA_MALLA : EXACTA, mismaMalla);
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
const double DELTA = 0.52;
const Camara CAMARA_FUENTES =
    oraculo::perspectiva(oraculo::orbita(0.35, 0.5, 16, {0, 0.75, 0}), 0.35, 1, 100);

/// Suelo, objetos y la propia fuente, que es lo último de la escena y solo tiene color ambiente. Solo con
/// la misma malla: cerca del vértice del cono, la normal interpolada no es la del cono exacto.
ImagenRef fuentes(int tipo, double exponente) {
    const Vec3 S = oraculo::unitario(APUNTA - POSICION);
    const Mat4 tumbado = gira(X, -PI / 2);
    const int n = segmentosPara(120, 0.1f);
    const oraculo::Objeto unCono = oraculo::malla(Mat4(), cono(n)),
                          unCilindro = oraculo::malla(Mat4(), cilindro(n));
    Escena escena = {
        oraculo::plano(tumbado * escala(7)),
        unaEsfera(traslada({0.3, 0.8, 0.2}) * escala(0.8), n),
        en(traslada({2.1, 0, -1.2}) * tumbado * escala(0.8, 0.8, 1.9), unCono),
        oraculo::caja(traslada({-1.7, 0.6, -1.1}) * gira(Y, 0.5) * escala(1.2)),
        unToro(traslada({1.5, 0.25, 1.9}) * tumbado, 0.7, 0.25, n, n / 2),
    };
    std::vector<Material> materiales = {
        {{0.13, 0.14, 0.16}, {0.62, 0.64, 0.68}, {0.15, 0.15, 0.15}, 20},
        {{0.18, 0.05, 0.05}, {0.75, 0.18, 0.16}, {0.60, 0.60, 0.60}, 50},
        {{0.05, 0.15, 0.07}, {0.18, 0.62, 0.28}, {0.50, 0.50, 0.50}, 50},
        {{0.05, 0.10, 0.20}, {0.16, 0.40, 0.80}, {0.60, 0.60, 0.60}, 50},
        {{0.19, 0.11, 0.03}, {0.80, 0.46, 0.10}, {0.50, 0.50, 0.50}, 50},
    };
    // del eje Z a -S, por el giro más corto
    const Mat4 hacia = gira(oraculo::vectorial(Z, -S), std::acos(-S.z));
    if (tipo == 1)
        escena.push_back(unaEsfera(traslada(POSICION) * escala(0.22), n));
    if (tipo == 2)
        for (const Vec3 &p : {Vec3{-0.7, 0, -0.5}, Vec3{}, Vec3{0.7, 0, 0.5}}) {
            const Mat4 flecha = traslada(POSICION + p + 0.4 * S) * hacia;
            escena.push_back(en(flecha * escala(0.16, 0.16, -0.4) * traslada({0, 0, -1}), unCono));
            escena.push_back(en(flecha * traslada({0, 0, 0.8}) * escala(0.05, 0.05, 0.8), unCilindro));
        }
    if (tipo == 3)
        escena.push_back(
            en(traslada(POSICION) * hacia * traslada({0, 0, -0.15}) * escala(0.3, 0.3, 0.6), unCono));
    materiales.resize(escena.size(), {{1.00, 0.93, 0.60}, {}, {}, 1});
    const Luz luz = tipo == 1   ? posicional(POSICION)
                    : tipo == 2 ? direccional(-S)
                                : foco(POSICION, APUNTA, DELTA, exponente);
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

} // namespace

TEST(Fuentes, LosTresTiposContraTrazadoDeRayos) {
    const auto gpu = imagenes("fuentes", {"tecla 1", "tecla 2", "tecla 3"}, 320, 240);
    for (int tipo = 1; tipo <= 3; ++tipo)
        comprueba("tipo " + std::to_string(tipo), gpu[static_cast<std::size_t>(tipo - 1)], fuentes(tipo, 4),
                  MISMA_MALLA, true);
}

TEST(Fuentes, ElExponenteConcentraLaLuz) {
    const auto gpu = imagenes(
        "fuentes", {"tecla 3; tecla +; tecla +", "tecla -; tecla -; tecla -; tecla -; tecla -; tecla -"}, 320,
        240);
    comprueba("exponente 16", gpu[0], fuentes(3, 16), MISMA_MALLA, true);
    comprueba("exponente 0.5, el menor", gpu[1], fuentes(3, 0.5), MISMA_MALLA, true);
}

// El borde del cono en el suelo: cada píxel está iluminado si y solo si el ángulo exacto con el eje es menor
// que delta, salvo los que el borde cruza. La pantalla del foco y los objetos quedan fuera.
TEST(Fuentes, BordeDelConoContraElAnguloExacto) {
    const int ancho = 640, alto = 480;
    const Ejecucion e = ejecuta("ch05_iluminacion/fuentes", "tecla 3", ancho, alto);
    ASSERT_EQ(e.estado, 0) << e.errores;
    const Luz luz = foco(POSICION, APUNTA, DELTA, 4);
    const double enElBorde = std::pow(std::cos(DELTA), 4); // lo que aún alumbra el foco junto al borde
    int dentro = 0, fuera = 0, dudosos = 0, mal = 0;
    const Escena suelo = {oraculo::plano(gira(X, -PI / 2) * escala(7))};
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
            // solo el suelo, que es gris azulado: el ambiente es (33, 36, 41)
            if (a > 1.2 || std::abs(p.g - p.r - 2) > 3 || std::abs(p.b - p.g - 5) > 5)
                continue;
            double minimo = a, maximo = a;
            for (const double dx : {0.0, 1.0})
                for (const double dy : {0.0, 1.0}) {
                    minimo = std::min(minimo, angulo(x + dx, y + dy));
                    maximo = std::max(maximo, angulo(x + dx, y + dy));
                }
            const bool iluminado = p.r > 45;
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

const Vec3 POSICION_ATENUACION{-5, 2.4, 3.6};
const Camara CAMARA_ATENUACION =
    oraculo::perspectiva(oraculo::orbita(0, 0.72, 25.5, {-0.2, 0.2, 0}), 0.36, 1, 100);
const Material SUELO_ATENUACION = {{0.05, 0.05, 0.06}, {0.55, 0.57, 0.60}, {}, 1};

Escena escenaAtenuacion(int n) {
    Escena escena = {oraculo::plano(gira(X, -PI / 2) * escala(12.5, 9, 1)),
                     unaEsfera(traslada(POSICION_ATENUACION) * escala(0.25), n)};
    for (int i = 0; i < 15; ++i)
        escena.push_back(unaEsfera(traslada({2.2 * (i / 3) - 4, 0.8, 2.2 * (i % 3) - 3}) * escala(0.8), n));
    return escena;
}

Luz luzAtenuacion(int modo) {
    Luz luz = posicional(POSICION_ATENUACION);
    luz.a = modo == 1 ? 1 : 0, luz.b = modo == 2 ? 1 / 3.0 : 0, luz.c = modo == 3 ? 1 / 9.0 : 0;
    return luz;
}

} // namespace

TEST(Atenuacion, ContraTrazadoDeRayos) {
    const auto gpu = imagenes("atenuacion", {"tecla 1", "tecla 2", "tecla 3"});
    for (int modo = 1; modo <= 3; ++modo)
        for (const bool mismaMalla : {true, false}) {
            const Escena escena = escenaAtenuacion(mismaMalla ? segmentosPara(60, 0.05f) : 0);
            std::vector<Material> materiales = {SUELO_ATENUACION, {{1.00, 0.93, 0.60}, {}, {}, 1}};
            materiales.resize(escena.size(),
                              {{0.06, 0.035, 0.01}, {0.90, 0.50, 0.12}, {0.45, 0.45, 0.45}, 40});
            comprueba("modo " + std::to_string(modo), gpu[static_cast<std::size_t>(modo - 1)],
                      traza(escena, materiales, {luzAtenuacion(modo)}, CAMARA_ATENUACION, NEGRO),
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
        for (double x = -6; x <= 6; x += 0.05) {
            const Vec3 p = oraculo::proyecta(CAMARA_ATENUACION, ancho, alto, {x, 0, 3.6});
            const int px = static_cast<int>(std::floor(p.x)), py = static_cast<int>(std::floor(p.y));
            if (px < 0 || px >= ancho)
                continue;
            const Impacto i = oraculo::primerImpacto(
                escena, oraculo::rayo(CAMARA_ATENUACION, ancho, alto, px + 0.5, py + 0.5));
            ASSERT_EQ(i.objeto, 0) << "la línea debe estar despejada";
            const Vec3 v = POSICION_ATENUACION - i.punto;
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
        EXPECT_GT(lejos, 9);
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

ImagenRef variasLuces(bool roja, bool verde, bool azul, bool mismaMalla) {
    const Escena escena = {
        oraculo::plano(gira(X, -PI / 2) * escala(9)),
        unaEsfera(traslada({0, 0.8, 0}) * escala(0.8), mismaMalla ? segmentosPara(130, 0.1f) : 0)};
    const Material blanco = {{0.13, 0.13, 0.14}, {0.80, 0.80, 0.80}, {}, 1},
                   brillante = {{0.12, 0.12, 0.13}, {0.60, 0.60, 0.60}, {0.30, 0.30, 0.30}, 40};
    return traza(escena, {blanco, brillante}, tresFocos(roja, verde, azul),
                 oraculo::perspectiva(oraculo::orbita(0, 0.8, 14, {0, 0.2, 0}), 0.36, 1, 100), NEGRO);
}

} // namespace

TEST(VariasLuces, ContraTrazadoDeRayos) {
    const auto gpu = imagenes("varias_luces", {"espera 0", "tecla 2; tecla 3", "tecla 1; tecla 2; tecla 3"});
    for (const bool mismaMalla : {true, false}) {
        const double tope = mismaMalla ? MISMA_MALLA : EXACTA;
        comprueba("todas", gpu[0], variasLuces(true, true, true, mismaMalla), tope, mismaMalla);
        comprueba("roja", gpu[1], variasLuces(true, false, false, mismaMalla), tope, mismaMalla);
        comprueba("verde y azul", gpu[2], variasLuces(false, true, true, mismaMalla), tope, mismaMalla);
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
const Camara CAMARA_SOMBREADO = oraculo::perspectiva(oraculo::orbita(0, 0, 12), 0.26, 1, 100);

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

// Contra la MISMA malla en doble precisión, en la esfera y en el toro: Phong con la normal interpolada y
// normalizada; Gouraud con los tres colores interpolados; plano con el color del primer vértice de cada
// triángulo (facetas lo pone el último, el que manda) y la normal del triángulo.
TEST(Sombreado, CadaModeloContraSuMallaEnDoble) {
    const Material coral = {{0.20, 0.08, 0.05}, {0.62, 0.26, 0.17}, {0.70, 0.70, 0.70}, 16};
    const Material materiales[] = {TURQUESA, coral};
    const auto gpu = imagenesSombreado(3, 320, 240);
    for (int veces = 0; veces < 3; ++veces) {
        const int n = 6 << veces;
        const Escena escena = {
            oraculo::malla(M_ESFERA, esfera(n)),
            oraculo::malla(traslada({0.98, -0.35, 0.5}) * gira(X, -0.7), toro(0.68f, 0.30f, n, n / 2))};
        for (int modelo = 1; modelo <= 3; ++modelo) {
            const auto sombrea = [&](const Impacto &i) -> Tono {
                if (!i)
                    return FONDO;
                const auto cual = static_cast<std::size_t>(i.objeto);
                const oraculo::Objeto &o = escena[cual];
                const auto ilumina = [&](const Vec3 &p, const Vec3 &normal) {
                    return oraculo::phong(materiales[cual], BLANCA, {LUZ_SOMBREADO}, p, normal,
                                          oraculo::unitario(CAMARA_SOMBREADO.ojo - p));
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
                    color = color +
                            b[k] * ilumina(enMundo(k), oraculo::transformaNormal(o.inv, vertice(k).normal));
                return color;
            };
            const ImagenRef ref = oraculo::render(escena, CAMARA_SOMBREADO, 320, 240, sombrea);
            const Comparacion c =
                oraculo::compara(gpu[static_cast<std::size_t>(3 * veces + modelo - 1)], ref);
            std::cout << n << " segmentos, modelo " << modelo << ": " << c << "\n";
            EXPECT_LE(c.maximo, MISMA_MALLA) << n << " segmentos, modelo " << modelo << ": " << c;
            EXPECT_EQ(c.bandaLejos, 0);
        }
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
}

// --- grua_iluminada ----------------------------------------------------------------------------------------

namespace {

/// La grúa del ejercicio 3.5 con sus medidas, girada `giro`, la carga a 5 del pie y a altura 4.
Escena grua(double giro) {
    const Mat4 G = gira(Y, giro);
    return {oraculo::caja(traslada({0, -0.1, 0}) * escala(20, 0.2, 20)),
            oraculo::caja(traslada({0, 5, 0}) * escala(0.8, 10, 0.8)),
            oraculo::caja(G * traslada({2.5, 10.4, 0}) * escala(10, 0.8, 0.8)),
            oraculo::caja(G * traslada({-1.8, 9.3, 0}) * escala(1.4)),
            oraculo::caja(G * traslada({5, 7.25, 0}) * escala(0.12, 5.5, 0.12)),
            oraculo::caja(G * traslada({5, 4, 0}))};
}

const Material PINTURA = {{0.25, 0.18, 0.03}, {0.68, 0.50, 0.08}, {0.60, 0.60, 0.60}, 15};
const std::vector<Material> MATERIALES_GRUA = {
    {{0.13, 0.17, 0.12}, {0.46, 0.58, 0.42}, {0.25, 0.25, 0.25}, 12},
    PINTURA,
    PINTURA,
    {{0.12, 0.13, 0.14}, {0.45, 0.47, 0.50}, {0.05, 0.05, 0.05}, 5},
    {{0.06, 0.06, 0.07}, {0.20, 0.21, 0.24}, {0.70, 0.70, 0.70}, 80},
    {{0.22, 0.05, 0.05}, {0.68, 0.14, 0.12}, {0.60, 0.60, 0.60}, 30}};
const Luz LUZ_GRUA = posicional({3.5, 8.5, 5.5});
const Camara CAMARA_GRUA = oraculo::perspectiva(oraculo::orbita(0.5, 0.25, 23, {1.5, 5.2, 0}), 0.6, 1, 100);
const Vec3 CIELO{0.87, 0.93, 0.98};

/// Gouraud exacto en una cara rectangular partida en dos triángulos por la diagonal (0,0)-(1,1) de (s,t).
ImagenRef gruaGouraud(double giro) {
    const Escena escena = grua(giro);
    return oraculo::render(escena, CAMARA_GRUA, 240, 180, [&](const Impacto &i) -> Tono {
        if (!i)
            return CIELO;
        const auto cual = static_cast<std::size_t>(i.objeto);
        const int eje = i.corte.cara / 2;
        const double lado = i.corte.cara % 2 ? 0.5 : -0.5;
        const auto esquina = [&](double s, double t) {
            double p[3];
            p[eje] = lado, p[(eje + 1) % 3] = s - 0.5, p[(eje + 2) % 3] = 2 * lado * (t - 0.5);
            const Vec3 enMundo = oraculo::punto(escena[cual].M, {p[0], p[1], p[2]});
            return oraculo::phong(MATERIALES_GRUA[cual], BLANCA, {LUZ_GRUA}, enMundo, i.normal,
                                  oraculo::unitario(CAMARA_GRUA.ojo - enMundo));
        };
        const bool abajo = i.s >= i.t;
        const double mayor = std::max(i.s, i.t), menor = std::min(i.s, i.t);
        return (1 - mayor) * esquina(0, 0) + (mayor - menor) * esquina(abajo ? 1 : 0, abajo ? 0 : 1) +
               menor * esquina(1, 1);
    });
}

} // namespace

TEST(GruaIluminada, CarasContraLaEcuacion56) {
    const auto gpu =
        imagenes("grua_iluminada", {"espera 0", "tecla g", "tecla d; tecla d; tecla d", "tecla g"});
    comprueba("Gouraud", gpu[0], gruaGouraud(0), MISMA_MALLA, true);
    comprueba("Phong", gpu[1], traza(grua(0), MATERIALES_GRUA, {LUZ_GRUA}, CAMARA_GRUA, CIELO), MISMA_MALLA,
              true);
    comprueba("Phong, girada", gpu[2], traza(grua(-0.3), MATERIALES_GRUA, {LUZ_GRUA}, CAMARA_GRUA, CIELO),
              MISMA_MALLA, true);
    comprueba("Gouraud, girada", gpu[3], gruaGouraud(-0.3), MISMA_MALLA, true);
}
