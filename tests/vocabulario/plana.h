// Figuras planas: de qué color debe ser cada píxel de unas piezas pintadas una sobre otra, en doble precisión.
#pragma once
#include "contra_oraculo.h"
#include <GL/glew.h>

/// Un polígono convexo, en píxeles desde abajo a la izquierda, de un color; o un triángulo, con uno en cada vértice.
struct Pieza {
    oraculo::Poligono contorno;
    std::vector<oraculo::Vec3> colores;
    double holgura =
        1.0 / 256; // lo que sus lados se pueden apartar, en píxeles: OpenGL lleva los vértices a una rejilla
    bool suelta = false; // donde se solapan varias sueltas vale el color de cualquiera

    oraculo::Vec3 color(const oraculo::Vec2 &p) const {
        if (colores.size() == 1)
            return colores[0];
        const oraculo::Vec2 &a = contorno[0], &b = contorno[1], &c = contorno[2];
        const double total = oraculo::area(contorno), wa = oraculo::area({p, b, c}) / total,
                     wb = oraculo::area({a, p, c}) / total;
        return wa * colores[0] + wb * colores[1] + (1 - wa - wb) * colores[2];
    }
    bool llegaA(double y) const {
        const auto [abajo, arriba] = std::minmax_element(
            contorno.begin(), contorno.end(), [](const auto &a, const auto &b) { return a.y < b.y; });
        return abajo->y - holgura <= y && y <= arriba->y + holgura;
    }
};

inline Pieza rectangulo(const Hueco &h, const oraculo::Vec3 &color) {
    const double x = h.x, y = h.y, ancho = h.ancho, alto = h.alto;
    return {{{x, y}, {x + ancho, y}, {x + ancho, y + alto}, {x, y + alto}}, {color}};
}

/// El mayor cuadrado centrado que cabe en una ventana o, si la `cubre`, el menor que no deja nada fuera.
inline Hueco cuadrado(int ancho, int alto, bool cubre = false) {
    const int lado = cubre ? std::max(ancho, alto) : std::min(ancho, alto);
    return {(ancho - lado) / 2, (alto - lado) / 2, lado, lado};
}

struct VerticePlano {
    double x, y; // coordenadas normalizadas
    oraculo::Vec3 color;

    oraculo::Vec2 en(const Hueco &h) const {
        return {h.x + (x + 1) / 2 * h.ancho, h.y + (y + 1) / 2 * h.alto};
    }
};

/// Los triángulos que salen de esos vértices, según la especificación de OpenGL 3.1, §2.6.1. El último vértice de cada
/// uno es el que no tiene el anterior.
inline std::vector<Pieza> triangulos(GLenum primitiva, const std::vector<VerticePlano> &v, const Hueco &h) {
    std::vector<Pieza> piezas;
    for (std::size_t i = 0; i + 2 < v.size(); i += primitiva == GL_TRIANGLES ? 3 : 1) {
        const VerticePlano &a = v[primitiva == GL_TRIANGLE_FAN ? 0 : i], &b = v[i + 1], &c = v[i + 2];
        piezas.push_back({{a.en(h), b.en(h), c.en(h)}, {a.color, b.color, c.color}});
    }
    return piezas;
}

/// Comprueba que cada píxel es del color de la última pieza que cubre su centro o, si ninguna, del fondo; solo se
/// pierde el redondeo a 8 bits. Si el centro está a menos de su holgura de un lado, vale también lo que hay debajo.
inline void compruebaPlana(const std::string &que, const Imagen &escena, const std::vector<Pieza> &piezas,
                           const oraculo::Vec3 &fondo) {
    double mayor = 0, holgura = -1; // no hay lados
    std::string donde;
    for (int y = 0; y < escena.alto; ++y) {
        std::vector<const Pieza *> deLaFila; // de arriba abajo
        std::for_each(piezas.rbegin(), piezas.rend(), [&](const Pieza &p) {
            if (p.llegaA(y + 0.5))
                deLaFila.push_back(&p);
        });
        for (int x = 0; x < escena.ancho; ++x) {
            const oraculo::Vec2 centro{x + 0.5, y + 0.5};
            const Pieza *tapa = nullptr;
            double diferencia = oraculo::INFINITO;
            for (const Pieza *p : deLaFila) {
                if (tapa && !(tapa->suelta && p->suelta))
                    break;
                const double dentro = oraculo::distanciaDentro(p->contorno, centro.x, centro.y);
                if (dentro > -p->holgura)
                    diferencia = std::min(diferencia, oraculo::diferencia(escena, x, y, p->color(centro)));
                if (dentro > p->holgura)
                    tapa = p;
            }
            if (!tapa)
                diferencia = std::min(diferencia, oraculo::diferencia(escena, x, y, fondo));
            if (diferencia > mayor) {
                mayor = diferencia;
                donde = std::to_string(x) + ", " + std::to_string(y);
            }
        }
    }
    EXPECT_LE(mayor, 0.501) << que << ", en (" << donde << ")";
    for (const Pieza &p : piezas)
        holgura = std::max(holgura, p.holgura);
    apuntaDiferencia(mayor, -1, holgura);
}
