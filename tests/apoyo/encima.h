// Lo que un programa dibuja encima de su escena, que ningún trazador de rayos ve: rótulos y trazos. Se comprueba que están donde
// deben y se quitan de la imagen, poniendo en su lugar la referencia, para comparar después lo demás.
#pragma once
#include "oraculo/oraculo.h"
#include "rotulos.h"

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
        for (const Rotulo &c : leeRotulo(original, texto, color)) {
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
