// El capítulo 7: las matrices de reflexión y de sombra contra cuádruple precisión, y los cinco programas contra trazado de
// rayos en doble precisión: un rebote en el espejo, rayos a la luz en las sombras y composición de atrás adelante en lo
// transparente. Las escenas, los materiales y las luces están escritos otra vez; las formas curvas son las mallas de
// common/malla.h, llevadas al mundo por el oráculo.
#include "ch07_realismo/reflexion.h"
#include "ch07_realismo/sombra.h"
#include "colores.h"
#include "ejecuta.h"
#include "encima.h"
#include "malla.h"
#include "oraculo/oraculo.h"
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdio>
#include <functional>
#include <gtest/gtest.h>
#include <iostream>
#include <random>

using oraculo::caja;
using oraculo::Camara;
using oraculo::Comparacion;
using oraculo::escala;
using oraculo::Escena;
using oraculo::gira;
using oraculo::ImagenRef;
using oraculo::Impacto;
using oraculo::Mat4;
using oraculo::Material;
using oraculo::Objeto;
using oraculo::Rayo;
using oraculo::Tono;
using oraculo::traslada;
using oraculo::Vec3;

namespace {

using Cuadruple = boost::multiprecision::cpp_bin_float_quad;
using Punto = std::array<Cuadruple, 3>;

const double PI = oraculo::PI;
const Vec3 X{1, 0, 0}, Y{0, 1, 0}, Z{0, 0, 1};
const Vec3 UNO{1, 1, 1};

Vec3 doble(const glm::vec3 &v) {
    return {v.x, v.y, v.z};
}
Punto cuadruple(const glm::vec3 &v) {
    return {v.x, v.y, v.z};
}
Cuadruple por(const Punto &a, const Punto &b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

class Azar {
    std::mt19937 generador;

public:
    explicit Azar(unsigned semilla) : generador(semilla) {
    }
    float entre(float a, float b) {
        return std::uniform_real_distribution<float>(a, b)(generador);
    }
    glm::vec3 vector(float r) {
        return {entre(-r, r), entre(-r, r), entre(-r, r)};
    }
    glm::vec3 direccion() {
        glm::vec3 v;
        do
            v = vector(1);
        while (glm::length(v) < 0.1f || glm::length(v) > 1);
        return glm::normalize(v);
    }
};

/// Una ejecución con varias capturas: la imagen que queda tras cada guion, que sigue al anterior.
std::vector<Imagen> imagenes(const std::string &programa, const std::vector<std::string> &guiones,
                             int ancho = 240, int alto = 180) {
    const std::string base = (carpetaTemporal() / "ch07_").string();
    std::string guion;
    for (std::size_t i = 0; i < guiones.size(); ++i)
        guion +=
            guiones[i] + (guiones[i].empty() ? "" : "; ") + "captura " + base + std::to_string(i) + ".ppm; ";
    const Ejecucion e = ejecuta("ch07_realismo/" + programa, guion, ancho, alto);
    if (e.estado != 0 || !e.errores.empty())
        throw std::runtime_error(programa + ": " + e.errores);
    std::vector<Imagen> resultado;
    for (std::size_t i = 0; i < guiones.size(); ++i) {
        resultado.push_back(leePpm(base + std::to_string(i) + ".ppm"));
        std::remove((base + std::to_string(i) + ".ppm").c_str());
    }
    return resultado;
}
std::string repite(const std::string &orden, int veces) {
    std::string guion;
    for (int i = 0; i < veces; ++i)
        guion += (i ? "; " : "") + orden;
    return guion;
}
/// Arrastrar con ese botón, en píxeles de una ventana de 180 de alto: 100 son un radián de órbita.
std::string arrastra(const std::string &boton, int dx, int dy) {
    const std::string a = " 50 60", b = " " + std::to_string(50 + dx) + " " + std::to_string(60 + dy);
    return "boton " + boton + " abajo" + a + "; arrastra" + b + "; boton " + boton + " arriba" + b;
}

/// Una malla con su transformación ya hecha: los vértices y sus normales unitarias, como salen del vertex shader.
Objeto enElMundo(const Mat4 &M, const Malla &m) {
    const Mat4 inv = oraculo::inversa(M);
    std::vector<oraculo::VerticeRef> vertices;
    for (const Vertice &v : m.vertices)
        vertices.push_back(
            {oraculo::punto(M, doble(v.posicion)), oraculo::transformaNormal(inv, doble(v.normal))});
    std::vector<oraculo::Triangulos::Indices> indices;
    for (std::size_t i = 0; i < m.indices.size(); i += 3)
        indices.push_back({m.indices[i], m.indices[i + 1], m.indices[i + 2]});
    return oraculo::malla(Mat4(), vertices, indices);
}

Material pintado(const Vec3 &color, double brillo, double alfa) {
    return {0.35 * color, 0.75 * color, brillo * UNO, alfa};
}
oraculo::Luz posicional(const Vec3 &p) {
    oraculo::Luz luz;
    luz.posicion = p;
    return luz;
}
Vec3 recortado(
    const Vec3 &c) { // lo que sale del fragment shader y lo que guarda el framebuffer no pasan de 1
    return {std::min(c.x, 1.0), std::min(c.y, 1.0), std::min(c.z, 1.0)};
}
Vec3 mezcla(const Vec3 &fondo, const Vec3 &color, double alfa) { // ecuación 7.1
    return alfa * recortado(color) + (1 - alfa) * recortado(fondo);
}
/// Lo que distingue, dentro de una zona, un impacto de otro: el objeto y su cara.
int marca(const Impacto &i) {
    return i ? 100 * (i.objeto + 1) + i.corte.cara % 100 : 0;
}

/// Lo que puede costar una mezcla en 8 bits, en niveles: medio por redondear alfa y otro medio por redondear el resultado.
const double MEZCLA = 1;

/// El interior, a menos de `tope` niveles. En la banda solo pueden fallar los píxeles cuyo centro está a menos de 1/512 de la
/// silueta, que la GPU redondea a una rejilla de 1/256.
void comprueba(const std::string &que, const Imagen &imagen, const ImagenRef &ref, double tope = 0.51,
               int bandaPorCada = 500) {
    const Comparacion c = oraculo::compara(imagen, ref, std::max(tope, 2.0));
    std::cout << que << ": " << c << "\n";
    EXPECT_LE(c.maximo, tope) << que << ": " << c;
    EXPECT_LE(c.bandaLejos, c.banda / bandaPorCada) << que << ": " << c;
    EXPECT_GT(c.interior, ref.ancho * ref.alto / 2) << que << ": " << c;
}

} // namespace

// --- reflexion.h -------------------------------------------------------------------------------------------

// La perpendicular no tiene que ser unitaria: con longitud 1, 1.001, 2, 1e-20 y 1e20 la simetría es la misma. Cada punto,
// contra x − 2·(V·(x − P))/(V·V)·V en cuádruple precisión.
TEST(Reflexion, ContraCuadruplePrecision) {
    Azar azar(7);
    double peor = 0, peorInvolucion = 0, peorDeterminante = 0;
    for (int n = 0; n < 5000; ++n) {
        const float longitudes[] = {1, 1.001f, 2, 1e-20f, 1e20f};
        const glm::vec3 V = azar.direccion() * longitudes[n % 5], P = azar.vector(5), x = azar.vector(5);
        const Plano plano = planoPor(P, V);
        const glm::mat4 M = reflexion(plano);
        const glm::vec4 y = M * glm::vec4(x, 1);
        ASSERT_EQ(y.w, 1);
        const Punto v = cuadruple(V);
        const Cuadruple k = 2 * (por(v, cuadruple(x)) - por(v, cuadruple(P))) / por(v, v);
        for (int i = 0; i < 3; ++i)
            peor = std::max(
                peor, static_cast<double>(abs(Cuadruple(x[i]) - k * v[static_cast<std::size_t>(i)] - y[i])));
        const glm::mat4 MM = M * M;
        for (int i = 0; i < 16; ++i)
            peorInvolucion = std::max<double>(peorInvolucion, std::fabs(MM[i / 4][i % 4] - (i % 5 == 0)));
        peorDeterminante = std::max<double>(peorDeterminante, std::fabs(glm::determinant(glm::dmat3(M)) + 1));
        // del lado al que mira V la distancia es positiva, y el simétrico está a la misma, del otro lado
        EXPECT_NEAR(distancia(plano, P + plano.N), 1, 1e-5);
        EXPECT_NEAR(distancia(plano, glm::vec3(y)), -distancia(plano, x), 2e-5);
    }
    std::cout << "punto reflejado: " << peor << "; M·M − I: " << peorInvolucion
              << "; det + 1: " << peorDeterminante << "\n";
    EXPECT_LE(peor, 1e-5); // unas 10 veces el redondeo de una coordenada de tamaño 8
    EXPECT_LE(peorInvolucion, 1e-5);
    EXPECT_LE(peorDeterminante, 2e-6);
}

// Los elementos, contra los de la ecuación 7.3 tal como está impresa, con V unitario exacto en float.
TEST(Reflexion, LosElementosDeLaEcuacion) {
    const glm::vec3 V(0.6f, 0, 0.8f), P(1, 2, -3);
    const glm::mat4 M = reflexion(planoPor(P, V));
    const double PV = 0.6 * 1 - 0.8 * 3;
    const double esperada[4][4] = {{1 - 2 * 0.36, 0, -2 * 0.48, 2 * PV * 0.6},
                                   {0, 1, 0, 0},
                                   {-2 * 0.48, 0, 1 - 2 * 0.64, 2 * PV * 0.8},
                                   {0, 0, 0, 1}};
    for (int fila = 0; fila < 4; ++fila)
        for (int columna = 0; columna < 4; ++columna)
            EXPECT_NEAR(M[columna][fila], esperada[fila][columna], 1e-6) << fila << columna;
}

TEST(Reflexion, SinPerpendicularNoHayPlano) {
    const float infinito = std::numeric_limits<float>::infinity(), nan = std::nanf("");
    for (const glm::vec3 V : {glm::vec3(0), {0, infinito, 0}, {nan, 0, 0}, {0, 0, nan}, {1, nan, 0}})
        EXPECT_EXIT(planoPor({1, 2, 3}, V), testing::ExitedWithCode(1), "perpendicular") << V.x << V.y << V.z;
}

// --- sombra.h ----------------------------------------------------------------------------------------------

// La sombra de x es donde la recta que sale de la luz y pasa por x corta al plano; w es positiva solo si x está entre la luz
// y el plano o por debajo de él. Con la luz en un punto (L.w = 1 o 2) y en el infinito (L.w = 0).
TEST(Sombra, ContraCuadruplePrecision) {
    Azar azar(8);
    double peor = 0;
    for (int n = 0; n < 6000; ++n) {
        const Plano plano = planoPor(azar.vector(2), azar.direccion());
        const float w = static_cast<float>(n % 3);
        const glm::vec3 base = -plano.d * plano.N; // un punto del plano
        const glm::vec3 posicion =
            base + plano.N * azar.entre(1, 4) +
            glm::cross(plano.N, azar.vector(2)); // de la luz o, si está en el infinito, hacia ella
        const glm::vec4 L = w == 0 ? glm::vec4(posicion - base, 0) : glm::vec4(posicion * w, w);
        const float altura = azar.entre(0, 0.8f);
        const glm::vec3 x = base + plano.N * altura + glm::cross(plano.N, azar.vector(3));
        const glm::vec4 y = proyeccionSombra(L, plano) * glm::vec4(x, 1);
        ASSERT_GT(alturaLuz(L, plano), 0);
        ASSERT_GT(y.w, 0);
        // x + t·(x − L) en el plano, con los números float tal como son
        const Punto N = cuadruple(plano.N), X4 = cuadruple(x);
        Punto haciaAbajo;
        for (std::size_t i = 0; i < 3; ++i)
            haciaAbajo[i] = X4[i] * Cuadruple(L.w) - Cuadruple(L[static_cast<int>(i)]);
        const Cuadruple t = -(por(N, X4) + Cuadruple(plano.d)) / por(N, haciaAbajo);
        for (std::size_t i = 0; i < 3; ++i) {
            const int k = static_cast<int>(i);
            peor = std::max(
                peor, static_cast<double>(abs(X4[i] + t * haciaAbajo[i] - Cuadruple(y[k]) / Cuadruple(y.w))));
        }
    }
    std::cout << "punto de sombra: " << peor << "\n";
    EXPECT_LE(peor, 1e-3); // rayos casi rasantes: la sombra llega a distancia 60
}

TEST(Sombra, LosElementosDeLaEcuacion) {
    const glm::vec4 L(2, 5, -1, 1);
    const Plano plano{{0.6f, 0.8f, 0}, 0.5f};
    const glm::mat4 M = proyeccionSombra(L, plano);
    const double N[3] = {0.6, 0.8, 0}, NL = 0.6 * 2 + 0.8 * 5, d = 0.5;
    for (int fila = 0; fila < 4; ++fila)
        for (int columna = 0; columna < 4; ++columna) {
            double esperado = columna < 3 ? -L[fila] * N[columna] : -L[fila] * d;
            if (fila == columna)
                esperado += NL + d;
            EXPECT_NEAR(M[columna][fila], esperado, 2e-6) << fila << columna;
        }
}

// Lo que está a la altura de la luz tiene la sombra en el infinito (w = 0) y lo que está más alto, w < 0: OpenGL lo recorta. La
// luz en el plano o debajo no tiene altura positiva.
TEST(Sombra, AlturaDeLaLuz) {
    const Plano mesa{{0, 1, 0}, -1};
    const glm::vec4 L(3, 4, 5, 1);
    EXPECT_FLOAT_EQ(alturaLuz(L, mesa), 3);
    const glm::mat4 M = proyeccionSombra(L, mesa);
    EXPECT_FLOAT_EQ((M * glm::vec4(7, 4, 8, 1)).w, 0);
    EXPECT_LT((M * glm::vec4(7, 4.5f, 8, 1)).w, 0);
    EXPECT_GT((M * glm::vec4(7, 3.5f, 8, 1)).w, 0);
    EXPECT_EQ(alturaLuz({3, 1, 5, 1}, mesa), 0);
    EXPECT_LT(alturaLuz({3, 0.5f, 5, 1}, mesa), 0);
    EXPECT_EQ(alturaLuz({3, 0, 5, 0}, mesa), 0);
    EXPECT_LT(alturaLuz({3, -1, 5, 0}, mesa), 0);
}

// --- espejo y espejo_plantilla -----------------------------------------------------------------------------

namespace {

const Vec3 FONDO = doble(CIELO);
const Vec3 CENTRO{0, 1.68, -1.9}, AZOGUE{0.40, 0.52, 0.60};
const double GIRO = 0.35, ANCHO = 5.2, ALTO = 2.9, MARCO = 0.18, ALFA_ESPEJO = 0.25;
const Vec3 NORMAL_ESPEJO{std::sin(GIRO), 0, std::cos(GIRO)};

struct EscenaEspejo {
    static const int CONO = 5; // en la lista
    Escena escena;
    std::vector<Material> materiales;
    oraculo::Luz luz = posicional({2.5, 6, 5});

    explicit EscenaEspejo(double avance) {
        const auto pon = [&](const Objeto &o, const Vec3 &color) {
            escena.push_back(o);
            materiales.push_back(pintado(color, 0.35, 40));
        };
        pon(oraculo::plano(traslada({0, 0, 0}) * gira(X, -PI / 2) * escala({8, 6, 1})),
            {}); // el suelo: color según la baldosa
        const Vec3 rojo{0.90, 0.22, 0.18}, madera{0.62, 0.42, 0.24};
        const Mat4 F = traslada(-avance * NORMAL_ESPEJO + Vec3{0.5, 0, 0.9}) * gira(Y, 0.2);
        pon(caja(F * traslada({-0.45, 1, 0}) * escala({0.4, 2, 0.4})), rojo);
        pon(caja(F * traslada({0.25, 1.8, 0}) * escala({1, 0.4, 0.4})), rojo);
        pon(caja(F * traslada({0.10, 1.1, 0}) * escala({0.7, 0.35, 0.4})), rojo);
        pon(enElMundo(traslada({2.1, 0.6, 0.6}) * escala(0.6), esfera(64)), {0.98, 0.75, 0.12});
        pon(enElMundo(traslada({-2.4, 0, 1.6}) * gira(X, -PI / 2) * escala({0.6, 0.6, 1.5}), cono(64)),
            {0.20, 0.62, 0.30});
        const Mat4 tabla = traslada(CENTRO) * gira(Y, GIRO) * traslada({0, 0, -MARCO / 2 - 0.02});
        pon(caja(tabla * escala({ANCHO + 2 * MARCO, ALTO + 2 * MARCO, MARCO})), madera);
        for (const double s : {-1.0, 1.0}) {
            pon(caja(tabla * traslada({0, s * (ALTO + MARCO) / 2, MARCO}) *
                     escala({ANCHO + 2 * MARCO, MARCO, MARCO})),
                madera);
            pon(caja(tabla * traslada({s * (ANCHO + MARCO) / 2, 0, MARCO}) * escala({MARCO, ALTO, MARCO})),
                madera);
        }
    }
    static bool baldosaOscura(const Vec3 &p) {
        return (static_cast<int>(std::floor(p.x)) + static_cast<int>(std::floor(p.z))) % 2 != 0;
    }
    Tono tono(const Impacto &i) const {
        if (!i)
            return FONDO;
        Material m = materiales[static_cast<std::size_t>(i.objeto)];
        const bool oscura = i.objeto == 0 && baldosaOscura(i.punto);
        if (i.objeto == 0)
            m = pintado(oscura ? Vec3{0.36, 0.52, 0.62} : Vec3{0.92, 0.90, 0.84}, 0.35, 40);
        const int faceta = i.objeto == CONO ? i.corte.triangulo : 0; // en su vértice cambia la normal
        return {oraculo::phong(m, UNO, {luz}, i.punto, i.normal, oraculo::haciaOjo(i)),
                10000 * faceta + 2 * marca(i) + oscura};
    }
    /// Lo que se ve reflejado: el rayo rebota en el plano entero del espejo.
    Tono reflejo(const Rayo &r) const {
        const double t = -oraculo::escalar(r.origen - CENTRO, NORMAL_ESPEJO) /
                         oraculo::escalar(r.direccion, NORMAL_ESPEJO);
        const Vec3 p = r.origen + t * r.direccion;
        return tono(oraculo::primerImpacto(
            escena, oraculo::rayoDesde(p, oraculo::refleja(r.direccion, NORMAL_ESPEJO))));
    }
};

Camara camaraEspejo(double azimut, double elevacion = 0.30) {
    return oraculo::perspectiva(oraculo::orbita(azimut, elevacion, 15.5, {0.35, 0.95, 0}), 0.5, 1, 60);
}

/// La imagen con un rebote en el espejo; devuelve también cuántos píxeles son de espejo.
std::pair<ImagenRef, int> conRebote(const EscenaEspejo &e, const Camara &camara, double alfa, int ancho = 240,
                                    int alto = 180) {
    Escena escena = e.escena;
    escena.push_back(oraculo::plano(traslada(CENTRO) * gira(Y, GIRO) * escala({ANCHO, ALTO, 1})));
    int deEspejo = 0;
    const int espejo = static_cast<int>(e.escena.size());
    ImagenRef ref = oraculo::render(escena, camara, ancho, alto, [&](const Impacto &i) -> Tono {
        if (i.objeto != espejo)
            return e.tono(i);
        EXPECT_TRUE(i.frente) << "se ve el dorso del espejo: lo tapa la tabla";
        ++deEspejo;
        const Tono visto = e.reflejo(i.rayo);
        return {mezcla(visto.color, AZOGUE, alfa), 1 + visto.zona};
    });
    return {ref, deEspejo};
}

} // namespace

// La figura 7.2 contra un rebote. Delante del espejo hay objetos más cercanos, que lo tapan: el cono y la F.
TEST(Espejo, ContraTrazadoDeRayosConUnRebote) {
    const auto gpu =
        imagenes("espejo", {"", repite("tecla a", 14), repite("tecla a", 6), repite("tecla d", 40)});
    const double avances[] = {0, 2.8, 3, -1}; // el tercero y el cuarto son los topes
    for (std::size_t k = 0; k < 4; ++k) {
        const auto [ref, deEspejo] = conRebote(EscenaEspejo(avances[k]), camaraEspejo(-0.30), ALFA_ESPEJO);
        comprueba("avance " + std::to_string(avances[k]), gpu[k], ref, 0.51 + MEZCLA);
        EXPECT_GT(deEspejo, 3000);
    }
}

// La cámara da la vuelta: de frente, casi de canto, de canto (el espejo no se ve) y por detrás, donde solo hay tabla.
TEST(Espejo, DesdeTodosLosLados) {
    const int giros[] = {-60, 0, 60, 105, 150, 255};
    std::vector<std::string> guiones;
    int anterior = 0;
    for (const int g : giros) {
        guiones.push_back(arrastra("IZQUIERDO", g - anterior, 0));
        anterior = g;
    }
    const auto gpu = imagenes("espejo", guiones);
    for (std::size_t k = 0; k < 6; ++k) {
        const auto [ref, deEspejo] =
            conRebote(EscenaEspejo(0), camaraEspejo(-0.30 - 0.01 * giros[k]), ALFA_ESPEJO);
        comprueba("giro " + std::to_string(giros[k]), gpu[k], ref, 0.51 + MEZCLA);
        EXPECT_EQ(deEspejo > 0, k < 3) << k;
    }
}

// De lo que hay detrás del espejo no hay reflejo: la F lo atraviesa y sigue del otro lado, y en el espejo no queda nada suyo
// más que lo que ve el rebote. Se mira desde arriba, donde la tabla no tapa la F.
TEST(Espejo, LoDeDetrasNoSeRefleja) {
    const auto gpu = imagenes("espejo", {repite("tecla a", 15) + "; " + arrastra("IZQUIERDO", -40, 50)});
    const auto [ref, deEspejo] = conRebote(EscenaEspejo(3), camaraEspejo(0.10, 0.80), ALFA_ESPEJO);
    comprueba("desde arriba", gpu[0], ref, 0.51 + MEZCLA);
    EXPECT_GT(deEspejo, 1000);
}

namespace {

/// Lo que dibuja espejo_plantilla: con plantilla, un rebote sin mezcla; sin ella, la escena simétrica se ve en toda la vista, salvo donde
/// la real la tapa. Un rayo ve la simétrica a la distancia a la que su simétrico ve la real.
ImagenRef plantilla(bool conPlantilla, int ancho, int alto, int *fuera = nullptr, int *salidos = nullptr) {
    const EscenaEspejo e(0);
    const Camara camara =
        oraculo::perspectiva(oraculo::orbita(-0.30, 0.30, 17.5, {-0.7, 0.95, 0}), 0.5, 1, 60);
    Escena escena = e.escena;
    escena.push_back(oraculo::plano(traslada(CENTRO) * gira(Y, GIRO) * escala({ANCHO, ALTO, 1})));
    const int espejo = static_cast<int>(e.escena.size());
    return oraculo::render(escena, camara, ancho, alto, [&](const Impacto &i) -> Tono {
        if (i.objeto == espejo) {
            const Tono visto = e.reflejo(i.rayo);
            return {visto.color, 1 + visto.zona};
        }
        if (fuera)
            ++*fuera;
        const Vec3 &o = i.rayo.origen, &d = i.rayo.direccion;
        const double alPlano =
            -oraculo::escalar(o - CENTRO, NORMAL_ESPEJO) / oraculo::escalar(d, NORMAL_ESPEJO);
        if (conPlantilla || alPlano < 0)
            return e.tono(i);
        Rayo simetrico{o - 2 * oraculo::escalar(o - CENTRO, NORMAL_ESPEJO) * NORMAL_ESPEJO,
                       oraculo::refleja(d, NORMAL_ESPEJO), alPlano};
        const Impacto virtual_ = oraculo::primerImpacto(e.escena, simetrico);
        if (!virtual_ || (i && virtual_.distancia > i.distancia - 1e-6)) // el suelo y su reflejo coinciden
            return e.tono(i);
        if (salidos)
            ++*salidos;
        const Tono visto = e.tono(virtual_);
        return {visto.color, 1 + visto.zona};
    });
}

void sinRotuloYComprueba(const std::string &que, const Imagen &imagen, const ImagenRef &ref) {
    SinEncima sin(imagen, ref);
    EXPECT_TRUE(sin.rotulo(que, OSCURO, 0.5 * ref.ancho, 0.94 * ref.alto, 12)) << que;
    comprueba(que, sin.limpia, ref);
}

} // namespace

TEST(EspejoPlantilla, ConYSin) {
    const auto gpu = imagenes("espejo_plantilla", {"", "tecla p", "tecla p"});
    int fuera = 0, salidos = 0;
    sinRotuloYComprueba("con plantilla", gpu[0], plantilla(true, 240, 180));
    sinRotuloYComprueba("sin plantilla", gpu[1], plantilla(false, 240, 180, &fuera, &salidos));
    EXPECT_GT(salidos, 500) << "sin plantilla, la escena simétrica se sale del espejo";
    EXPECT_LT(salidos, fuera);
    EXPECT_EQ(gpu[0].rgb, gpu[2].rgb) << "p, dos veces";
}

TEST(EspejoPlantilla, LasDosALaVez) {
    const auto gpu = imagenes("espejo_plantilla", {"tecla v", "tecla v"}, 240, 181);
    sinRotuloYComprueba("sin plantilla", oraculo::recorta(gpu[0], 0, 91, 240, 90), plantilla(false, 240, 90));
    sinRotuloYComprueba("con plantilla", oraculo::recorta(gpu[0], 0, 0, 240, 90), plantilla(true, 240, 90));
    sinRotuloYComprueba("con plantilla", gpu[1], plantilla(true, 240, 181));
}

// --- transparencia -----------------------------------------------------------------------------------------

namespace {

/// Composición de atrás adelante: lo opaco, la pared del cilindro vista por dentro y la vista por fuera.
ImagenRef vidrio(double alfa, double azimut = 0.35, int ancho = 240, int alto = 180) {
    Escena opacos;
    std::vector<Material> materiales;
    const auto pon = [&](const Objeto &o, const Vec3 &color) {
        opacos.push_back(o);
        materiales.push_back(pintado(color, 0.2, 20));
    };
    pon(caja(traslada({0, -0.1, 0}) * escala({4.4, 0.2, 3.4})), {0.85, 0.82, 0.74});
    pon(caja(traslada({0, 0.55, 0}) * gira(Y, 0.6) * escala(0.75)), doble(ROJO));
    pon(enElMundo(traslada({1.45, 0.45, -0.9}) * escala(0.45), esfera(48)), doble(AMARILLO));
    for (int i = 0; i < 5; ++i)
        pon(caja(traslada({-1.8 + 0.55 * i, 0.9, -1.4}) * escala({0.26, 1.8, 0.12})),
            doble(i % 2 ? VERDE : NARANJA));
    const Escena cilindros = {enElMundo(traslada({0, 1.07, 0}) * gira(X, -PI / 2) * escala({1, 1, 2.1}),
                                        cilindro(segmentosPara(250)))};
    const Material cristal{{0.10, 0.28, 0.42}, {0.15, 0.50, 0.75}, {0.9, 0.9, 0.9}, 60};
    const std::vector<oraculo::Luz> luces = {posicional({4, 7, 6})};
    const Camara camara = oraculo::perspectiva(oraculo::orbita(azimut, 0.30, 9.2, {0, 0.95, 0}), 0.5, 1, 60);
    return oraculo::render(opacos, camara, ancho, alto, [&](const Impacto &fondo) -> Tono {
        Vec3 color = fondo ? oraculo::phong(materiales[static_cast<std::size_t>(fondo.objeto)], UNO, luces,
                                            fondo.punto, fondo.normal, oraculo::haciaOjo(fondo))
                           : FONDO;
        int zona = 0;
        std::vector<Impacto> paredes;
        Rayo r = fondo.rayo;
        for (Impacto i = oraculo::primerImpacto(cilindros, r);
             i && (!fondo || i.distancia < fondo.distancia) && paredes.size() < 2;
             i = oraculo::primerImpacto(cilindros, r)) {
            paredes.push_back(i);
            zona = 1000 * zona + 2 * (1 + i.corte.cara) + i.frente;
            r.minimo = i.distancia + 1e-9;
        }
        for (std::size_t k = paredes.size(); k-- > 0;) {
            const Impacto &i = paredes[k];
            color = mezcla(color,
                           oraculo::phong(cristal, UNO, luces, i.punto, i.frente ? i.normal : -i.normal,
                                          oraculo::haciaOjo(i)),
                           alfa);
        }
        return {color, zona};
    });
}

void compruebaVidrio(const std::string &que, const std::string &alfa, const Imagen &imagen,
                     const ImagenRef &ref) {
    SinEncima sin(imagen, ref);
    EXPECT_TRUE(sin.rotulo("α = " + alfa, OSCURO, 0.5 * ref.ancho, 0.93 * ref.alto, 12)) << que;
    comprueba(que, sin.limpia, ref, 0.51 + 2 * MEZCLA);
}

} // namespace

TEST(Transparencia, DeAtrasAdelanteEnDoble) {
    const auto gpu = imagenes("transparencia", {"", "tecla 1", "tecla 3", "tecla 4", "tecla -; tecla -",
                                                repite("tecla +", 9), repite("tecla -", 20)});
    const double alfas[] = {0.4, 0.1, 0.7, 1, 0.8, 1, 0};
    const char *const textos[] = {"0.4", "0.1", "0.7", "1.0", "0.8", "1.0", "0.0"};
    for (std::size_t k = 0; k < 7; ++k)
        compruebaVidrio(std::string("alfa ") + textos[k], textos[k], gpu[k], vidrio(alfas[k]));
}

TEST(Transparencia, DesdeElOtroLado) {
    const auto gpu = imagenes("transparencia", {"tecla 2; " + arrastra("IZQUIERDO", 250, 0)});
    compruebaVidrio("detrás", "0.4", gpu[0], vidrio(0.4, 0.35 - 2.5));
}

TEST(Transparencia, LasCuatroALaVez) {
    const auto gpu = imagenes("transparencia", {"tecla v"}, 481, 361);
    const char *const textos[] = {"0.1", "0.4", "0.7", "1.0"};
    const double alfas[] = {0.1, 0.4, 0.7, 1};
    const int x[] = {0, 241, 0, 241}, y[] = {181, 181, 0, 0}, ancho[] = {239, 240, 239, 240},
              alto[] = {180, 180, 179, 179};
    for (int k = 0; k < 4; ++k)
        compruebaVidrio(std::string("panel ") + textos[k], textos[k],
                        oraculo::recorta(gpu[0], x[k], y[k], ancho[k], alto[k]),
                        vidrio(alfas[k], 0.35, ancho[k], alto[k]));
}

// --- orden_transparencia -----------------------------------------------------------------------------------

namespace {

/// Un panel: las barras opacas y los dos cristales, lisos, en el orden dado (0, el rojo). Con `aditivo`, la ecuación 7.2.
ImagenRef cristales(std::array<int, 2> orden, bool aditivo, double azimut, int ancho, int alto) {
    Escena barras;
    for (const double x : {-0.9, 0.0, 0.9})
        barras.push_back(caja(traslada({x, 0, -1}) * escala({0.12, 2, 0.12})));
    const Escena cristal[2] = {{oraculo::plano(traslada({-0.35, 0.15, 0.5}) * escala({1.5, 2.4, 1}))},
                               {oraculo::plano(traslada({0.35, -0.15, -0.5}) * escala({1.5, 2.4, 1}))}};
    const Vec3 colores[2] = {{1, 0.25, 0.2}, {0.25, 0.6, 1}};
    const double alfa = 0.55;
    const Camara camara = oraculo::perspectiva(oraculo::orbita(azimut, 0.15, 6.5), 0.36, 1, 30);
    return oraculo::render(barras, camara, ancho, alto, [&](const Impacto &i) -> Tono {
        Vec3 color = i ? doble(GRIS) : doble(FONDO_OSCURO);
        int zona = 0;
        for (const int k : orden) {
            const Impacto c = oraculo::primerImpacto(cristal[k], i.rayo);
            if (!c || (i && c.distancia > i.distancia))
                continue;
            zona += 1 + k;
            color = aditivo ? recortado(color + alfa * colores[k]) : mezcla(color, colores[k], alfa);
        }
        return {color, zona};
    });
}

Imagen compruebaCristales(const Imagen &ventana, bool derecha, const std::string &modo,
                          std::array<int, 2> orden, bool aditivo, double azimut = 0.35) {
    const Imagen imagen = oraculo::recorta(ventana, derecha ? 121 : 0, 0, 120, 180);
    const ImagenRef ref = cristales(orden, aditivo, azimut, 120, 180);
    SinEncima sin(imagen, ref);
    EXPECT_TRUE(sin.rotulo(modo, AMARILLO, 60, 0.94 * 180, 3)) << modo;
    EXPECT_TRUE(sin.rotulo(derecha ? "antes el azul" : "antes el rojo", BLANCO, 60, 0.06 * 180, 3)) << modo;
    comprueba(modo, sin.limpia, ref, 0.51 + 2 * MEZCLA);
    return sin.limpia;
}

} // namespace

// Ecuaciones 7.1 y 7.2 con los colores exactos. Según llegan, los dos lados difieren donde se solapan; ordenados o sumando, no.
TEST(OrdenTransparencia, ColoresExactos) {
    const auto gpu = imagenes("orden_transparencia", {"", "tecla 2", "tecla 3", "tecla 1"}, 241, 180);
    const Imagen rojo = compruebaCristales(gpu[0], false, "según llegan", {0, 1}, false),
                 azul = compruebaCristales(gpu[0], true, "según llegan", {1, 0}, false);
    const Imagen rojo2 = compruebaCristales(gpu[1], false, "ordenados", {1, 0}, false),
                 azul2 = compruebaCristales(gpu[1], true, "ordenados", {1, 0}, false);
    const Imagen rojo3 = compruebaCristales(gpu[2], false, "aditivo", {0, 1}, true),
                 azul3 = compruebaCristales(gpu[2], true, "aditivo", {1, 0}, true);
    EXPECT_EQ(gpu[0].rgb, gpu[3].rgb);
    const auto distintos = [](const Imagen &a, const Imagen &b) {
        int n = 0;
        for (std::size_t i = 0; i < a.rgb.size(); i += 3)
            n += std::abs(a.rgb[i] - b.rgb[i]) > 2;
        return n;
    };
    EXPECT_GT(distintos(rojo, azul), 1000); // donde se solapan
    EXPECT_EQ(rojo2.rgb, azul2.rgb);
    EXPECT_EQ(rojo3.rgb, azul3.rgb);
}

// Por detrás el más lejano es el otro: el orden no es fijo.
TEST(OrdenTransparencia, PorDetrasSeOrdenanAlReves) {
    const auto gpu = imagenes("orden_transparencia", {"tecla 2; " + arrastra("IZQUIERDO", 300, 0)}, 241, 180);
    compruebaCristales(gpu[0], false, "ordenados", {0, 1}, false, 0.35 - 3);
    compruebaCristales(gpu[0], true, "ordenados", {0, 1}, false, 0.35 - 3);
}

// --- sombras -----------------------------------------------------------------------------------------------

namespace {

struct Sombras {
    Vec3 luz{-1.8, 3.6, 0.8};
    bool transparente = true, plantilla = true;
    Camara camara = oraculo::perspectiva(oraculo::orbita(0.25, 0.42, 13, {0, 1.2, 0}), 0.45, 1, 60);
    int enSombra = 0, dobles = 0, fuera = 0; // píxeles de sombra, con más de una capa y fuera de la mesa

    ImagenRef traza(int ancho = 240, int alto = 180) {
        const Mat4 dePie = gira(X, -PI / 2);
        const Escena objetos = {
            enElMundo(traslada({-0.6, 1.1, 0.3}) * gira(Y, 0.7), toro(0.7f, 0.22f, 64, 32)),
            enElMundo(traslada({-0.6, 0.1, 0.3}) * dePie * escala({0.35, 0.35, 0.2}), cilindro(48)),
            enElMundo(traslada({1.4, 0.5, 1.1}) * escala(0.5), esfera(48)),
            caja(traslada({0.75, 0.45, -1.0}) * gira(Y, 0.5) * escala(0.9)),
            enElMundo(traslada({1.9, 0.55, -0.5}) * dePie * escala({0.16, 0.16, 1.1}), cilindro(48)),
        };
        Escena escena = objetos;
        escena.push_back(oraculo::plano(dePie * escala({6, 4.4, 1})));             // 5: el tablero
        escena.push_back(caja(traslada({0, -0.135, 0}) * escala({6, 0.25, 4.4}))); // 6: la tabla
        escena.push_back(enElMundo(traslada(luz) * escala(0.14), esfera(48)));     // 7: la lámpara
        const Vec3 colores[] = {doble(NARANJA), doble(OSCURO),      doble(ROJO),       doble(VERDE),
                                doble(AZUL),    {0.88, 0.80, 0.66}, {0.55, 0.38, 0.22}};
        return oraculo::render(escena, camara, ancho, alto, [&](const Impacto &i) -> Tono {
            Vec3 color = FONDO;
            if (i && i.objeto == 7)
                color = {1, 0.95, 0.6};
            else if (i)
                color = oraculo::phong(pintado(colores[i.objeto], 0.3, 30), UNO, {posicional(luz)}, i.punto,
                                       i.normal, oraculo::haciaOjo(i));
            // el punto del plano de la mesa que se ve, si nada lo tapa
            const double t = -i.rayo.origen.y / i.rayo.direccion.y;
            const bool enMesa = i.objeto == 5;
            if (luz.y <= 0 || t < 0 || (i && !enMesa && i.distancia < t) || (plantilla && !enMesa))
                return color;
            const Vec3 p = i.rayo.origen + t * i.rayo.direccion;
            Rayo r = oraculo::rayoDesde(p, luz - p, oraculo::longitud(luz - p));
            int capas = 0; // caras que miran a la luz, entre el punto y ella
            for (Impacto tapa = oraculo::primerImpacto(objetos, r); tapa;
                 tapa = oraculo::primerImpacto(objetos, r)) {
                capas += !tapa.frente;
                r.minimo = tapa.distancia + 1e-9;
            }
            enSombra += capas > 0, dobles += capas > 1, fuera += capas > 0 && !enMesa;
            if (capas && plantilla)
                capas = 1;
            for (int k = 0; k < capas; ++k)
                color = transparente ? mezcla(color, {}, 0.5) : doble(OSCURO);
            return {color, capas};
        });
    }
    /// Sin plantilla, el desplazamiento adelanta la sombra un cuarto de píxel sobre lo que se apoya en la mesa.
    void comprueba(const std::string &que, const Imagen &imagen) {
        const ImagenRef ref = traza(imagen.ancho, imagen.alto);
        SinEncima sin(imagen, ref);
        const Vec3 p = oraculo::proyecta(camara, imagen.ancho, imagen.alto, luz);
        EXPECT_TRUE(sin.rotulo("luz", OSCURO, p.x, p.y, 30)) << que;
        ::comprueba(que, sin.limpia, ref, 0.51 + (plantilla ? 1 : 3) * MEZCLA, plantilla ? 500 : 200);
    }
};

} // namespace

TEST(Sombras, ContraRayosALaLuz) {
    const auto gpu = imagenes("sombras", {"", "tecla t", "tecla t; tecla p", "tecla p"});
    Sombras s;
    s.comprueba("transparente", gpu[0]);
    EXPECT_GT(s.dobles, 50) << "donde se solapan";
    s.transparente = false;
    s.comprueba("opaca", gpu[1]);
    s = {};
    s.plantilla = false;
    s.comprueba("sin plantilla", gpu[2]);
    EXPECT_GT(s.dobles, 50);
    EXPECT_GT(s.fuera, 10) << "la sombra se sale de la mesa";
    EXPECT_EQ(gpu[0].rgb, gpu[3].rgb);
}

// Con la luz más baja que los objetos, lo que queda por encima de ella no da sombra, ni la da al otro lado.
TEST(Sombras, LuzMasBajaQueLosObjetos) {
    const auto gpu = imagenes("sombras", {arrastra("DERECHO", 0, 310), arrastra("DERECHO", 150, -40)});
    Sombras s;
    s.luz.y = 0.5;
    s.comprueba("luz baja", gpu[0]);
    EXPECT_GT(s.enSombra, 1000);
    s.luz = {-0.3, 0.9, 0.8};
    s.comprueba("entre los objetos", gpu[1]);
}

// Desde el otro lado la antisombra, si la hubiera, estaría delante de la cámara.
TEST(Sombras, SinAntisombraDesdeNingunLado) {
    for (const int giro : {-150, 100, 200}) {
        const auto gpu = imagenes(
            "sombras", {arrastra("DERECHO", 0, 300) + "; tecla p; " + arrastra("IZQUIERDO", giro, 0)});
        Sombras s;
        s.luz.y = 0.6;
        s.plantilla = false;
        s.camara =
            oraculo::perspectiva(oraculo::orbita(0.25 - 0.01 * giro, 0.42, 13, {0, 1.2, 0}), 0.45, 1, 60);
        s.comprueba("giro " + std::to_string(giro), gpu[0]);
    }
}

// Bajo la mesa la luz no da sombras; por mucho que se arrastre, se queda en sus topes.
TEST(Sombras, LuzBajoLaMesa) {
    const auto gpu = imagenes("sombras", {arrastra("DERECHO", -500, -500), arrastra("DERECHO", 900, 0),
                                          arrastra("DERECHO", 0, 900)});
    Sombras s;
    s.luz = {-3, 4, 0.8};
    s.comprueba("arriba a la izquierda", gpu[0]);
    s.luz.x = 3;
    s.comprueba("arriba a la derecha", gpu[1]);
    s.luz.y = -0.5;
    s.enSombra = 0;
    s.comprueba("debajo", gpu[2]);
    EXPECT_EQ(s.enSombra, 0);
}

// El botón derecho mueve la luz y no la cámara; el central, nada.
TEST(Sombras, SoloElBotonDerechoMueveLaLuz) {
    const auto gpu =
        imagenes("sombras", {"", "boton CENTRAL abajo 50 60; arrastra 90 90; boton CENTRAL arriba 90 90",
                             arrastra("IZQUIERDO", 20, 10)});
    EXPECT_EQ(gpu[0].rgb, gpu[1].rgb);
    Sombras s;
    s.camara = oraculo::perspectiva(oraculo::orbita(0.05, 0.52, 13, {0, 1.2, 0}), 0.45, 1, 60);
    s.comprueba("girada", gpu[2]);
}

// Sin desplazamiento, mesa y sombra se cosen: faltan trozos de sombra. Con él, ni uno, desde cualquier lado.
TEST(Sombras, DesplazamientoDePoligono) {
    const auto gpu = imagenes("sombras", {"tecla o", "tecla o"});
    Sombras s;
    const ImagenRef ref = s.traza();
    const auto cosidos = [&](const Imagen &imagen) {
        int n = 0;
        for (int y = 0; y < 180; ++y)
            for (int x = 0; x < 240; ++x)
                n += ref.en(x, y).objeto == 5 && ref.en(x, y).zona == 1 && !oraculo::enBanda(ref, x, y) &&
                     oraculo::diferencia(imagen, x, y, ref.en(x, y).color) > 2;
        return n;
    };
    EXPECT_GT(cosidos(gpu[0]), 100);
    EXPECT_EQ(cosidos(gpu[1]), 0);
}
