// Lo que un programa dibuja encima de su escena, que ningún trazador de rayos ve: rótulos y trazos. Se comprueba que están donde
// deben y se quitan de la imagen, poniendo en su lugar la referencia, para comparar después lo demás.
#pragma once
#include "letra.h"
#include "oraculo/oraculo.h"
#include <algorithm>
#include <glm/glm.hpp>
#include <string>
#include <vector>

/// Rectángulo de la tinta de un rótulo, en píxeles; `celda` es el lado de los cuadrados de sus letras.
struct CajaRotulo {
    int x0, y0, x1, y1, celda;
    double lejosDe(double x, double y) const {
        return std::hypot(0.5 * (x0 + x1 + 1) - x, 0.5 * (y0 + y1 + 1) - y);
    }
};

inline bool esColor(const Imagen &imagen, int x, int y, const glm::vec3 &color) {
    if (x < 0 || y < 0 || x >= imagen.ancho || y >= imagen.alto)
        return false;
    for (int k = 0; k < 3; ++k)
        if (std::fabs(
                imagen.rgb[3 * static_cast<std::size_t>(y * imagen.ancho + x) + static_cast<std::size_t>(k)] -
                255 * color[k]) > 1)
            return false;
    return true;
}

/// Dónde se lee ese texto, de una línea y de ese color: la tinta está toda y en los huecos de las letras no hay.
inline std::vector<CajaRotulo> leeRotulo(const Imagen &imagen, const std::string &texto,
                                         const glm::vec3 &color) {
    std::vector<glm::ivec2> tinta, huecos;
    int letras = 0;
    for (std::size_t i = 0; i < texto.size(); ++letras) {
        const unsigned char primero = static_cast<unsigned char>(texto[i++]);
        char32_t c = primero < 0x80 ? primero : primero < 0xE0 ? primero & 0x1Fu : primero & 0x0Fu;
        for (; i < texto.size() && (static_cast<unsigned char>(texto[i]) & 0xC0) == 0x80; ++i)
            c = c << 6 | (static_cast<unsigned char>(texto[i]) & 0x3Fu);
        for (int fila = 0; c != U' ' && fila < 7; ++fila)
            for (int columna = 0; columna < 5; ++columna)
                (LETRA.at(c)[static_cast<std::size_t>(fila)] >> (4 - columna) & 1 ? tinta : huecos)
                    .push_back({6 * letras + columna, 6 - fila});
    }
    std::vector<CajaRotulo> cajas;
    for (int celda = 1; celda <= 8; ++celda)
        for (int y = 0; y + 7 * celda <= imagen.alto; ++y)
            for (int x = 0; x + (6 * letras - 1) * celda <= imagen.ancho; ++x) {
                const auto pintado = [&](const glm::ivec2 &c) {
                    return esColor(imagen, x + c.x * celda, y + c.y * celda, color) &&
                           esColor(imagen, x + (c.x + 1) * celda - 1, y + (c.y + 1) * celda - 1, color);
                };
                if (std::all_of(tinta.begin(), tinta.end(), pintado) &&
                    std::none_of(huecos.begin(), huecos.end(), pintado))
                    cajas.push_back({x, y, x + (6 * letras - 1) * celda - 1, y + 7 * celda - 1, celda});
            }
    return cajas;
}

/// Si se lee el texto con su centro a menos de `lejos` píxeles de (x, y).
inline bool seLee(const Imagen &imagen, const std::string &texto, const glm::vec3 &color, double x, double y,
                  double lejos) {
    for (const CajaRotulo &c : leeRotulo(imagen, texto, color))
        if (c.lejosDe(x, y) < lejos)
            return true;
    return false;
}

/// Una imagen a la que se le va quitando lo que lleva encima. Se busca siempre en la original: lo que se quita no estorba a
/// lo que se cruza con ello.
struct SinEncima {
    const Imagen original;
    const oraculo::ImagenRef &ref;
    Imagen limpia;

    SinEncima(const Imagen &imagen, const oraculo::ImagenRef &laRef)
        : original(imagen), ref(laRef), limpia(imagen) {
    }

    /// Quita el rótulo cuyo centro está a menos de `lejos` píxeles de (x, y), con su halo. Devuelve si estaba.
    bool rotulo(const std::string &texto, const glm::vec3 &color, double x, double y, double lejos = 20) {
        bool estaba = false;
        for (const CajaRotulo &c : leeRotulo(original, texto, color)) {
            if (c.lejosDe(x, y) >= lejos)
                continue;
            estaba = true;
            const int halo = std::max(c.celda / 2, 1);
            for (int v = c.y0 - halo; v <= c.y1 + halo; ++v)
                for (int u = c.x0 - halo; u <= c.x1 + halo; ++u)
                    quita(u, v);
        }
        return estaba;
    }

    /// Quita lo que sea de ese color a menos de `medio` píxeles de la línea, dada por sus puntos en el mundo. Devuelve qué
    /// parte de la línea se veía.
    double trazo(const oraculo::Camara &camara, const std::vector<oraculo::Vec3> &puntos,
                 const glm::vec3 &color, double medio = 2.5) {
        const int radio = static_cast<int>(std::ceil(medio));
        int muestras = 0, vistas = 0;
        for (std::size_t i = 0; i + 1 < puntos.size(); ++i) {
            const oraculo::Vec3 a = oraculo::proyecta(camara, original.ancho, original.alto, puntos[i]),
                                b = oraculo::proyecta(camara, original.ancho, original.alto, puntos[i + 1]);
            const int pasos = std::max(static_cast<int>(2 * std::hypot(b.x - a.x, b.y - a.y)), 1);
            for (int k = 0; k <= pasos; ++k) {
                const double px = a.x + (b.x - a.x) * k / pasos, py = a.y + (b.y - a.y) * k / pasos;
                const int x = static_cast<int>(std::floor(px)), y = static_cast<int>(std::floor(py));
                bool vista = false;
                for (int v = y - radio; v <= y + radio; ++v)
                    for (int u = x - radio; u <= x + radio; ++u) {
                        const double lejos = std::hypot(u + 0.5 - px, v + 0.5 - py);
                        if (lejos > medio || !esColor(original, u, v, color))
                            continue;
                        quita(u, v);
                        vista = vista || lejos < 1.5;
                    }
                ++muestras;
                vistas += vista;
            }
        }
        return static_cast<double>(vistas) / muestras;
    }

private:
    void quita(int x, int y) {
        if (x < 0 || y < 0 || x >= limpia.ancho || y >= limpia.alto)
            return;
        for (int k = 0; k < 3; ++k)
            limpia.rgb[3 * static_cast<std::size_t>(y * limpia.ancho + x) + static_cast<std::size_t>(k)] =
                static_cast<unsigned char>(std::lround(255 * std::clamp(ref.en(x, y).color[k], 0.0, 1.0)));
    }
};
