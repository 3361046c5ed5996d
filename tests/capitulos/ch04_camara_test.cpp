// La transformación de la cámara (ecuación 4.1): lo que enseña el programa camara. Los casos difíciles están en
// dificil_vista_test.cpp.
#include "ch04_oraculo.h"
#include "tabla.h"

namespace {

using namespace oraculo;

const Vec3 I{0, 1.7, 0};

/// La escena de camara.cpp, escrita otra vez; lo redondo, con las caras que tiene.
std::vector<Cuerpo> escena() {
    return {
        {caja(traslada({0, -0.1, 0}) * escala({6, 0.2, 6})), exacto(SUELO)},
        {caja(traslada({0, 0.75, 0}) * escala({0.3, 1.5, 0.3})), exacto(GRIS)},
        {enElMundo(traslada(I) * escala(0.35), esfera(32)), exacto(AMARILLO)},
        {caja(traslada({-2, 0.9, -1.2}) * escala(1.8)), exacto(ROJO)},
        {enElMundo(traslada({1.9, 0, -1}) * DE_PIE * escala({1, 1, 2.8}), porCaras(cono(32))), exacto(VERDE)},
        {caja(traslada({0.9, 0.4, 2}) * gira({0, 1, 0}, 0.5) * escala({1.6, 0.8, 0.8})), exacto(AZUL)}};
}

} // namespace

// En cada panel, la misma escena trazada: a la derecha, desde la cámara; a la izquierda, desde fuera, con ella.
TEST(Camara, LoQueVe) {
    const Vec3 p1{2.8, 4.1, 1.4}, p2{-2.1, 3.7, 1.5};
    const struct {
        std::string guion;
        Vec3 p, UP;
        double inclinacion = 0; // radianes alrededor de F
    } posturas[] = {{"", p1, Y},
                    {"tecla 2; tecla i ×3", p2, Y, -0.3},
                    {"tecla 2; tecla o", p2, Y, 0.1},
                    {"tecla 2; tecla i; tecla 1", p1, Y}, // cada vista empieza derecha
                    {"tecla 3", {-1.6, 5.6, 1.2}, {1, 0, 0}},
                    {"tecla 4", {2.6, 4.9, -0.4}, {-2.6, -3.2 + 1e-7, 0.4}}}; // UP a 1e-7 de F
    // la de fuera está compuesta para un panel cuadrado: en uno estrecho ve a lo ancho tres cuartos de lo que a 4:3
    const double anguloFuera = 2 * std::atan(0.75 * std::tan(0.57 / 2));
    paraCada("camara", posturas, 240, 180, [&](const auto &c, const Vista &vista) {
        const Vec3 arriba = direccion(gira(I - c.p, c.inclinacion), c.UP), &p = c.p;
        const Panel dentro(perspectiva(miraDesde(p, I, arriba), 1.05, 0.5, 60), vista.escena, 1, 2, 2),
            fuera(perspectiva(orbita(0.35, 0.55, 15.8, {0.3, 2.7, 0}), anguloFuera, 1, 100), vista.escena, 0,
                  2, 2);
        const auto [S, U, atras] = ejes(dentro.camara);
        const Mat4 alMundo = {
            {{S.x, U.x, atras.x, p.x}, {S.y, U.y, atras.y, p.y}, {S.z, U.z, atras.z, p.z}, {0, 0, 0, 1}}};
        compruebaEscena(vista, dentro, escena(), CIELO);
        compruebaEscena(vista, fuera, conCamaraDeFotos(escena(), alMundo * escala(1.3)), FONDO_CLARO);
    });
}
