// giro_eje (§3.4) contra el oráculo. giroEje contra la fórmula de Rodrigues está en dificil_transformaciones_test.cpp.
#include "colores.h"
#include "guiones.h"
#include "panel.h"
#include "tabla.h"

namespace {

using namespace oraculo;

const Vec3 FONDO{0.95, 0.96, 0.98}, SITIO{-1.1, 0.2, 1.2}; // el del avión sin girar

void ponAvion(std::vector<Cuerpo> &cuerpos, const Mat4 &M, double viveza) {
    const Vec3 naranja{0.95, 0.55, 0.10}, amarillo{0.98, 0.78, 0.15}, rojo{0.85, 0.20, 0.18};
    const Vec3 piezas[][3] = {{{0, 0, 0}, {1.1, 0.22, 0.22}, naranja},
                              {{0.1, 0, 0}, {0.32, 0.08, 1.3}, amarillo},
                              {{-0.45, 0, 0}, {0.18, 0.06, 0.5}, amarillo},
                              {{-0.42, 0.22, 0}, {0.2, 0.34, 0.07}, rojo}};
    for (const auto &[centro, lados, color] : piezas)
        cuerpos.push_back({caja(M * traslada(centro) * escala(lados)), FONDO + viveza * (color - FONDO)});
}

} // namespace

// Los dos aviones, píxel a píxel. El botón izquierdo mueve el eje alrededor de los de la pantalla (50 píxeles a la
// derecha son medio radián alrededor de la vertical de la cámara y 30 hacia abajo 0.3 alrededor de su horizontal), y el
// derecho, después, gira la cámara.
TEST(ProgramaGiroEje, CadaEjeContraElOraculo) {
    const auto camara = [](double azimut, double elevacion) {
        return perspectiva(orbita(azimut, elevacion, 7.4), 0.6, 1, 30);
    };
    const Ejes pantalla = ejes(camara(-0.5, 0.4));
    const Vec3 diagonal{1, 1, 1}, oblicuo{-0.6, 0.7, 0.4};
    const struct {
        std::string guion;
        Vec3 eje;
        double angulo, azimut = -0.5, elevacion = 0.4;
        bool cambiado = false; // con d en el eje X, e en el Y y f en el Z
    } casos[] = {
        {"", Y, 2},
        {"tecla 2; tamano 150 200", diagonal, 2},
        {"tecla 3; tecla t", oblicuo, 0},
        {"tecla t", oblicuo, 0, -0.5, 0.4, true},
        {"tecla t", oblicuo, 2, -0.5, 0.4, true},
        {"tecla t; tecla 4; tecla d; tamano 240 180", {1, 1e-10, 0}, 1.9},
        {"tecla 3; tecla a ×4", oblicuo, 2.3},
        {"tecla 2; tecla d ×33", diagonal, -1},
        {"tecla 3; tecla a ×45", oblicuo, 3.5 - 2 * PI},
        {"tecla 1; tecla d ×15; boton IZQUIERDO abajo 100 80; arrastra 130 80; arrastra 150 80; boton "
         "IZQUIERDO arriba 150 80",
         direccion(gira(pantalla.y, 0.5), Y), 2},
        {"tecla 1; tecla d; " + arrastra({100, 80}, {100, 110}) + "; " +
             arrastra({100, 80}, {60, 90}, "DERECHO"),
         direccion(gira(pantalla.x, 0.3), Y), 1.9, -0.1, 0.5},
    };
    paraCada("giro_eje", casos, 240, 180, [&](const auto &c, const Vista &vista) {
        std::vector<Cuerpo> aviones;
        ponAvion(aviones, traslada(SITIO), 0.3);
        // e, como manda el libro: anular la menor componente de d, cambiar las otras dos y negar una
        const Vec3 d = unitario(oblicuo), e = unitario(Vec3{-d.y, d.x, 0}), f = vectorial(d, e);
        const Mat4 aLosEjes = {{{d.x, d.y, d.z, 0}, {e.x, e.y, e.z, 0}, {f.x, f.y, f.z, 0}, {0, 0, 0, 1}}};
        ponAvion(aviones, (c.cambiado ? aLosEjes : Mat4()) * gira(c.eje, c.angulo) * traslada(SITIO), 1);
        compruebaEscena(vista, {camara(c.azimut, c.elevacion), vista.escena}, aviones, FONDO_CLARO);
    });
}
