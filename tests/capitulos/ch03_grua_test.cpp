// La grúa del ejercicio 3.5: las medidas del enunciado, por dónde puede ir la carga y dónde se ve cada esquina.
// Que cada píxel sea el que debe está en oraculo_test.cpp.
#include "ch03_transformaciones/grua.h"
#include "ejecuta.h"
#include "oraculo/oraculo.h"
#include <gtest/gtest.h>
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

struct Rectangulo {
    double izquierda = HUGE_VAL, derecha = -HUGE_VAL, abajo = HUGE_VAL, arriba = -HUGE_VAL;
    void anade(double x, double y) {
        izquierda = std::min(izquierda, x), derecha = std::max(derecha, x);
        abajo = std::min(abajo, y), arriba = std::max(arriba, y);
    }
};

/// Las esquinas de un bloque de esos lados, en píxeles.
void proyectaEsquinas(Rectangulo &r, const Mat4 &M, const Vec3 &lados, int ancho, int alto) {
    const oraculo::Camara camara = perspectiva(oraculo::orbita(0.5, 0.25, 23, {1.5, 5.2, 0}), 0.6, 1, 100);
    for (double x : {-0.5, 0.5})
        for (double y : {-0.5, 0.5})
            for (double z : {-0.5, 0.5}) {
                const Vec3 p =
                    proyecta(camara, ancho, alto, punto(M, {x * lados.x, y * lados.y, z * lados.z}));
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
    proyectaEsquinas(amarillo, traslada({0, 5, 0}), {0.8, 10, 0.8}, ancho, alto);
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
