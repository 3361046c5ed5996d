// Mallas de triángulos del oráculo, con una jerarquía de cajas para no probarlos todos.
#pragma once
#include "algebra.h"
#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

namespace oraculo {

/// El corte más cercano encontrado hasta ahora: o + t·d.
struct Corte {
    double t = INFINITO;
    int cara = 0;          // véase Impacto::corte
    int triangulo = -1;    // en una malla
    double b1 = 0, b2 = 0; // … y las coordenadas baricéntricas de su segundo y su tercer vértice

    /// Se queda con `otra` si está más cerca, pero más allá de `minimo`. Con NaN no pasa nada.
    void propon(double otra, double minimo, int laCara = 0) {
        if (otra > minimo && otra < t) {
            t = otra;
            cara = laCara;
        }
    }
};

/// Recorta [entra, sale] a la parte de o + t·d que está en la caja; devuelve si queda algo.
inline bool recortaEnCaja(const Vec3 &minimo, const Vec3 &maximo, const Vec3 &o, const Vec3 &d, double &entra,
                          double &sale) {
    for (int eje = 0; eje < 3; ++eje) {
        if (d[eje] == 0) {
            if (o[eje] < minimo[eje] || o[eje] > maximo[eje])
                return false;
            continue;
        }
        const double a = (minimo[eje] - o[eje]) / d[eje], b = (maximo[eje] - o[eje]) / d[eje];
        entra = std::max(entra, std::min(a, b));
        sale = std::min(sale, std::max(a, b));
    }
    return entra <= sale;
}

struct VerticeRef {
    Vec3 posicion, normal;
    double s = 0, t = 0;
};

class Triangulos {
public:
    using Indices = std::array<std::size_t, 3>;
    std::vector<VerticeRef> vertices;
    std::vector<Indices> indices;
    /// De cada triángulo; la misma en los que están unidos por vértices compartidos, así que cambia donde la
    /// malla repite vértices porque cambia la normal: los seis lados de un cubo son seis zonas.
    std::vector<int> zona;

    Triangulos(std::vector<VerticeRef> losVertices, std::vector<Indices> losIndices)
        : vertices(std::move(losVertices)), indices(std::move(losIndices)), orden(indices.size()) {
        std::vector<std::size_t> padre(vertices.size());
        std::iota(padre.begin(), padre.end(), std::size_t{0});
        const auto raiz = [&](std::size_t i) {
            while (padre[i] != i)
                i = padre[i] = padre[padre[i]];
            return i;
        };
        for (const Indices &t : indices)
            padre[raiz(t[1])] = padre[raiz(t[2])] = raiz(t[0]);
        for (const Indices &t : indices)
            zona.push_back(int(raiz(t[0])));
        std::iota(orden.begin(), orden.end(), std::size_t{0});
        agrupa(0, orden.size());
    }

    void corta(const Vec3 &o, const Vec3 &d, double minimo, Corte &c, std::size_t nodo = 0) const {
        const Nodo &n = nodos[nodo];
        double entra = minimo, sale = c.t;
        if (!recortaEnCaja(n.minimo, n.maximo, o, d, entra, sale))
            return;
        if (n.derecha) {
            corta(o, d, minimo, c, nodo + 1);
            corta(o, d, minimo, c, n.derecha);
            return;
        }
        for (std::size_t i = n.primero; i < n.ultimo; ++i) {
            const Vec3 a = esquina(orden[i], 0), ab = esquina(orden[i], 1) - a, ac = esquina(orden[i], 2) - a;
            const Vec3 normal = vectorial(ab, ac), w = vectorial(o - a, d);
            const double det = -escalar(d, normal), t = escalar(o - a, normal) / det;
            const double b1 = escalar(ac, w) / det, b2 = -escalar(ab, w) / det;
            if (t > minimo && t < c.t && b1 >= -HOLGURA && b2 >= -HOLGURA && b1 + b2 <= 1 + HOLGURA)
                c = {t, zona[orden[i]], int(orden[i]), b1, b2};
        }
    }

private:
    static constexpr double HOLGURA = 1e-12; // para que ningún rayo pase entre dos triángulos vecinos
    struct Nodo {
        Vec3 minimo, maximo;
        std::size_t primero, ultimo, derecha; // hoja si derecha es 0; el hijo izquierdo es el nodo siguiente
    };
    std::vector<std::size_t> orden;
    std::vector<Nodo> nodos;

    const Vec3 &esquina(std::size_t triangulo, std::size_t k) const {
        return vertices[indices[triangulo][k]].posicion;
    }

    void agrupa(std::size_t primero, std::size_t ultimo) {
        Vec3 minimo{INFINITO, INFINITO, INFINITO}, maximo = -minimo;
        for (std::size_t i = primero; i < ultimo; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3 &p = esquina(orden[i], k);
                minimo = {std::min(minimo.x, p.x), std::min(minimo.y, p.y), std::min(minimo.z, p.z)};
                maximo = {std::max(maximo.x, p.x), std::max(maximo.y, p.y), std::max(maximo.z, p.z)};
            }
        const Vec3 lado = maximo - minimo, holgura = HOLGURA * (lado + Vec3{1, 1, 1});
        const std::size_t este = nodos.size();
        nodos.push_back({minimo - holgura, maximo + holgura, primero, ultimo, 0});
        if (ultimo - primero <= 4)
            return;
        const int eje = lado.x >= lado.y && lado.x >= lado.z ? 0 : lado.y >= lado.z ? 1 : 2;
        const auto centro = [&](std::size_t t) {
            return esquina(t, 0)[eje] + esquina(t, 1)[eje] + esquina(t, 2)[eje];
        };
        const std::size_t mitad = (primero + ultimo) / 2;
        const auto en = [&](std::size_t i) { return orden.begin() + i; };
        std::nth_element(en(primero), en(mitad), en(ultimo),
                         [&](std::size_t a, std::size_t b) { return centro(a) < centro(b); });
        agrupa(primero, mitad);
        nodos[este].derecha = nodos.size();
        agrupa(mitad, ultimo);
    }
};

} // namespace oraculo
