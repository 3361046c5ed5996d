// Figuras planas: de qué color debe ser cada píxel de unas piezas pintadas una sobre otra, en doble precisión.
#pragma once
#include "contra_oraculo.h"
#include <GL/glew.h>

/// Un polígono convexo, en píxeles desde abajo a la izquierda, de un color; o un triángulo, con uno en cada vértice.
struct Pieza {
    oraculo::Poligono contorno;
    std::vector<oraculo::Vec3> colores;

    oraculo::Vec3 color(const oraculo::Vec2 &p) const {
        if (colores.size() == 1)
            return colores[0];
        const oraculo::Vec2 &a = contorno[0], &b = contorno[1], &c = contorno[2];
        const double total = oraculo::area(contorno), wa = oraculo::area({p, b, c}) / total,
                     wb = oraculo::area({a, p, c}) / total;
        return wa * colores[0] + wb * colores[1] + (1 - wa - wb) * colores[2];
    }
};

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

/// Los triángulos que salen de esos vértices, según la especificación de OpenGL 3.1, §2.6.1. El último vértice de cada uno es el que
/// no tiene el anterior.
inline std::vector<Pieza> triangulos(GLenum primitiva, const std::vector<VerticePlano> &v, const Hueco &h) {
    std::vector<Pieza> piezas;
    for (std::size_t i = 0; i + 2 < v.size(); i += primitiva == GL_TRIANGLES ? 3 : 1) {
        const VerticePlano &a = v[primitiva == GL_TRIANGLE_FAN ? 0 : i], &b = v[i + 1], &c = v[i + 2];
        piezas.push_back({{a.en(h), b.en(h), c.en(h)}, {a.color, b.color, c.color}});
    }
    return piezas;
}

/// Cada píxel de ese trozo de la escena es del color de la última pieza que cubre su centro o, si ninguna, del fondo. Donde el lado de una está a menos de
/// `holgura` píxeles vale también lo que tiene debajo: OpenGL lleva los vértices a una rejilla de 1/256, y un lado se mueve como
/// mucho la mitad de su diagonal. Si no están `enOrden`, donde se solapan vale cualquiera. Lo que se pierde es el redondeo a 8 bits.
inline void compruebaPlana(const std::string &que, const Imagen &escena, const std::vector<Pieza> &piezas,
                           const oraculo::Vec3 &fondo, double maximo = 0.501, double holgura = 1.0 / 256,
                           bool enOrden = true) {
    double mayor = 0;
    std::string donde;
    for (int y = 0; y < escena.alto; ++y)
        for (int x = 0; x < escena.ancho; ++x) {
            const oraculo::Vec2 centro{x + 0.5, y + 0.5};
            double diferencia = oraculo::INFINITO;
            bool tapado = false;
            for (auto pieza = piezas.rbegin(); pieza != piezas.rend() && !(tapado && enOrden); ++pieza) {
                const double dentro = oraculo::distanciaDentro(pieza->contorno, centro.x, centro.y);
                if (dentro > -holgura)
                    diferencia =
                        std::min(diferencia, oraculo::diferencia(escena, x, y, pieza->color(centro)));
                tapado = tapado || dentro > holgura;
            }
            if (!tapado)
                diferencia = std::min(diferencia, oraculo::diferencia(escena, x, y, fondo));
            if (diferencia > mayor) {
                mayor = diferencia;
                donde = std::to_string(x) + ", " + std::to_string(y);
            }
        }
    EXPECT_LE(mayor, maximo) << que << ", en (" << donde << ")";
    apuntaDiferencia(mayor, -1, holgura);
}
