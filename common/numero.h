// Números escritos en un texto, leídos enteros: ni blancos, ni signo +, ni nada que sobre, y sin depender del idioma.
#pragma once
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

/// El número que es todo el texto; nada si no lo es o no cabe en T.
template<class T>
std::optional<T> numeroDe(std::string_view texto) {
    T n{};
    const char *final = texto.data() + texto.size();
    const auto [fin, error] = std::from_chars(texto.data(), final, n);
    return error == std::errc() && fin == final ? std::optional<T>(n) : std::nullopt;
}

#ifndef __cpp_lib_to_chars // hay bibliotecas de C++ (la de Emscripten) cuyo from_chars solo lee enteros
template<>
inline std::optional<double> numeroDe(std::string_view texto) {
    const std::string copia(texto); // strtod necesita el cero final, y leería hexadecimales, blancos o un +
    if (copia.empty() || copia[0] == '+' || copia.find_first_not_of("0123456789.eE+-") != copia.npos)
        return std::nullopt;
    char *fin = nullptr;
    errno = 0;
    const double n = std::strtod(copia.c_str(), &fin);
    return errno == 0 && fin == copia.c_str() + copia.size() ? std::optional<double>(n) : std::nullopt;
}
#endif

/// «ANCHOxALTO», los dos al menos 1. Si no lo es devuelve false y no los toca.
inline bool leeTalla(std::string_view texto, int &ancho, int &alto) {
    const std::size_t x = texto.find('x');
    if (x == std::string_view::npos)
        return false;
    const std::optional<int> a = numeroDe<int>(texto.substr(0, x)), b = numeroDe<int>(texto.substr(x + 1));
    if (!a || !b || *a < 1 || *b < 1)
        return false;
    ancho = *a;
    alto = *b;
    return true;
}
