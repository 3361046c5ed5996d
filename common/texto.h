// Un texto con números dentro, para un rótulo o un título.
#pragma once
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
