// objetos contra el oráculo: los juguetes, escritos aquí otra vez como sólidos exactos, y la cámara y el sombreado, en
// doble. De objetos.h no se lee nada.
#include "guiones.h"
#include "panel.h"
#include "tabla.h"

namespace {

using namespace oraculo;

const Vec3 FONDO{0.87, 0.93, 0.98};
const int SEGMENTOS = 36, SEGMENTOS_TUBO = 22;

Camara camaraObjetos(double azimut = 0.25, double elevacion = 0.32, double distancia = 14.2) {
    return perspectiva(orbita(azimut, elevacion, distancia, {-0.05, 1.5, 0}), 0.5, 1, 60);
}

/// Con n > 0, mallas de n segmentos (el toro, m en el tubo); si no, esferas exactas y toros muy finos.
struct Taller {
    int n, m;
    std::vector<Cuerpo> cuerpos;

    void bloque(const Mat4 &sitio, const Vec3 &lados, const Vec3 &color) {
        cuerpos.push_back({caja(sitio * escala(lados)), color});
    }
    void bola(const Mat4 &sitio, const Vec3 &radios, const Vec3 &color) {
        const Mat4 M = sitio * escala(radios);
        cuerpos.push_back({n ? malla(M, esfera(n)) : esfera(M), color});
    }
    /// Alrededor de Z: `radio` hasta el centro del tubo, que mide 0.35·radio, y 0.35·alto a lo largo del eje.
    void anillo(const Mat4 &sitio, double radio, double alto, const Vec3 &color) {
        const Mat4 M = sitio * escala({radio, radio, alto});
        cuerpos.push_back({malla(M, n ? toro(1, 0.35f, n, m) : toro(1, 0.35f, 180, 110)), color});
    }
};

const Vec3 ROJIZO{0.85, 0.20, 0.18}, VERDOSO{0.20, 0.62, 0.28}, AZULADO{0.16, 0.38, 0.80},
    ANARANJADO{0.95, 0.55, 0.10}, AMARILLENTO{0.98, 0.78, 0.15}, NEGRUZCO{0.16, 0.17, 0.20},
    NIEVE{0.97, 0.98, 1}, MADERA{0.45, 0.30, 0.18}, CRISTAL{0.78, 0.90, 0.97}, METAL{0.72, 0.74, 0.78};

const Mat4 TUMBADO = gira({1, 0, 0}, PI / 2); // el eje Z, vertical

void ponMuneco(Taller &t, const Mat4 &A) {
    const auto en = [&](double x, double y, double z) { return A * traslada({x, y, z}); };
    t.bola(en(0, 0.92, 0), {1.05, 0.95, 1.05}, NIEVE);
    t.bola(en(0, 2.18, 0), {0.74, 0.74, 0.74}, NIEVE);
    t.bola(en(0, 3.14, 0), {0.52, 0.52, 0.52}, NIEVE);
    t.anillo(en(0, 2.74, 0) * TUMBADO, 0.4, 0.5, ROJIZO); // bufanda
    t.bloque(en(0.32, 2.4, 0.62) * gira({1, 0, 0}, -0.35), {0.24, 0.75, 0.1}, ROJIZO);
    t.bloque(en(0, 3.55, 0), {1.15, 0.1, 1.15}, NEGRUZCO); // sombrero
    t.bloque(en(0, 3.88, 0), {0.7, 0.65, 0.7}, NEGRUZCO);
    t.bloque(en(0, 3.68, 0), {0.74, 0.16, 0.74}, ROJIZO);
    t.bola(en(0, 3.12, 0.68), {0.1, 0.1, 0.34}, ANARANJADO); // nariz
    t.bola(en(-0.19, 3.27, 0.45), {0.075, 0.075, 0.075}, NEGRUZCO);
    t.bola(en(0.19, 3.27, 0.45), {0.075, 0.075, 0.075}, NEGRUZCO);
    t.bola(en(0, 1.25, 0.99), {0.09, 0.09, 0.09}, NEGRUZCO);
    t.bola(en(0, 2.05, 0.73), {0.09, 0.09, 0.09}, NEGRUZCO);
    t.bloque(en(-1.05, 2.5, 0) * gira({0, 0, 1}, -0.5), {1, 0.1, 0.1}, MADERA); // brazos, hacia arriba
    t.bloque(en(1.05, 2.5, 0) * gira({0, 0, 1}, 0.5), {1, 0.1, 0.1}, MADERA);
}

void ponCoche(Taller &t, const Mat4 &A) {
    const auto en = [&](double x, double y, double z) { return A * traslada({x, y, z}); };
    t.bloque(en(0, 0.72, 0), {2.5, 0.5, 1.2}, AZULADO);
    t.bloque(en(-0.25, 1.2, 0), {1.35, 0.5, 1.1}, CRISTAL);
    t.bloque(en(-0.25, 1.5, 0), {1.45, 0.12, 1.2}, AZULADO);
    t.bloque(en(-0.25, 1.2, 0), {0.1, 0.52, 1.14}, AZULADO);
    for (const double z : {-1.0, 1.0}) {
        t.bola(en(1.25, 0.82, 0.42 * z), {0.08, 0.14, 0.14}, AMARILLENTO);
        t.bola(en(-1.25, 0.82, 0.42 * z), {0.06, 0.11, 0.11}, ROJIZO);
        t.bloque(en(1.25 * z, 0.55, 0), {0.14, 0.16, 1.3}, METAL); // parachoques
        for (const double x : {-0.75, 0.8}) {
            t.anillo(en(x, 0.46, 0.66 * z), 0.34, 0.45, NEGRUZCO);
            t.bola(en(x, 0.46, 0.66 * z), {0.24, 0.24, 0.12}, METAL);
        }
    }
}

/// Los aros, hundidos una décima uno en otro.
void ponAros(Taller &t, const Mat4 &A) {
    const Vec3 colores[] = {AZULADO, VERDOSO, AMARILLENTO, ANARANJADO, ROJIZO};
    t.bloque(A * traslada({0, 0.12, 0}), {2.3, 0.24, 2.3}, {0.80, 0.62, 0.42});
    double base = 0.24;
    for (int i = 0; i < 5; ++i) {
        const double radio = 0.82 - 0.1 * i, alto = 2 * 0.9 * 0.35 * radio;
        t.anillo(A * traslada({0, base + alto / 2, 0}) * TUMBADO, radio, radio, colores[i]);
        base += alto;
    }
    t.bola(A * traslada({0, base + 0.2, 0}), {0.36, 0.36, 0.36}, AZULADO);
}

std::vector<Cuerpo> escena(int n = 0, int m = 0) {
    Taller t{n, m, {}};
    t.bloque(traslada({0, -0.15, 0}), {7.6, 0.3, 4.8}, {0.86, 0.72, 0.55}); // el tablero, en y = 0
    ponMuneco(t, traslada({-2.1, 0, -0.7}) * gira(Y, 0.25));
    ponCoche(t, traslada({0.2, 0, 1.2}) * gira(Y, -0.35));
    ponAros(t, traslada({2.4, 0, -0.7}) * gira(Y, 0.3));
    return t.cuerpos;
}

} // namespace

TEST(ProgramaObjetos, SiluetaContraLosSolidosExactos) {
    // En 960×720 una unidad son 116 píxeles: las facetas se separan del sólido medio en cada sentido de la malla, uno
    // en total: en la esfera mayor, de radio 1.05, 122·(1 − cos(π/36)) = 0.46, y en el tubo del toro mayor,
    // 116·0.82·0.35·(1 − cos(π/22)) = 0.34
    comprueba("silueta", comparaSilueta(vistaDe("objetos").escena, FONDO, objetos(escena()), camaraObjetos()),
              {0, 0, 0.25});
}

// También tras girar y acercar la cámara: 50 píxeles a la derecha son medio radián menos de azimut y 20 hacia arriba
// 0.2 menos de elevación. Los otros botones no giran nada.
TEST(ProgramaObjetos, SombreadoDeLaMismaMalla) {
    const struct {
        std::string guion;
        Camara camara;
    } casos[] = {{"", camaraObjetos()},
                 {arrastra({100, 100}, {150, 80}) + "; rueda +1 120 90; tamano 150 200; " +
                      arrastra({9, 9}, {99, 99}, "DERECHO"),
                  camaraObjetos(-0.25, 0.12, 14.2 / 1.1)}};
    paraCada("objetos", casos, 240, 180, [](const auto &c, const Vista &v) {
        comprueba("malla", comparaConLuzFija(v.escena, escena(SEGMENTOS, SEGMENTOS_TUBO), c.camara, FONDO),
                  EXACTA);
    });
}
