// Los filtros de tamaño variable del ejercicio 9.2. Sin OpenGL; los usa convolucion_variable y los comprueban las
// pruebas.
#pragma once
#include <cmath>
#include <cstddef>
#include <vector>

const int TALLA_MAXIMA = 31;

enum Familia { CAJA, GAUSSIANA, DISCO, DERIVADA, FAMILIAS };

/// Un filtro de talla × talla, por filas desde j = 0 (ecuación 9.1). Si es el producto de una fila por una columna,
/// filtro(i, j) = fila[i]·columna[j], bastan dos pasadas de `talla` texeles; si no lo es, las dos están vacías.
struct Filtro {
    int talla;
    std::vector<float> valores, fila, columna;
    bool esSeparable() const {
        return !fila.empty();
    }
};

/// Divide por la suma de los positivos: la de todos, o en uno que suma 0 la mitad que aclara. Un filtro nulo se queda
/// como está.
inline void normaliza(std::vector<float> &valores) {
    double suma = 0;
    for (const float v : valores)
        suma += v > 0 ? v : 0;
    for (float &v : valores)
        v = suma > 0 ? float(v / suma) : 0;
}

/// La caja promedia; la gaussiana pesa más el centro (σ = talla/5); el disco promedia un círculo, como un objetivo
/// desenfocado, y no es separable; la derivada es la de la gaussiana respecto de x, y suma 0.
inline Filtro creaFiltro(Familia familia, int talla) {
    const double centro = (talla - 1) / 2.0, sigma = talla / 5.0, radio = talla / 2.0;
    const auto gaussiana = [=](double x) { return std::exp(-x * x / (2 * sigma * sigma)); };
    Filtro f{talla, {}, {}, {}};
    for (int i = 0; i < talla && familia != DISCO; ++i) {
        const double x = i - centro;
        const double g = familia == CAJA ? 1 : gaussiana(x);
        f.fila.push_back(float(familia == DERIVADA ? x * g : g));
        f.columna.push_back(float(g));
    }
    normaliza(f.fila);
    normaliza(f.columna);
    for (int j = 0; j < talla; ++j)
        for (int i = 0; i < talla; ++i)
            f.valores.push_back(f.esSeparable() ? f.fila[i] * f.columna[j]
                                                : float(std::hypot(i - centro, j - centro) <= radio));
    if (!f.esSeparable())
        normaliza(f.valores);
    return f;
}
