// giro_eje (§3.4) contra el oráculo. giroEje contra la fórmula de Rodrigues está en dificil_transformaciones_test.cpp.
#include "colores.h"
#include "guiones.h"
#include "panel.h"
#include <gtest/gtest.h>

namespace {

using oraculo::Mat4;
using oraculo::PI;
using oraculo::Vec3;

const Vec3 FONDO{0.95, 0.96, 0.98}, SITIO{-1.1, 0.2, 1.2}; // el del avión sin girar

void ponAvion(std::vector<Cuerpo> &cuerpos, const Mat4 &M, double viveza) {
    const Vec3 naranja{0.95, 0.55, 0.10}, amarillo{0.98, 0.78, 0.15}, rojo{0.85, 0.20, 0.18};
    const Vec3 piezas[][3] = {{{0, 0, 0}, {1.1, 0.22, 0.22}, naranja},
                              {{0.1, 0, 0}, {0.32, 0.08, 1.3}, amarillo},
                              {{-0.45, 0, 0}, {0.18, 0.06, 0.5}, amarillo},
                              {{-0.42, 0.22, 0}, {0.2, 0.34, 0.07}, rojo}};
    for (const auto &[centro, lados, color] : piezas)
        cuerpos.push_back({oraculo::caja(M * oraculo::traslada(centro) * oraculo::escala(lados)),
                           FONDO + viveza * (color - FONDO)});
}

/// Por dónde pasa el avión mientras el ángulo va de uno a otro.
Linea recorrido(const Vec3 &d, double desde, double hasta) {
    Linea puntos;
    for (int i = 0; i <= 64; ++i)
        puntos.push_back(punto(oraculo::gira(d, desde + (hasta - desde) * i / 64), SITIO));
    return puntos;
}

/// El vector e de la regla del libro: anula la componente menor de d, intercambia las otras dos y niega una.
Vec3 vectorE(const Vec3 &d) {
    const double x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
    return unitario(x <= y && x <= z ? Vec3{0, -d.z, d.y} : y <= z ? Vec3{d.z, 0, -d.x} : Vec3{-d.y, d.x, 0});
}

} // namespace

// Los dos aviones, píxel a píxel; el eje y la base, con sus letras; lo que recorre el avión, y la leyenda: 2 radianes
// son 114.6° y 1/√3 = 0.577. El botón izquierdo mueve el eje alrededor de los de la pantalla (50 píxeles a la derecha
// son medio radián alrededor de la vertical de la cámara y 30 hacia abajo 0.3 alrededor de su horizontal), y el
// derecho, después, gira la cámara.
TEST(ProgramaGiroEje, CadaEjeContraElOraculo) {
    const auto camara = [](double azimut, double elevacion) {
        return perspectiva(oraculo::orbita(azimut, elevacion, 7.4), 0.6, 1, 30);
    };
    const oraculo::Ejes pantalla = ejes(camara(-0.5, 0.4));
    const Vec3 Y{0, 1, 0}, oblicuo{-0.6, 0.7, 0.4};
    const struct {
        std::string guion;
        Vec3 eje;
        double angulo;
        std::string leyenda;
        double azimut = -0.5, elevacion = 0.4;
    } casos[] = {
        {"", Y, 2, "φ = 115°, d = (0, 1, 0)"},
        {"tecla 2; tamano 150 200", {1, 1, 1}, 2, "φ = 115°, d = (0.58, 0.58, 0.58)"},
        {"tecla 3", oblicuo, 2, "φ = 115°, d = (-0.6, 0.7, 0.4)"},
        {"tecla 4; tecla d", {1, 1e-10, 0}, 1.9, "φ = 109°, d = (1, 0, 0)"},
        {"tecla 3; tecla a ×3", oblicuo, 2.3, "φ = 132°, d = (-0.6, 0.7, 0.4)"},
        {"tecla 2; tecla d ×30", {1, 1, 1}, -1, "φ = -57°, d = (0.58, 0.58, 0.58)"},
        {"tecla 3; tecla a ×15", oblicuo, 3.5 - 2 * PI, "φ = -159°, d = (-0.6, 0.7, 0.4)"},
        {"boton IZQUIERDO abajo 100 80; arrastra 130 80; arrastra 150 80; boton IZQUIERDO arriba 150 80",
         direccion(oraculo::gira(pantalla.y, 0.5), Y), 2, "φ = 115°, d = (0.18, 0.98, 0.05)"},
        {"tecla d; " + arrastra({100, 80}, {100, 110}) + "; " + arrastra({100, 80}, {60, 90}, "DERECHO"),
         direccion(oraculo::gira(pantalla.x, 0.3), Y), 1.9, "φ = 109°, d = (-0.14, 0.96, 0.26)", -0.1, 0.5},
    };
    for (const auto &caso : casos) {
        SCOPED_TRACE("«" + caso.guion + "»");
        const Vista vista = vistaDe("giro_eje", caso.guion);
        const Panel panel(camara(caso.azimut, caso.elevacion), vista.escena);
        std::vector<Cuerpo> aviones;
        ponAvion(aviones, oraculo::traslada(SITIO), 0.3);
        ponAvion(aviones, oraculo::gira(caso.eje, caso.angulo) * oraculo::traslada(SITIO), 1);
        compruebaEscena(vista, panel, aviones, FONDO_CLARO);

        const Vec3 d = unitario(caso.eje), e = vectorE(d);
        Dibujo encima = {panel};
        encima.traza("polilinea", recorrido(d, caso.angulo, std::copysign(2 * PI, caso.angulo)), GRIS, 6);
        encima.traza("polilinea", recorrido(d, 0, caso.angulo), MORADO, 9);
        encima.traza("polilinea", {-1.6 * d, {}}, OSCURO, 9);
        const auto vector = [&](const char *nombre, const Vec3 &v, double largo, const glm::vec3 &color) {
            encima.traza("flecha", {{}, largo * v}, color, 12);
            encima.rotula(nombre, panel((largo + 0.15) * v), color);
        };
        vector("e", e, 0.9, VERDE);
        vector("f", vectorial(d, e), 0.9, AZUL);
        vector("d", d, 1.6, ROJO);
        const Vec3 medio = punto(oraculo::gira(d, caso.angulo / 2), SITIO),
                   haciaFuera = unitario(medio - escalar(medio, d) * d);
        encima.rotula("φ", panel(medio + 0.2 * haciaFuera), MORADO);
        encima.rotula(caso.leyenda, panel.lugar(0.5, 0.05), OSCURO);
        encima.comprueba(vista);
    }
}
