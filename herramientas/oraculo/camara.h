// Cámara del oráculo: rayos por los píxeles y proyección de puntos. Rehace lo que prometen common/orbita.h y
// las dos proyecciones de common/ventana.h sin pasar por ninguna matriz 4×4.
#pragma once
#include "algebra.h"
#include <algorithm>

namespace oraculo {

/// origen + t·direccion, con t entre minimo y maximo. La dirección es unitaria: t es una distancia.
struct Rayo {
    Vec3 origen, direccion;
    double minimo = 0, maximo = INFINITO;
};

struct Camara {
    Vec3 ojo, centro{0, 0, -1}, arriba{0, 1, 0};
    bool esParalela = true;
    /// Mitad del alto de una ventana 4:3 o más ancha; en perspectiva, a distancia 1 del ojo.
    double semilado = 1;
    double cerca = -1, lejos = 1;
};
inline Camara miraDesde(const Vec3 &ojo, const Vec3 &centro, const Vec3 &arriba = {0, 1, 0}) {
    return {ojo, centro, arriba};
}
/// La de common/orbita.h: desde +Z, sube `elevacion` (alrededor de X) y luego gira `azimut` alrededor de Y.
inline Camara orbita(double azimut, double elevacion, double distancia, const Vec3 &centro = {}) {
    const Mat4 giro = gira({0, 1, 0}, azimut) * gira({1, 0, 0}, -elevacion);
    return miraDesde(centro + direccion(giro, {0, 0, distancia}), centro);
}
/// perspectivaVentana: `angulo` abarca el alto útil.
inline Camara perspectiva(const Camara &c, double angulo, double cerca, double lejos) {
    return {c.ojo, c.centro, c.arriba, false, std::tan(angulo / 2), cerca, lejos};
}
/// paralelaVentana: [−semilado, semilado] en el alto útil.
inline Camara paralela(const Camara &c, double semilado, double cerca = -1, double lejos = 1) {
    return {c.ojo, c.centro, c.arriba, true, semilado, cerca, lejos};
}

/// Los ejes de la cámara en el mundo; se mira hacia −z.
struct Ejes {
    Vec3 x, y, z;
};
inline Ejes ejes(const Camara &c) {
    const Vec3 z = unitario(c.ojo - c.centro), x = unitario(vectorial(c.arriba, z));
    if (longitud(x) == 0)
        throw std::invalid_argument("oráculo: la cámara no tiene vertical");
    return {x, vectorial(z, x), z};
}
/// Coordenadas de cámara de un punto del mundo.
inline Vec3 enCamara(const Camara &c, const Vec3 &p) {
    const Ejes e = ejes(c);
    const Vec3 v = p - c.ojo;
    return {escalar(v, e.x), escalar(v, e.y), escalar(v, e.z)};
}
/// El alto de la ventana o, si es más estrecha que 4:3, el que tendría a 4:3 con ese ancho.
inline double altoUtil(int ancho, int alto) {
    return std::min<double>(alto, 0.75 * ancho);
}
/// Lado de un píxel, en unidades del mundo, a la profundidad de p.
inline double tallaPixel(const Camara &c, int ancho, int alto, const Vec3 &p) {
    return 2 * c.semilado / altoUtil(ancho, alto) * (c.esParalela ? 1 : -enCamara(c, p).z);
}
/// Rayo por el punto (px, py) de la ventana, en píxeles: el centro del píxel (x, y) es (x + 0.5, y + 0.5).
inline Rayo rayo(const Camara &c, int ancho, int alto, double px, double py) {
    const Ejes e = ejes(c);
    const double porPixel = 2 * c.semilado / altoUtil(ancho, alto); // a distancia 1
    const Vec3 v = porPixel * (px - 0.5 * ancho) * e.x + porPixel * (py - 0.5 * alto) * e.y;
    if (c.esParalela)
        return {c.ojo + v, -e.z, c.cerca, c.lejos};
    const double oblicuo = longitud(v - e.z); // cerca y lejos se miden a lo largo de −z
    return {c.ojo, unitario(v - e.z), c.cerca * oblicuo, c.lejos * oblicuo};
}
/// Coordenadas de ventana (x e y en píxeles, z la profundidad de 0 a 1) de un punto que está delante del ojo.
inline Vec3 proyecta(const Camara &c, int ancho, int alto, const Vec3 &p) {
    const Vec3 q = enCamara(c, p);
    const double d = -q.z, k = 1 / tallaPixel(c, ancho, alto, p);
    const double z = c.esParalela ? (d - c.cerca) / (c.lejos - c.cerca)
                                  : (1 / c.cerca - 1 / d) / (1 / c.cerca - 1 / c.lejos);
    return {0.5 * ancho + k * q.x, 0.5 * alto + k * q.y, z};
}

} // namespace oraculo
