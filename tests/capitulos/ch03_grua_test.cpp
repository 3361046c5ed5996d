// La grúa del ejercicio 3.5: las medidas del enunciado, por dónde puede ir la carga, dónde se ve cada esquina y que cada píxel
// sea el que debe.
#include "ch03_transformaciones/grua.h"
#include "colores.h"
#include "contra_oraculo.h"
#include "guiones.h"
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

const oraculo::Camara CAMARA = perspectiva(oraculo::orbita(0.5, 0.25, 29.5, {0.4, 4.1, 0}), 0.6, 1, 100);

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

// --- Cada píxel --------------------------------------------------------------------------------------------

namespace {

/// La grúa con sus medidas escritas otra vez, el suelo y la zapata.
std::vector<Cuerpo> escenaGrua(double giro, double distancia, double altura) {
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

// Caras planas de normal constante: nada se interpola, y lo único que se pierde es el redondeo a 8 bits. Los bordes
// solo pueden fallar por la rejilla de 1/256 de píxel a la que OpenGL lleva cada vértice.
const Cotas EXACTA = {0.501, 500, 0.012};

oraculo::Comparacion comparaGrua(const Imagen &escena, double giro, double distancia, double altura) {
    return comparaConLuzFija(escena, escenaGrua(giro, distancia, altura), CAMARA, {0.87, 0.93, 0.98}, 2);
}

} // namespace

// Cada tecla hace lo suyo, con su tope, en el que se queda y del que vuelve a la primera.
TEST(Grua, ContraTrazadoDeRayos) {
    const struct {
        std::string guion;
        double giro, distancia, altura;
        int ancho, alto;
    } casos[] = {
        {"", 0, 5, 4, 240, 180},
        {"", 0, 5, 4, 480, 360},
        {veces(3, "tecla a"), 0.3, 5, 4, 120, 200},
        {veces(7, "tecla d"), -0.7, 5, 4, 240, 180},
        {veces(3, "tecla q"), 0, 3.5, 4, 240, 180},
        {veces(3, "tecla e"), 0, 6.5, 4, 240, 180},
        {veces(4, "tecla w"), 0, 5, 6, 240, 180},
        {veces(4, "tecla s"), 0, 5, 2, 240, 180},
        {"tecla a; tecla d; tecla q; tecla e; tecla w; tecla s", 0, 5, 4, 240, 180},
        {veces(40, "tecla e"), 0, 7, 4, 240, 180},
        {veces(40, "tecla e") + "; tecla q", 0, 6.5, 4, 240, 180},
        {veces(40, "tecla w"), 0, 5, 9, 240, 180},
        {veces(40, "tecla s"), 0, 5, 0.5, 240, 180},
        {veces(40, "tecla q") + "; " + veces(8, "tecla d"), -0.8, 1.4, 4, 240, 180},
    };
    for (const auto &c : casos)
        comprueba(
            "«" + c.guion + "»",
            comparaGrua(vistaDe("grua", c.guion, c.ancho, c.alto).escena, c.giro, c.distancia, c.altura),
            EXACTA);
}

TEST(Grua, ElOraculoDistingueUnaCentesimaDeRadian) {
    EXPECT_GT(comparaGrua(vistaDe("grua").escena, 0.01, 5, 4).desvio, 0.2);
}

// Cada letrero nombra su pieza, también girada, y no la tapa.
TEST(Grua, CadaPiezaConSuNombre) {
    for (const double giro : {0.0, -0.3}) {
        const Encima encima = vistaDe("grua", veces(giro == 0 ? 0 : 3, "tecla d"), 480, 360).encima;
        const Mat4 G = oraculo::gira({0, 1, 0}, giro);
        const struct {
            const char *nombre;
            Vec3 punto;
            Lado lado;
        } letreros[] = {{"pie", {-0.4, 5, 0.4}, Lado::IZQUIERDA},
                        {"brazo", punto(G, {2.5, 10.8, 0}), Lado::ENCIMA},
                        {"contrapeso", punto(G, {-2.92, 9.02, 0}), Lado::IZQUIERDA},
                        {"cable", punto(G, {5.06, 7.25, -0.06}), Lado::DERECHA},
                        {"carga", punto(G, {5, 3.2, 0}), Lado::DEBAJO}};
        for (const auto &l : letreros)
            compruebaRotulo(encima, l.nombre, enPixeles(CAMARA, l.punto, 480, 360), OSCURO, l.lado);
    }
}

// Una línea cada dos unidades, de borde a borde, en las dos direcciones, y ninguna más.
TEST(Grua, LaCuadriculaDelSuelo) {
    const Encima encima = vistaDe("grua", "", 480, 360).encima;
    const glm::vec3 color = 0.8f * SUELO;
    double largo = 0;
    for (double x = -7; x <= 7; x += 2)
        for (const auto &[a, b] :
             {std::pair(Vec3{x, 0, -7}, Vec3{x, 0, 7}), {Vec3{-7, 0, x}, Vec3{7, 0, x}}}) {
            const glm::dvec2 p = enPixeles(CAMARA, a, 480, 360), q = enPixeles(CAMARA, b, 480, 360);
            compruebaTrazo(encima, {p, q}, color);
            largo += glm::distance(p, q);
        }
    EXPECT_NEAR(encima.largo(color), largo, 1);
}
