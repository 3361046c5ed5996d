// Un texto con números dentro, para un rótulo o un título.
#pragma once
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <string>

/// Lo que escribiría std::printf. Cabe en un rótulo: menos de 128 bytes.
[[gnu::format(printf, 1, 2)]] inline std::string formatea(const char *formato, ...) {
    char texto[128];
    va_list datos;
    va_start(datos, formato);
    std::vsnprintf(texto, sizeof texto, formato, datos);
    va_end(datos);
    return texto;
}

/// Los trozos de un corchete de cuatro renglones.
const char *const ABRE[] = {"⎡", "⎢", "⎢", "⎣"}, *const CIERRA[] = {"⎤", "⎥", "⎥", "⎦"};

/// Redondeado, que cos 90° no se escriba −4.4e−8; y sin el signo de −0.
template<class Real>
double aCentesimas(Real x) {
    return std::round(100 * x) / 100 + 0.0;
}
