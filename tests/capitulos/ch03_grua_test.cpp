// La grúa del ejercicio 3.5: cada tecla, con su tope, y cada píxel.
#include "colores.h"
#include "panel.h"
#include "tabla.h"

namespace {

using namespace oraculo;

const Camara CAMARA = perspectiva(orbita(0.5, 0.25, 40, {0.4, 4.1, 0}), 0.45, 1, 200);

/// La grúa con sus medidas escritas otra vez, el suelo y la zapata.
std::vector<Cuerpo> escenaGrua(double giro, double distancia, double altura) {
    const Vec3 amarillo{0.98, 0.78, 0.15};
    const double cable = 10 - (altura + 0.5);
    const Mat4 G = gira({0, 1, 0}, giro);
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

TEST(Grua, ContraTrazadoDeRayos) {
    const struct {
        std::string guion;
        double giro, distancia, altura;
    } casos[] = {
        {"", 0, 5, 4},
        {"tecla a ×3; tamano 200 333", 0.3, 5, 4},
        {"tecla d ×10; tamano 240 180", -0.7, 5, 4},
        {"tecla a ×7; tecla q ×3", 0, 3.5, 4},
        {"tecla e ×6", 0, 6.5, 4},
        {"tecla e ×40", 0, 7, 4},
        {"tecla q ×4; tecla w ×4", 0, 5, 6},
        {"tecla w ×40", 0, 5, 9},
        {"tecla s ×40", 0, 5, 0.5},
        {"tecla w ×7; tecla q ×40; tecla d ×8", -0.8, 1.4, 4},
    };
    paraCada("grua", casos, 240, 180, [](const auto &c, const Vista &v) {
        compruebaEscena(v, {CAMARA, v.escena}, escenaGrua(c.giro, c.distancia, c.altura), CIELO);
    });
}
