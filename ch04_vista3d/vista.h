// Las matrices del capítulo 4, escritas como las da el libro (ecuaciones 4.1 a 4.4) salvo donde se equivoca
// (docs/erratas.md). Sin OpenGL: las usan los programas y las comprueban las pruebas. Todo se calcula en doble
// y se pasa a float una sola vez, al dar cada matriz a la GPU:
//   envia(programa, "camara", glm::mat4(transformacionCamara(p, i, UP)));
// Ángulos en radianes; glm::dmat4 guarda columnas, así que aquí cada línea es una columna.
#pragma once
#include "ch03_transformaciones/transformaciones.h"
#include "error.h"
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

/// Los ejes de la cámara en coordenadas del mundo, unitarios y perpendiculares: S a la derecha, U arriba y F
/// hacia donde mira.
struct BaseCamara {
    glm::dvec3 S, U, F;
};

/// Ejes de la cámara que desde p mira a i con la inclinación UP, de cualquier longitud. Siempre da una base:
/// si p = i, mira hacia −Z; si UP es nulo o paralelo a F, hace de UP el eje Y o, mirando a lo largo de Y, el
/// eje X: así una planta a la que se da UP = Y sale girada, y se nota.
inline BaseCamara baseCamara(const glm::dvec3 &p, const glm::dvec3 &i, const glm::dvec3 &UP) {
    const glm::dvec3 F = unitario(i - p, {0, 0, -1});
    const double paralelo = 1e-10; // seno del ángulo; por debajo, F × UP es casi todo redondeo
    glm::dvec3 S = glm::cross(F, unitario(UP, F));
    if (glm::length(S) < paralelo) {
        const glm::dvec3 ejeX(1, 0, 0), ejeY(0, 1, 0);
        S = glm::cross(F, std::fabs(F.y) < 0.9 ? ejeY : ejeX);
    }
    // El libro no normaliza S, que solo es unitario si UP y F son perpendiculares. Y con UP casi paralelo el
    // redondeo de S tiene componente en F: U la pierde en el producto, y S se rehace con U.
    const glm::dvec3 U = glm::normalize(glm::cross(glm::normalize(S), F));
    return {glm::cross(F, U), U, F};
}

/// Transformación de la cámara, ecuación 4.1: la que desde p mira a i con la inclinación UP pasa al origen,
/// mirando hacia −Z. Con el mundo lejos del origen (p a 1e6) los vértices en float ya no se distinguen:
/// se multiplica por la del modelo antes de pasar a float, transformacionCamara(…) * glm::dmat4(M), y así
/// la resta de p se hace en doble.
inline glm::dmat4 transformacionCamara(const glm::dvec3 &p, const glm::dvec3 &i, const glm::dvec3 &UP) {
    const auto [S, U, F] = baseCamara(p, i, UP);
    return {{S.x, U.x, -F.x, 0},
            {S.y, U.y, -F.y, 0},
            {S.z, U.z, -F.z, 0},
            {-glm::dot(S, p), -glm::dot(U, p), glm::dot(F, p), 1}};
}

/// Proyección paralela, ecuación 4.2. `cerca` y `lejos` son distancias a lo largo de la vista, hacia −Z, como
/// en la 4.3; el libro imprime 2/(lejos − cerca), que las toma hacia +Z y deja la profundidad del revés.
inline glm::dmat4 proyeccionParalela(double izquierda, double derecha, double abajo, double arriba,
                                     double cerca, double lejos) {
    const double ancho = derecha - izquierda, alto = arriba - abajo, fondo = lejos - cerca;
    if (!std::isnormal(ancho) || !std::isnormal(alto) || !std::isnormal(fondo))
        falla("proyeccionParalela: el volumen de la vista no tiene ancho, alto o fondo");
    return {{2 / ancho, 0, 0, 0},
            {0, 2 / alto, 0, 0},
            {0, 0, -2 / fondo, 0},
            {-(derecha + izquierda) / ancho, -(arriba + abajo) / alto, -(lejos + cerca) / fondo, 1}};
}

/// Proyección perspectiva, ecuación 4.3. `theta`: el ángulo entero que se abarca en Y, de 0 a π; `aspecto`:
/// ancho/alto; 0 < cerca < lejos. El libro imprime aspect/tan(θ) y 1/tan(θ): el aspecto divide, y la tangente
/// es la de medio ángulo.
inline glm::dmat4 proyeccionPerspectiva(double theta, double aspecto, double cerca, double lejos) {
    const double t = std::tan(theta / 2), fondo = cerca - lejos;
    if (!(theta > 0 && t > 0 && aspecto > 0 && cerca > 0 && fondo < 0 && std::isfinite(fondo)))
        falla("proyeccionPerspectiva: hace falta 0 < theta < π, aspecto > 0 y 0 < cerca < lejos");
    return {{1 / (aspecto * t), 0, 0, 0},
            {0, 1 / t, 0, 0},
            {0, 0, (lejos + cerca) / fondo, -1},
            {0, 0, 2 * lejos * cerca / fondo, 0}};
}

/// Transformación al área de dibujo, ecuación 4.4: lleva el volumen canónico a coordenadas de ventana y la
/// profundidad a [zCerca, zLejos], como glViewport y glDepthRange. El libro resta medio píxel (pone los
/// centros en los enteros) y deja z en [−1, 1]; en OpenGL el centro del píxel (0, 0) es (0.5, 0.5).
inline glm::dmat4 transformacionViewport(double ox, double oy, double nx, double ny, double zCerca = 0,
                                         double zLejos = 1) {
    return {{nx / 2, 0, 0, 0},
            {0, ny / 2, 0, 0},
            {0, 0, (zLejos - zCerca) / 2, 0},
            {ox + nx / 2, oy + ny / 2, (zLejos + zCerca) / 2, 1}};
}
