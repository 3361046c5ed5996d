// Las cámaras de las cuatro vistas de la grúa (ejercicios 4.2 a 4.4) y el volumen de la vista que la encierra en
// cualquier postura. Sin OpenGL; lo usa vistas_grua.h.
#pragma once
#include "ch03_transformaciones/grua.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "recuadro.h"
#include "vista.h"
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <map>
#include <vector>

/// Una cámara que mira al centro de la grúa desde CENTRO_GRUA + haciaCamara.
struct VistaGrua {
    const char *nombre;
    glm::dvec3 haciaCamara, UP;
    glm::vec3 color; // el del eje a lo largo del cual se mira
};

const glm::dvec3 CENTRO_GRUA(0, 4.7, 0);
const double DISTANCIA_CAMARA =
    42; // en paralela da igual; en perspectiva, de lejos, el cable apenas se ve torcido

/// Las tres vistas a lo largo de un eje (el perfil, el derecho) y la de dirección (1,1,1).
enum { ALZADO, PLANTA, PERFIL, DIAGONAL, N_VISTAS, LAS_CUATRO = -1 };
const VistaGrua VISTAS[N_VISTAS] = {
    {"Alzado", {0, 0, DISTANCIA_CAMARA}, {0, 1, 0}, COLOR_EJE[2]},
    // E4.2: hacia dónde está la cámara en cada una, y qué queda arriba
    {"Planta", {0, DISTANCIA_CAMARA, 0}, {0, 0, -1}, COLOR_EJE[1]},
    {"Perfil", {DISTANCIA_CAMARA, 0, 0}, {0, 1, 0}, COLOR_EJE[0]},
    {"(1,1,1)", glm::dvec3(DISTANCIA_CAMARA / glm::root_three<double>()), {0, 1, 0}, OSCURO},
    // de partida: {"Planta", {0, 0, DISTANCIA_CAMARA}, {0, 1, 0}, COLOR_EJE[1]},
    // de partida: {"Perfil", {0, 0, DISTANCIA_CAMARA}, {0, 1, 0}, COLOR_EJE[0]},
    // de partida: {"(1,1,1)", {0, 0, DISTANCIA_CAMARA}, {0, 1, 0}, OSCURO},
    // fin de E4.2
};

/// La cámara de una vista. No sabe de proyecciones: al cambiar de paralela a perspectiva es la misma.
inline glm::dmat4 camaraVista(const VistaGrua &v) {
    return transformacionCamara(CENTRO_GRUA + v.haciaCamara, CENTRO_GRUA, v.UP);
}

/// La grúa sobre una losa que no sobresale de lo que barre el brazo.
const float LADO_SUELO = 10.5f, GRUESO_SUELO = 0.3f;
inline std::vector<Pieza> escenaGrua(const PosturaGrua &postura) {
    std::vector<Pieza> piezas = piezasGrua(postura);
    piezas.insert(
        piezas.begin(),
        {traslacion({0, -GRUESO_SUELO / 2, 0}) * escalado({LADO_SUELO, GRUESO_SUELO, LADO_SUELO}), SUELO});
    return piezas;
}

/// Las ocho esquinas de una pieza, en el mundo.
inline std::vector<glm::dvec3> esquinas(const Pieza &pieza) {
    std::vector<glm::dvec3> puntos;
    for (int i = 0; i < 8; ++i)
        puntos.push_back(pieza.M *
                         glm::vec4(i & 1 ? 0.5f : -0.5f, i & 2 ? 0.5f : -0.5f, i & 4 ? 0.5f : -0.5f, 1));
    return puntos;
}

/// Puntos entre los que queda, convexamente, el suelo con la grúa en TODAS sus posturas: encuadrándolos la cámara no se
/// mueve cuando se mueve la grúa. Cada esquina da vueltas alrededor del pie; basta, para cada altura, la que
/// pasa más lejos en los extremos del recorrido de la carga, y un polígono que rodee su circunferencia.
inline std::vector<glm::dvec3> envolventeGrua() {
    std::map<double, double> radioEnAltura;
    for (const float distancia : {DISTANCIA_MINIMA, DISTANCIA_MAXIMA})
        for (const float altura : {ALTURA_MINIMA, ALTURA_MAXIMA})
            for (const Pieza &pieza : piezasGrua({0, distancia, altura}))
                for (const glm::dvec3 &p : esquinas(pieza)) {
                    double &radio = radioEnAltura[p.y];
                    radio = std::max(radio, std::hypot(p.x, p.z));
                }
    const int lados = 64;
    const double paso = glm::two_pi<double>() / lados;
    std::vector<glm::dvec3> puntos = esquinas(escenaGrua({})[0]);
    for (const auto &[y, radio] : radioEnAltura)
        for (int i = 0; i < lados; ++i) {
            const double r = radio / std::cos(paso / 2); // circunscrito
            puntos.push_back({r * std::cos(i * paso), y, r * std::sin(i * paso)});
        }
    return puntos;
}

const double HOLGURA = 1.06; // lo que se deja alrededor

/// Caja que encierra los puntos en coordenadas de la cámara.
struct Caja {
    glm::dvec3 minimo, maximo;
};
inline Caja cajaEnCamara(const std::vector<glm::dvec3> &puntos, const glm::dmat4 &camara) {
    Caja caja{glm::dvec3(INFINITY), glm::dvec3(-INFINITY)};
    for (const glm::dvec3 &p : puntos) {
        const glm::dvec3 q(camara * glm::dvec4(p, 1));
        caja = {glm::min(caja.minimo, q), glm::max(caja.maximo, q)};
    }
    return caja;
}

/// Cuántas unidades del mundo debe abarcar un píxel del recuadro, como poco, para que los puntos quepan en
/// paralelo. Varias vistas dibujadas con la mayor de las suyas tienen todas la misma escala.
inline double unidadesPorPixel(const std::vector<glm::dvec3> &puntos, const glm::dmat4 &camara,
                               const Recuadro &r) {
    const Caja caja = cajaEnCamara(puntos, camara);
    const glm::dvec3 lados = caja.maximo - caja.minimo;
    return HOLGURA * std::max(lados.x / r.ancho, lados.y / r.alto);
}

/// Proyección paralela centrada en los puntos y con esa escala, sin deformar.
inline glm::dmat4 paralelaQueEncierra(const std::vector<glm::dvec3> &puntos, const glm::dmat4 &camara,
                                      const Recuadro &r, double unidadesPorPixel) {
    const Caja caja = cajaEnCamara(puntos, camara);
    // E4.2: un volumen de la vista centrado en la caja, con esa escala a lo ancho y a lo alto y HOLGURA a lo hondo
    const glm::dvec3 centro = 0.5 * (caja.minimo + caja.maximo);
    const double x = 0.5 * unidadesPorPixel * r.ancho, y = 0.5 * unidadesPorPixel * r.alto,
                 z = 0.5 * HOLGURA * (caja.maximo.z - caja.minimo.z);
    return proyeccionParalela(centro.x - x, centro.x + x, centro.y - y, centro.y + y, -centro.z - z,
                              -centro.z + z);
    // de partida: const double x = unidadesPorPixel * r.ancho, y = unidadesPorPixel * r.alto;
    // de partida: return proyeccionParalela(-x, x, -y, y, -caja.maximo.z, -caja.minimo.z);
    // fin de E4.2
}

/// Proyección perspectiva que encierra los puntos, que han de estar todos delante de la cámara. La pirámide de
/// la ecuación 4.3 no se puede descentrar: se abre hasta el punto que más se aparta del eje. Cerca y lejos se
/// ajustan a los puntos: un volumen más hondo gasta la profundidad en lo vacío, y de lejos se confunden las caras.
inline glm::dmat4 perspectivaQueEncierra(const std::vector<glm::dvec3> &puntos, const glm::dmat4 &camara,
                                         const Recuadro &r) {
    const double aspecto = double(r.ancho) / r.alto;
    double tangente = 0, cerca = INFINITY, lejos = 0;
    for (const glm::dvec3 &p : puntos) {
        const glm::dvec3 q(camara * glm::dvec4(p, 1));
        // E4.3: la tangente del mayor ángulo con que, desde la cámara, un punto se aparta del eje
        tangente = std::max({tangente, std::fabs(q.y / q.z), std::fabs(q.x / q.z) / aspecto});
        // de partida: tangente = 0.2;
        // fin de E4.3
        cerca = std::min(cerca, -q.z);
        lejos = std::max(lejos, -q.z);
    }
    const double margen = 0.5 * (HOLGURA - 1) * (lejos - cerca);
    return proyeccionPerspectiva(2 * std::atan(HOLGURA * tangente), aspecto, cerca - margen, lejos + margen);
}
