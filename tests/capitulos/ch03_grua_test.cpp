// La grúa del ejercicio 3.5: las medidas del enunciado, por dónde puede ir la carga, dónde se ve cada esquina y que cada píxel
// sea el que debe.
#include "ch03_oraculo.h"
#include "ch03_transformaciones/grua.h"
#include "ejecuta.h"
#include <algorithm>
#include <gtest/gtest.h>
#include <iostream>
#include <sstream>

namespace {

using oraculo::Mat4;
using oraculo::traslada;
using oraculo::Vec3;

enum { PIE, BRAZO, CONTRAPESO, CABLE, CARGA };

struct Caja {
    glm::dvec3 minimo{HUGE_VAL}, maximo{-HUGE_VAL};
    void anade(const glm::dvec3 &p) {
        minimo = glm::min(minimo, p), maximo = glm::max(maximo, p);
    }
};

/// La caja que contiene la pieza en el sistema del brazo (sin el giro), en doble.
Caja enElBrazo(const Pieza &pieza, double giro) {
    Caja caja;
    for (double x : {-0.5, 0.5})
        for (double y : {-0.5, 0.5})
            for (double z : {-0.5, 0.5}) {
                const glm::dvec4 p = glm::dmat4(pieza.M) * glm::dvec4(x, y, z, 1);
                caja.anade({std::cos(giro) * p.x - std::sin(giro) * p.z, p.y,
                            std::sin(giro) * p.x + std::cos(giro) * p.z});
            }
    return caja;
}

std::string repite(const std::string &orden, int veces) {
    std::string guion;
    for (int i = 0; i < veces; ++i)
        guion += orden + "; ";
    return guion;
}

const oraculo::Camara CAMARA = perspectiva(oraculo::orbita(0.5, 0.25, 29.5, {0.4, 4.1, 0}), 0.6, 1, 100);

struct Rectangulo {
    double izquierda = HUGE_VAL, derecha = -HUGE_VAL, abajo = HUGE_VAL, arriba = -HUGE_VAL;
    void anade(double x, double y) {
        izquierda = std::min(izquierda, x), derecha = std::max(derecha, x);
        abajo = std::min(abajo, y), arriba = std::max(arriba, y);
    }
};

/// Las esquinas de un bloque de esos lados, en píxeles.
void proyectaEsquinas(Rectangulo &r, const Mat4 &M, const Vec3 &lados, int ancho, int alto) {
    for (double x : {-0.5, 0.5})
        for (double y : {-0.5, 0.5})
            for (double z : {-0.5, 0.5}) {
                const Vec3 p =
                    proyecta(CAMARA, ancho, alto, punto(M, {x * lados.x, y * lados.y, z * lados.z}));
                r.anade(p.x, p.y);
            }
}

/// Lo que ocupan en la ventana los píxeles que cumplen `es`, medido en sus bordes.
template<class Es>
Rectangulo ocupan(const Imagen &imagen, Es es) {
    Rectangulo r;
    for (int y = 0; y < imagen.alto; ++y)
        for (int x = 0; x < imagen.ancho; ++x)
            if (es(pixel(imagen, x, y)))
                r.anade(x, y), r.anade(x + 1, y + 1);
    return r;
}
bool esRojo(const Pixel &p) {
    return p.r > 2 * p.g && p.r > 2 * p.b;
}
bool esAmarillo(const Pixel &p) {
    return p.r > 3 * p.b && p.g > 2 * p.b;
}

void compara(const Rectangulo &visto, const Rectangulo &exacto, const std::string &guion) {
    EXPECT_NEAR(visto.izquierda, exacto.izquierda, 1) << guion;
    EXPECT_NEAR(visto.derecha, exacto.derecha, 1) << guion;
    EXPECT_NEAR(visto.abajo, exacto.abajo, 1) << guion;
    EXPECT_NEAR(visto.arriba, exacto.arriba, 1) << guion;
}

/// Tras el guion, la carga está a esa distancia del pie y a esa altura, con ese giro; y su cara de frente es roja.
void compruebaCarga(const std::string &guion, double giro, double distancia, double altura, int ancho = 480,
                    int alto = 360) {
    const Ejecucion e = ejecuta("ch03_transformaciones/grua", guion, ancho, alto);
    ASSERT_EQ(e.estado, 0) << e.errores;
    const Mat4 G = oraculo::gira({0, 1, 0}, giro);
    Rectangulo carga, amarillo;
    proyectaEsquinas(carga, G * traslada({distancia, altura, 0}), {1, 1, 1}, ancho, alto);
    compara(ocupan(e.imagen, esRojo), carga, guion);
    proyectaEsquinas(amarillo, traslada({0, 5.025, 0}), {0.8, 9.95, 0.8}, ancho, alto); // sale de la zapata
    proyectaEsquinas(amarillo, G * traslada({2.5, 10.4, 0}), {10, 0.8, 0.8}, ancho, alto);
    compara(ocupan(e.imagen, esAmarillo), amarillo, guion);
}

} // namespace

// Las longitudes de las tres primeras columnas de M son los lados del bloque: contrapeso de 1.4, carga de 1, pie
// y brazo de 10. Los senos y cosenos del giro llegan con 2⁻²⁴ de error relativo, y los productos con otro tanto.
TEST(Grua, MedidasDelEnunciado) {
    for (float giro : {0.0f, 0.7f, -2.0f, 3.0f, 1e4f}) {
        const auto piezas = piezasGrua({giro, 5, 4});
        ASSERT_EQ(piezas.size(), 5u);
        const auto lado = [&](int pieza, int columna) {
            return glm::length(glm::dvec3(piezas[static_cast<std::size_t>(pieza)].M[columna]));
        };
        EXPECT_NEAR(lado(PIE, 1), 10, 10 * 0x1p-23);
        EXPECT_NEAR(lado(BRAZO, 0), 10, 10 * 0x1p-22);
        for (int columna = 0; columna < 3; ++columna) {
            EXPECT_NEAR(lado(CONTRAPESO, columna), 1.4, 1.4 * 0x1p-22);
            EXPECT_NEAR(lado(CARGA, columna), 1, 0x1p-22);
        }
    }
}

// Se pida lo que se pida: dentro del brazo y del contrapeso hacia fuera, sobre el suelo, bajo el brazo y sin
// tocar el pie, que no gira con ella: cabe en un círculo de radio 0.4·√2. El cable va de la carga al brazo.
TEST(Grua, LaCargaNoSaleDelBrazoNiTocaElPieNiElSuelo) {
    const double holgura = 2e-5; // 16 unidades de redondeo de un número de tamaño 10
    int posturas = 0;
    for (float giro = -7; giro <= 7; giro += 0.37f)
        for (float distancia = -3; distancia <= 13; distancia += 0.73f)
            for (float altura = -3; altura <= 14; altura += 0.61f) {
                const auto piezas = piezasGrua({giro, distancia, altura});
                const Caja carga = enElBrazo(piezas[CARGA], giro), brazo = enElBrazo(piezas[BRAZO], giro),
                           cable = enElBrazo(piezas[CABLE], giro),
                           contrapeso = enElBrazo(piezas[CONTRAPESO], giro);
                std::ostringstream postura;
                postura << "giro " << giro << ", distancia " << distancia << ", altura " << altura;
                SCOPED_TRACE(postura.str());
                ASSERT_LE(carga.maximo.x, brazo.maximo.x + holgura);
                ASSERT_GE(carga.minimo.y, -holgura);
                ASSERT_LE(carga.maximo.y, brazo.minimo.y + holgura);
                ASSERT_GT(carga.minimo.x, 0.4 * std::sqrt(2.0));
                ASSERT_LT(contrapeso.maximo.x, -0.4 * std::sqrt(2.0));
                ASSERT_NEAR(cable.minimo.y, carga.maximo.y, holgura);
                ASSERT_NEAR(cable.maximo.y, brazo.minimo.y, holgura);
                ASSERT_NEAR(brazo.maximo.x - brazo.minimo.x, 10, holgura);
                ASSERT_NEAR(contrapeso.minimo.x, brazo.minimo.x, holgura);
                // y entre los topes está donde se pide
                ASSERT_NEAR((carga.minimo.x + carga.maximo.x) / 2, std::clamp(distancia, 1.4f, 7.0f),
                            holgura);
                ASSERT_NEAR((carga.minimo.y + carga.maximo.y) / 2, std::clamp(altura, 0.5f, 9.0f), holgura);
                ++posturas;
            }
    RecordProperty("posturas", posturas);
    EXPECT_GT(posturas, 20000);
}

TEST(Grua, EsquinasProyectadas) {
    compruebaCarga("", 0, 5, 4);
    compruebaCarga("", 0, 5, 4, 240, 180);
    compruebaCarga("", 0, 5, 4, 200, 400);
}

TEST(Grua, CadaTeclaHaceLoSuyo) {
    compruebaCarga(repite("tecla a", 3), 0.3, 5, 4);
    compruebaCarga(repite("tecla d", 8), -0.8, 5, 4);
    compruebaCarga(repite("tecla e", 3), 0, 6.5, 4);
    compruebaCarga(repite("tecla q", 3), 0, 3.5, 4);
    compruebaCarga(repite("tecla w", 4), 0, 5, 6);
    compruebaCarga(repite("tecla s", 4), 0, 5, 2);
    compruebaCarga("tecla a; tecla d; tecla q; tecla e; tecla w; tecla s", 0, 5, 4);
}

// Al llegar al tope se queda en él, y la tecla contraria responde a la primera.
TEST(Grua, LosTopes) {
    compruebaCarga(repite("tecla e", 40), 0, 7, 4);
    compruebaCarga(repite("tecla e", 40) + "tecla q", 0, 6.5, 4);
    compruebaCarga(repite("tecla w", 40), 0, 5, 9);
    compruebaCarga(repite("tecla s", 40), 0, 5, 0.5);
    // arrimada al pie, con la grúa girada para que este no la tape
    compruebaCarga(repite("tecla q", 40) + repite("tecla d", 8), -0.8, 1.4, 4);
}

// --- Cada píxel --------------------------------------------------------------------------------------------

namespace {

/// La grúa con sus medidas escritas otra vez, el suelo y la zapata.
std::vector<ch03::Cuerpo> escenaGrua(double giro, double distancia, double altura) {
    using oraculo::caja, oraculo::escala;
    const Vec3 amarillo{0.98, 0.78, 0.15};
    const double cable = 10 - (altura + 0.5);
    const Mat4 G = oraculo::gira({0, 1, 0}, giro);
    return {
        {caja(traslada({0, -0.1, 0}) * escala({14, 0.2, 14})), {0.62, 0.72, 0.58}}, // suelo
        {caja(escala({3, 0.1, 3})), {0.80, 0.80, 0.78}},                            // zapata
        {caja(traslada({0, 5, 0}) * escala({0.8, 10, 0.8})), amarillo},             // pie
        {caja(G * traslada({2.5, 10.4, 0}) * escala({10, 0.8, 0.8})), amarillo},    // brazo: de −2.5 a 7.5
        {caja(G * traslada({-1.8, 9.3, 0}) * escala(1.4)), {0.55, 0.58, 0.62}},     // contrapeso
        {caja(G * traslada({distancia, 10 - cable / 2, 0}) * escala({0.12, cable, 0.12})),
         {0.16, 0.17, 0.20}},
        {caja(G * traslada({distancia, altura, 0})), {0.85, 0.20, 0.18}}, // carga
    };
}

oraculo::Comparacion comparaGrua(const std::string &guion, double giro, double distancia, double altura,
                                 int ancho = 240, int alto = 180) {
    const Ejecucion e = ejecuta("ch03_transformaciones/grua", guion, ancho, alto);
    EXPECT_EQ(e.estado, 0) << e.errores;
    int tapados = 0;
    const oraculo::Comparacion c =
        ch03::compara(e.imagen, escenaGrua(giro, distancia, altura), CAMARA, {0.87, 0.93, 0.98}, 2,
                      {OSCURO, BLANCO, 0.8f * SUELO}, &tapados);
    EXPECT_LT(tapados, ancho * alto / 8) << guion;
    return c;
}

} // namespace

// Caras planas de normal constante: nada se interpola, y lo único que se pierde es el redondeo a 8 bits, 0.5. Los
// bordes solo pueden fallar por la rejilla de 1/256 de píxel a la que OpenGL lleva cada vértice.
TEST(Grua, ContraTrazadoDeRayos) {
    for (const oraculo::Comparacion &c :
         {comparaGrua("", 0, 5, 4), comparaGrua(repite("tecla d", 7), -0.7, 5, 4),
          comparaGrua(repite("tecla e", 6), 0, 7, 4), // llega al tope
          comparaGrua(repite("tecla w", 12), 0, 5, 9), comparaGrua(repite("tecla a", 3), 0.3, 5, 4, 120, 200),
          comparaGrua("", 0, 5, 4, 480, 360)}) {
        std::cout << c << "\n";
        EXPECT_LE(c.maximo, 0.501) << c;
        EXPECT_LE(c.desvio, 0.012) << c;
    }
    // y distingue un giro de una centésima de radián
    const oraculo::Comparacion c = comparaGrua("", 0.01, 5, 4);
    EXPECT_GT(c.desvio, 0.2) << c;
}

// Cada letrero, junto a su pieza, que no tapa: a la derecha, encima o a la izquierda de ella, también girada.
TEST(Grua, CadaPiezaConSuNombre) {
    for (const double giro : {0.0, -0.3}) {
        const Ejecucion e =
            ejecuta("ch03_transformaciones/grua", giro == 0 ? "" : repite("tecla d", 3), 480, 360);
        const Mat4 G = oraculo::gira({0, 1, 0}, giro);
        const struct {
            std::u32string nombre;
            Vec3 punto;
            int alLado; // dónde está el rótulo: −1 a la izquierda, 1 a la derecha, 0 encima o debajo
        } letreros[] = {{U"pie", {-0.4, 5, 0.4}, -1},
                        {U"brazo", punto(G, {2.5, 10.8, 0}), 0},
                        {U"contrapeso", punto(G, {-2.9, 9.0, 0}), -1},
                        {U"cable", punto(G, {5.06, 7.25, 0}), 1},
                        {U"carga", punto(G, {5, 3.2, 0}), 0}};
        for (const auto &l : letreros)
            EXPECT_TRUE(ch03::rotuladoJunto(e.imagen, CAMARA, l.punto, l.nombre, l.alLado))
                << l.punto.y << " giro " << giro;
    }
}

// La cuadrícula: una línea cada dos unidades, de borde a borde, en las dos direcciones, y ninguna entre medias.
TEST(Grua, LaCuadriculaDelSuelo) {
    const Ejecucion e = ejecuta("ch03_transformaciones/grua", "", 960, 720);
    int lineas = 0, detras = 0;
    for (double x = -5; x <= 5; x += 2) {
        for (double a = 4.2; a < 7; a += 0.2) // enteras: delante y a la izquierda, donde nada las tapa
            for (const Vec3 &p : {Vec3{x, 0, a}, Vec3{-a, 0, x}})
                lineas += ch03::hayTrazo(e.imagen, CAMARA, p, 0.8f * SUELO);
        for (double a = 4.2; a < 7; a += 0.2)
            for (const Vec3 &p : {Vec3{x, 0, -a}, Vec3{a, 0, x}})
                detras += ch03::hayTrazo(e.imagen, CAMARA, p, 0.8f * SUELO);
        for (const Vec3 &p : {Vec3{x - 1, 0, 6}, Vec3{-6, 0, x - 1}})
            EXPECT_FALSE(ch03::hayTrazo(e.imagen, CAMARA, p, 0.8f * SUELO)) << x;
    }
    EXPECT_EQ(lineas, 12 * 14);
    EXPECT_GT(detras, 12 * 14 * 8 / 10); // el pie y un rótulo tapan algo
}
