// El algoritmo Z-Buffer (§4.4, listado 4.1) con las etapas que lo preceden en la GPU: recortado contra el
// plano cerca, división perspectiva, transformación al área de dibujo y rasterización. Sin OpenGL; lo usa el
// programa zbuffer y lo comprueban las pruebas.
#pragma once
#include "imagen.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

/// luz_fija.glsl en la CPU.
const glm::vec3 HACIA_LUZ_FIJA(0.20f, 0.78f, 0.593f);
inline float luzFija(const glm::vec3 &normal) {
    return 0.58f + 0.42f * glm::dot(normal, HACIA_LUZ_FIJA);
}

/// Los dos buffers del listado 4.1. La profundidad va de 0 (cerca) a 1 (lejos).
struct BufferZ {
    Imagen color;
    std::vector<float> profundidad;
    bool test; // sin él, cada fragmento sustituye al que hubiera
};

/// Un vértice a la salida del procesador de vértices.
struct VerticeZ {
    glm::vec4 posicion; // proyección · cámara · modelo · vértice
    glm::vec3 color;    // componentes de 0 a 1
};
using TrianguloZ = std::array<VerticeZ, 3>;

/// Buffers del tamaño pedido, con el color de fondo y la profundidad MÁXIMA: el paso que no hay que olvidar.
inline BufferZ creaBufferZ(int ancho, int alto, const glm::vec3 &fondo, bool test = true) {
    const std::size_t pixeles = std::size_t(ancho) * alto;
    BufferZ b{{ancho, alto, {}}, std::vector<float>(pixeles, 1.0f), test};
    for (std::size_t i = 0; i < pixeles; ++i)
        for (int k = 0; k < 3; ++k)
            b.color.rgb.push_back(enOchoBits(fondo[k]));
    return b;
}

/// Listado 4.1: el fragmento solo se queda si está más cerca que lo pintado antes en su píxel.
inline void pintaFragmento(BufferZ &b, int x, int y, float z, const glm::vec3 &color) {
    const std::size_t i = std::size_t(y) * b.color.ancho + x;
    if (b.test && !(z < b.profundidad[i]))
        return;
    b.profundidad[i] = z;
    for (int k = 0; k < 3; ++k)
        b.color.rgb[3 * i + k] = enOchoBits(color[k]);
}

/// Punto de la ventana en 1/256 de píxel, la rejilla de OpenGL: con enteros, decidir si un píxel está dentro
/// es exacto y dos triángulos que comparten un lado ni se dejan huecos ni se pisan.
struct PuntoRejilla {
    std::int64_t x, y;
};

/// Doble del área del triángulo abc: positiva si gira en sentido antihorario.
inline std::int64_t dobleArea(const PuntoRejilla &a, const PuntoRejilla &b, const PuntoRejilla &c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// De un píxel cuyo centro cae justo en un lado se queda el triángulo que lo tiene a su izquierda o arriba.
/// Con Y hacia arriba y sentido antihorario, los lados izquierdos bajan y los de arriba van hacia −X.
inline bool esLadoIzquierdoOSuperior(const PuntoRejilla &a, const PuntoRejilla &b) {
    return b.y < a.y || (b.y == a.y && b.x < a.x);
}

/// Pinta un triángulo que está entero más allá del plano cerca (w > 0), por cualquiera de sus dos caras.
inline void rasteriza(BufferZ &buffer, TrianguloZ t) {
    const int ancho = buffer.color.ancho, alto = buffer.color.alto;
    const auto enVentana = [&](const VerticeZ &v) { // división perspectiva y transformación al área de dibujo
        return PuntoRejilla{std::llround(128.0f * float(ancho) * (v.posicion.x / v.posicion.w + 1)),
                            std::llround(128.0f * float(alto) * (v.posicion.y / v.posicion.w + 1))};
    };
    std::array<PuntoRejilla, 3> p = {enVentana(t[0]), enVentana(t[1]), enVentana(t[2])};
    if (dobleArea(p[0], p[1], p[2]) < 0) {
        std::swap(t[1], t[2]);
        std::swap(p[1], p[2]);
    }
    const std::int64_t area = dobleArea(p[0], p[1], p[2]);
    if (area == 0)
        return;

    const auto [izquierda, derecha] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [abajo, arriba] = std::minmax({p[0].y, p[1].y, p[2].y});
    const auto pixelEn = [](std::int64_t v, int lado) {
        return int(std::clamp<std::int64_t>(v / 256, 0, lado - 1));
    };
    for (int y = pixelEn(abajo, alto); y <= pixelEn(arriba, alto); ++y)
        for (int x = pixelEn(izquierda, ancho); x <= pixelEn(derecha, ancho); ++x) {
            const PuntoRejilla centro{256 * x + 128, 256 * y + 128};
            bool dentro = true;
            float z = 0, suma = 0;
            glm::vec3 color(0);
            for (std::size_t i = 0; i < 3; ++i) { // el lado opuesto al vértice i
                const PuntoRejilla &a = p[(i + 1) % 3], &b = p[(i + 2) % 3];
                const std::int64_t e = dobleArea(a, b, centro);
                dentro = dentro && (e > 0 || (e == 0 && esLadoIzquierdoOSuperior(a, b)));
                // z/w es lineal en la ventana; el color no, hasta que se divide por w
                const float peso = float(e) / float(area), w = t[i].posicion.w;
                z += peso * 0.5f * (t[i].posicion.z / w + 1);
                color += peso / w * t[i].color;
                suma += peso / w;
            }
            if (dentro && z <= 1) // más allá de lejos no hay nada
                pintaFragmento(buffer, x, y, z, color / suma);
        }
}

/// Pinta un triángulo cualquiera. Antes de dividir por w hay que recortar contra el plano cerca (z = −w): lo
/// que está detrás de la cámara tiene w negativa. Los lados de la ventana los recorta la rasterización.
inline void pintaTriangulo(BufferZ &buffer, const TrianguloZ &t) {
    std::vector<VerticeZ> dentro;
    for (std::size_t i = 0; i < 3; ++i) {
        const VerticeZ &a = t[i], &b = t[(i + 1) % 3];
        const float da = a.posicion.z + a.posicion.w, db = b.posicion.z + b.posicion.w;
        if (da > 0)
            dentro.push_back(a);
        if ((da > 0) != (db > 0)) {
            const float u = da / (da - db);
            dentro.push_back({glm::mix(a.posicion, b.posicion, u), glm::mix(a.color, b.color, u)});
        }
    }
    for (std::size_t i = 2; i < dentro.size(); ++i)
        rasteriza(buffer, {dentro[0], dentro[i - 1], dentro[i]});
}
