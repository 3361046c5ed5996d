// Los mapas de entorno de §8.1: qué texel del de cubo, o del esférico, toca a cada dirección. Sin OpenGL.
#pragma once
#include "imagen.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <vector>

/// Las caras, en el orden de OpenGL. Cada una es una foto hecha desde el centro: qué ejes del mundo tiene a la derecha,
/// arriba y enfrente, y su sitio (columna y fila) en el mapa desplegado. `u` y `v` son lo que se divide por la mayor
/// coordenada, en valor absoluto, para llegar a ellas.
struct Cara {
    const char *fichero, *nombre, *donde, *u, *v;
    glm::mat3 base;
    int columna, fila;

    /// OpenGL mira el cubo desde fuera: en las cuatro caras de los lados u va de derecha a izquierda de la foto y v, de
    /// arriba abajo.
    bool delReves() const {
        return fila == 1;
    }
};
const glm::vec3 EJE_X(1, 0, 0), EJE_Y(0, 1, 0), EJE_Z(0, 0, 1);
const std::array<Cara, 6> CARAS = {
    {{"derecha", "+X", "derecha", "− z", "− y", {EJE_Z, EJE_Y, EJE_X}, 2, 1},
     {"izquierda", "−X", "izquierda", "+ z", "− y", {-EJE_Z, EJE_Y, -EJE_X}, 0, 1},
     {"arriba", "+Y", "arriba", "+ x", "+ z", {EJE_X, EJE_Z, EJE_Y}, 1, 0},
     {"abajo", "−Y", "abajo", "+ x", "− z", {EJE_X, -EJE_Z, -EJE_Y}, 1, 2},
     {"detras", "+Z", "detrás", "+ x", "− y", {-EJE_X, EJE_Y, EJE_Z}, 3, 1},
     {"delante", "−Z", "delante", "− x", "− y", {EJE_X, EJE_Y, -EJE_Z}, 1, 1}}};

struct EnCara {
    int cara;
    float u, v; // de 0 a 1
};

/// La cara que toca a esa dirección, la de su coordenada de mayor magnitud, y sus coordenadas en ella: lo que hace
/// texture() con un samplerCube. Son las de OpenGL, y no las de la ecuación 8.1.
inline EnCara enCara(const glm::vec3 &R) {
    const glm::vec3 m = glm::abs(R);
    int eje = m.y >= m.z ? 1 : 2;
    if (m.x >= m.y && m.x >= m.z)
        eje = 0;
    const float signo = R[eje] < 0 ? -1.0f : 1.0f;
    const float u[3] = {-signo * R.z, R.x, signo * R.x}, v[3] = {-R.y, signo * R.z, -R.y};
    return {2 * eje + (signo < 0), (1 + u[eje] / m[eje]) / 2, (1 + v[eje] / m[eje]) / 2};
}

/// Las coordenadas, de 0 a 1, de esa dirección en el mapa esférico (esferico.glsl).
inline glm::vec2 enEsfera(const glm::vec3 &R) {
    return {std::atan2(R.x, -R.z) / (2 * glm::pi<float>()) + 0.5f,
            std::asin(glm::clamp(R.y / glm::length(R), -1.0f, 1.0f)) / glm::pi<float>() + 0.5f};
}

/// Una foto del entorno entero: hacia la derecha, una vuelta completa, con −Z en medio; hacia arriba, de −Y a +Y. Cada
/// texel es la media de 2×2 direcciones. `caras`, cuadradas y como las quiere OpenGL.
inline Imagen mapaEsferico(const std::array<Imagen, 6> &caras, int alto) {
    Imagen mapa{2 * alto, alto, {}};
    std::vector<glm::vec2> giros; // seno y coseno de cada medio texel, desde −π
    for (int i = 0; i < 4 * alto; ++i) {
        const float longitud = glm::pi<float>() * ((float(i) + 0.5f) / float(2 * alto) - 1);
        giros.push_back({std::sin(longitud), std::cos(longitud)});
    }
    for (int y = 0; y < alto; ++y)
        for (int x = 0; x < 2 * alto; ++x) {
            glm::ivec3 suma(2); // para redondear
            for (int k = 0; k < 4; ++k) {
                const glm::vec2 longitud = giros[2 * x + k % 2],
                                latitud = giros[2 * y + k / 2 + alto]; // desde −π/2
                const EnCara c = enCara({latitud.y * longitud.x, latitud.x, -latitud.y * longitud.y});
                const Imagen &foto = caras[c.cara];
                const glm::ivec2 texel =
                    glm::min(glm::ivec2(float(foto.ancho) * glm::vec2(c.u, c.v)), foto.ancho - 1);
                const unsigned char *rgb = &foto.rgb[3 * (std::size_t(texel.y) * foto.ancho + texel.x)];
                suma += glm::ivec3(rgb[0], rgb[1], rgb[2]);
            }
            for (int i = 0; i < 3; ++i)
                mapa.rgb.push_back(static_cast<unsigned char>(suma[i] / 4));
        }
    return mapa;
}
