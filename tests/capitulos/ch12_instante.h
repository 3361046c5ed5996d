// Llevar un programa del capítulo 12 a un instante.
#pragma once
#include "contra_oraculo.h"
#include "guiones.h"
#include "imagenes.h"

const double HORAS = 360000; // segundos: cien horas, múltiplo de todos los periodos

/// Con el reloj parado, el segundo t, en décimas; si pasa de HORAS, no de uno en uno. `inicio`, el del programa al
/// abrirlo.
inline std::string instante(double t, double inicio = 0) {
    const int decimas = int(std::lround(10 * std::fmod(t - inicio, HORAS)));
    return (t >= HORAS ? "tecla h ×10; " : "") + std::string("tecla Espacio; ") +
           veces(decimas / 5, "tecla s") + "; " + veces(decimas % 5, "tecla d");
}
inline std::string conDosCifras(double x) {
    char texto[16];
    std::snprintf(texto, sizeof texto, "%.2f", x);
    return texto;
}
