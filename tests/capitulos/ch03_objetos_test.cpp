// objetos contra el oráculo: la lista de piezas es la de objetos.h, pero los sólidos, la cámara y el sombreado son
// los del oráculo, en doble.
#include "ch03_oraculo.h"
#include "ch03_transformaciones/objetos.h"
#include "ejecuta.h"
#include "malla.h"
#include <gtest/gtest.h>
#include <sstream>

namespace {

using oraculo::Mat4;
using oraculo::Vec3;

const Vec3 FONDO{0.87, 0.93, 0.98};
const int SEGMENTOS = 36, SEGMENTOS_TUBO = 22;

oraculo::Camara camaraObjetos(double azimut = 0.25, double elevacion = 0.32, double distancia = 12.5) {
    return perspectiva(oraculo::orbita(azimut, elevacion, distancia, {0, 1.65, 0}), 0.5, 1, 60);
}

Mat4 porFilas(const glm::mat4 &M) {
    Mat4 r;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            r.f[i][j] = M[j][i];
    return r;
}

/// Con n > 0, mallas de n segmentos (el toro, m en el tubo); si no, los sólidos exactos.
std::vector<ch03::Cuerpo> escena(int n = 0, int m = 0) {
    std::vector<ch03::Cuerpo> cuerpos;
    for (const PiezaObjeto &p : piezasObjetos()) {
        const Mat4 M = porFilas(p.M);
        const Vec3 color{p.color.r, p.color.g, p.color.b};
        switch (p.primitiva) {
        case Primitiva::CUBO: cuerpos.push_back({oraculo::caja(M), color}); break;
        case Primitiva::ESFERA:
            cuerpos.push_back({n ? oraculo::malla(M, esfera(n)) : oraculo::esfera(M), color});
            break;
        case Primitiva::TORO:
            cuerpos.push_back(
                {n ? oraculo::malla(M, toro(1, 0.35f, n, m)) : oraculo::toro(M, 1, 0.35), color});
            break;
        }
    }
    return cuerpos;
}

void apunta(const char *clave, const oraculo::Comparacion &c) {
    testing::Test::RecordProperty(clave, (std::ostringstream() << c).str());
}

} // namespace

TEST(ProgramaObjetos, SiluetaContraLosSolidosExactos) {
    oraculo::Escena solidos;
    for (const ch03::Cuerpo &c : escena())
        solidos.push_back(c.objeto);
    const Ejecucion e = ejecuta("ch03_transformaciones/objetos");
    ASSERT_EQ(e.estado, 0) << e.errores;
    const oraculo::Comparacion c = comparaSilueta(e.imagen, FONDO, solidos, camaraObjetos());
    EXPECT_EQ(c.maximo, 0) << c;
    EXPECT_LE(c.desvio, 0.25) << c; // un píxel en 960x720: LosSegmentosBastan
    apunta("silueta", c);
}

// Una normal interpolada se acorta hasta cos(π/36) en la vuelta y cos(π/22) en el tubo, en total 0.014; y la faceta,
// que está ρ(1 − cos(π/22)) más adentro, se ve desplazada tan θ veces eso, o sea gira la normal 0.0102·tan θ. Lejos de
// los bordes, a 1.5 píxeles de la silueta de un tubo de ρ = 11 píxeles, tan θ = 1.7. Con el amarillo, el más claro:
// 0.5 + 255·0.42·0.98·(0.014 + 0.0174) = 3.8 niveles.
TEST(ProgramaObjetos, SombreadoContraLosSolidosExactos) {
    const Ejecucion e = ejecuta("ch03_transformaciones/objetos");
    ASSERT_EQ(e.estado, 0) << e.errores;
    const oraculo::Comparacion c = ch03::compara(e.imagen, escena(), camaraObjetos(), FONDO, 3.8);
    EXPECT_LE(c.maximo, 3.8) << c;
    EXPECT_LE(c.desvio, 1) << c;
    apunta("solidos", c);
}

TEST(ProgramaObjetos, SombreadoDeLaMismaMalla) {
    const Ejecucion e = ejecuta("ch03_transformaciones/objetos");
    ASSERT_EQ(e.estado, 0) << e.errores;
    const oraculo::Comparacion c =
        ch03::compara(e.imagen, escena(SEGMENTOS, SEGMENTOS_TUBO), camaraObjetos(), FONDO);
    EXPECT_LE(c.maximo, 1) << c;
    EXPECT_LE(c.desvio, ch03::DESVIO) << c;
    apunta("malla", c);
}

// 50 píxeles a la derecha son medio radián menos de azimut, 20 hacia arriba 0.2 menos de elevación.
TEST(ProgramaObjetos, ElRatonOrbita) {
    const Ejecucion e =
        ejecuta("ch03_transformaciones/objetos",
                "boton IZQUIERDO abajo 100 100; arrastra 150 80; boton IZQUIERDO arriba 150 80; "
                "rueda +1 120 90");
    ASSERT_EQ(e.estado, 0) << e.errores;
    const oraculo::Comparacion c = ch03::compara(e.imagen, escena(SEGMENTOS, SEGMENTOS_TUBO),
                                                 camaraObjetos(-0.25, 0.12, 12.5 / 1.1), FONDO);
    EXPECT_LE(c.maximo, 1) << c;
    EXPECT_LE(c.desvio, ch03::DESVIO) << c;
    apunta("orbitada", c);
}

// En 960x720 las facetas se separan del sólido menos de medio píxel en cada sentido de la malla: un píxel en total.
TEST(ProgramaObjetos, LosSegmentosBastan) {
    const double esferaMayor = 1.05, toroMayor = 0.82 * 1.35; // unidades
    const oraculo::Camara camara = camaraObjetos();
    const double pixelesPorUnidad = 1 / tallaPixel(camara, 960, 720, camara.centro);
    EXPECT_LE(pixelesPorUnidad * std::max(esferaMayor, toroMayor), 130);
    EXPECT_LE(130 * (1 - std::cos(oraculo::PI / SEGMENTOS)), 0.5);
    EXPECT_LE(130 * 0.35 * (1 - std::cos(oraculo::PI / SEGMENTOS_TUBO)), 0.5);
}
