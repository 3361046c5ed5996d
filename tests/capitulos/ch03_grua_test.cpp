// La grúa del ejercicio 3.5: cada tecla, con su tope; cada píxel y los nombres de las piezas.
#include "colores.h"
#include "guiones.h"
#include "panel.h"
#include <gtest/gtest.h>

namespace {

using oraculo::Mat4;
using oraculo::traslada;
using oraculo::Vec3;

const oraculo::Camara CAMARA = perspectiva(oraculo::orbita(0.5, 0.25, 29.5, {0.4, 4.1, 0}), 0.6, 1, 100);

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

} // namespace

// Cada tecla hace lo suyo, con su tope. En el suelo, una línea cada
// dos unidades, de borde a borde; y cada letrero nombra su pieza.
TEST(Grua, ContraTrazadoDeRayos) {
    const struct {
        std::string guion;
        double giro, distancia, altura;
        int ancho, alto;
    } casos[] = {
        {"", 0, 5, 4, 240, 180},
        {veces(3, "tecla a"), 0.3, 5, 4, 200, 333},
        {veces(7, "tecla d"), -0.7, 5, 4, 240, 180},
        {veces(3, "tecla q"), 0, 3.5, 4, 240, 180},
        {veces(3, "tecla e"), 0, 6.5, 4, 240, 180},
        {veces(4, "tecla w"), 0, 5, 6, 240, 180},
        {veces(4, "tecla s"), 0, 5, 2, 240, 180},
        {veces(40, "tecla e"), 0, 7, 4, 240, 180},
        {veces(40, "tecla w"), 0, 5, 9, 240, 180},
        {veces(40, "tecla s"), 0, 5, 0.5, 240, 180},
        {veces(40, "tecla q") + "; " + veces(8, "tecla d"), -0.8, 1.4, 4, 240, 180},
    };
    for (const auto &[guion, giro, distancia, altura, ancho, alto] : casos) {
        SCOPED_TRACE("«" + guion + "»");
        const Vista vista = vistaDe("grua", guion, ancho, alto);
        const Panel panel(CAMARA, vista.escena);
        compruebaEscena(vista, panel, escenaGrua(giro, distancia, altura), CIELO);

        Dibujo encima = {panel};
        Linea cuadricula;
        for (double x = -7; x <= 7; x += 2)
            cuadricula.insert(cuadricula.end(), {{x, 0, -7}, {x, 0, 7}, {-7, 0, x}, {7, 0, x}});
        encima.traza("segmentos", cuadricula, 0.8f * SUELO, 3, false);
        const Mat4 G = oraculo::gira({0, 1, 0}, giro);
        const auto rotula = [&](const char *nombre, const Vec3 &p, Lado lado) {
            encima.rotula(nombre, panel(punto(G, p)), OSCURO, lado);
        };
        encima.rotula("pie", panel({-0.4, 5, 0.4}), OSCURO, Lado::IZQUIERDA);
        rotula("brazo", {2.5, 10.8, 0}, Lado::ENCIMA);
        rotula("contrapeso", {-2.92, 9.02, 0}, Lado::IZQUIERDA);
        rotula("cable", {distancia + 0.06, (altura + 10.5) / 2, -0.06}, Lado::DERECHA);
        rotula("carga", {distancia, altura - 0.8, 0}, Lado::DEBAJO);
        encima.comprueba(vista);
    }
}
