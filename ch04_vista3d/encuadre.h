// Ver la grúa entera (ejercicios 4.2 a 4.4): las cuatro vistas, el sitio que tienen en la ventana y el volumen
// de la vista que encierra la grúa en cualquier postura, en paralela o en perspectiva y con cualquier relación
// de aspecto. Sin OpenGL; lo usan los programas grua_* y lo comprueban las pruebas.
#pragma once
#include "ch03_transformaciones/grua.h"
#include "vista.h"
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <map>
#include <vector>

/// Una cámara que mira al centro de la grúa desde CENTRO_GRUA + haciaCamara.
struct Vista {
    glm::dvec3 haciaCamara, UP;
    glm::vec3 colorMarco; // el del eje a lo largo del cual se mira
};

const glm::dvec3 CENTRO_GRUA(0, (LARGO_PIE + GRUESO) / 2, 0);
const double DISTANCIA_CAMARA = 24; // en paralela da igual

/// Las tres vistas a lo largo de un eje (el perfil, el derecho) y la de dirección (1,1,1).
enum { ALZADO, PLANTA, PERFIL, DIAGONAL, N_VISTAS };
const Vista VISTAS[N_VISTAS] = {
    {{0, 0, DISTANCIA_CAMARA}, {0, 1, 0}, {0.16f, 0.38f, 0.80f}},
    {{0, DISTANCIA_CAMARA, 0}, {0, 0, -1}, {0.20f, 0.62f, 0.28f}},
    {{DISTANCIA_CAMARA, 0, 0}, {0, 1, 0}, {0.85f, 0.20f, 0.18f}},
    {glm::dvec3(DISTANCIA_CAMARA / std::sqrt(3.0)), {0, 1, 0}, {0.55f, 0.58f, 0.62f}},
};

/// La cámara de una vista. No sabe de proyecciones: al cambiar de paralela a perspectiva es la misma.
inline glm::dmat4 camaraVista(const Vista &v) {
    return transformacionCamara(CENTRO_GRUA + v.haciaCamara, CENTRO_GRUA, v.UP);
}

/// Rectángulo de la ventana, en píxeles y desde abajo a la izquierda, como los de glViewport.
struct Recuadro {
    int x, y, ancho, alto;
};
inline bool vacio(const Recuadro &r) {
    return r.ancho < 1 || r.alto < 1;
}

/// El cuarto de la ventana que toca a cada vista: la planta sobre el alzado, el perfil derecho a su derecha y
/// (1,1,1) en el que queda, como en el sistema americano y en los programas de modelado. Entre los cuatro la
/// cubren entera; en una ventana de un píxel de ancho o de alto algunos quedan vacíos.
inline Recuadro recuadroVista(int vista, int ancho, int alto) {
    const bool derecha = vista == PERFIL || vista == DIAGONAL, arriba = vista == PLANTA || vista == DIAGONAL;
    return {derecha ? ancho / 2 : 0, arriba ? alto / 2 : 0, derecha ? ancho - ancho / 2 : ancho / 2,
            arriba ? alto - alto / 2 : alto / 2};
}

/// Lo que queda al quitarle un marco de ese grosor.
inline Recuadro interior(const Recuadro &r, int marco) {
    return {r.x + marco, r.y + marco, r.ancho - 2 * marco, r.alto - 2 * marco};
}

/// Las ocho esquinas de cada pieza, en el mundo.
inline std::vector<glm::dvec3> esquinasGrua(const PosturaGrua &postura) {
    std::vector<glm::dvec3> esquinas;
    for (const Pieza &pieza : piezasGrua(postura))
        for (int i = 0; i < 8; ++i)
            esquinas.push_back(
                pieza.M * glm::vec4(i & 1 ? 0.5f : -0.5f, i & 2 ? 0.5f : -0.5f, i & 4 ? 0.5f : -0.5f, 1));
    return esquinas;
}

/// Puntos entre los que queda, convexamente, la grúa en TODAS sus posturas: encuadrándolos la cámara no se
/// mueve cuando se mueve la grúa. Cada esquina da vueltas alrededor del pie; basta, para cada altura, la que
/// pasa más lejos en los extremos del recorrido de la carga, y un polígono que rodee su circunferencia.
inline std::vector<glm::dvec3> envolventeGrua() {
    std::map<double, double> radioEnAltura;
    for (const float distancia : {DISTANCIA_MINIMA, DISTANCIA_MAXIMA})
        for (const float altura : {ALTURA_MINIMA, ALTURA_MAXIMA})
            for (const glm::dvec3 &p : esquinasGrua({0, distancia, altura})) {
                double &radio = radioEnAltura[p.y];
                radio = std::max(radio, std::hypot(p.x, p.z));
            }
    const int lados = 64;
    const double paso = 2 * 3.14159265358979323846 / lados;
    std::vector<glm::dvec3> puntos;
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

/// Proyección paralela centrada en los puntos y con esa escala, sin deformar. El volumen es tres veces más
/// profundo que los puntos, para que quepa el suelo.
inline glm::dmat4 paralelaQueEncierra(const std::vector<glm::dvec3> &puntos, const glm::dmat4 &camara,
                                      const Recuadro &r, double unidadesPorPixel) {
    const Caja caja = cajaEnCamara(puntos, camara);
    const glm::dvec3 centro = 0.5 * (caja.minimo + caja.maximo);
    const double x = 0.5 * unidadesPorPixel * r.ancho, y = 0.5 * unidadesPorPixel * r.alto,
                 fondo = caja.maximo.z - caja.minimo.z;
    return proyeccionParalela(centro.x - x, centro.x + x, centro.y - y, centro.y + y, -caja.maximo.z - fondo,
                              -caja.minimo.z + fondo);
}

/// Proyección perspectiva que encierra los puntos, que han de estar todos delante de la cámara. La pirámide de
/// la ecuación 4.3 no se puede descentrar: se abre hasta el punto que más se aparta del eje.
inline glm::dmat4 perspectivaQueEncierra(const std::vector<glm::dvec3> &puntos, const glm::dmat4 &camara,
                                         const Recuadro &r) {
    const double aspecto = static_cast<double>(r.ancho) / r.alto;
    double tangente = 0, cerca = INFINITY, lejos = 0;
    for (const glm::dvec3 &p : puntos) {
        const glm::dvec3 q(camara * glm::dvec4(p, 1));
        tangente = std::max({tangente, std::fabs(q.y / q.z), std::fabs(q.x / q.z) / aspecto});
        cerca = std::min(cerca, -q.z), lejos = std::max(lejos, -q.z);
    }
    return proyeccionPerspectiva(2 * std::atan(HOLGURA * tangente), aspecto, cerca / 2, 2 * lejos);
}
