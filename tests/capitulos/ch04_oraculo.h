// Lo que comparten las pruebas del capítulo 4: más precisión, lo que abarca una cámara y la de fotos de dos programas.
#pragma once
#include "colores.h"
#include "panel.h"

using Largo = long double; // con 11 bits más que double, sus redondeos no cuentan
using Mat4Largo = glm::mat<4, 4, Largo>;
const double U_DOBLE = 0x1p-53; // error de un redondeo

/// Si un punto está entre los cuatro lados de lo que se ve.
inline bool entreLosLados(const oraculo::Vec3 &p, const Panel &panel) {
    const oraculo::Vec3 v = proyecta(panel.camara, panel.hueco.ancho, panel.hueco.alto, p);
    return v.x >= 0 && v.x <= panel.hueco.ancho && v.y >= 0 && v.y <= panel.hueco.alto;
}
/// Y si está además entre cerca y lejos.
inline bool dentroDelVolumen(const oraculo::Vec3 &p, const Panel &panel) {
    const double d = -enCamara(panel.camara, p).z;
    return d >= panel.camara.cerca && d <= panel.camara.lejos && entreLosLados(p, panel);
}

/// El gris en que queda, por su luminancia, lo que está fuera.
inline oraculo::Vec3 deFuera(const oraculo::Vec3 &color) {
    const double gris = 0.70 + 0.20 * oraculo::escalar(color, {0.299, 0.587, 0.114});
    return {gris, gris, gris};
}

/// Esos cuerpos y la cámara de fotos, en los ejes que dé M. Su cilindro, con las caras que tiene.
inline std::vector<Cuerpo> conCamaraDeFotos(std::vector<Cuerpo> cuerpos, const oraculo::Mat4 &M) {
    using namespace oraculo;
    cuerpos.push_back({caja(M * traslada({0, 0, 0.5}) * escala({1, 0.65, 0.55})), exacto(GRIS)});
    cuerpos.push_back({caja(M * traslada({0, 0.42, 0.5}) * escala({0.4, 0.22, 0.4})), exacto(OSCURO)});
    cuerpos.push_back({caja(M * traslada({0.34, 0.36, 0.5}) * escala({0.18, 0.1, 0.18})), exacto(ROJO)});
    const Mat4 objetivo = M * traslada({0, 0, 0.1}) * escala({0.27, 0.27, 0.3});
    cuerpos.push_back({enElMundo(objetivo, cilindro(24)), exacto(OSCURO)});
    return cuerpos;
}
