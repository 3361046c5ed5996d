// JSON, lo justo para escribirlo.
#pragma once
#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace explica {

inline std::string enJson(const std::string &texto) {
    std::string citado = "\"";
    for (const char c : texto) {
        if (c == '"' || c == '\\')
            citado += '\\';
        if (static_cast<unsigned char>(c) < ' ') {
            char codigo[8];
            std::snprintf(codigo, sizeof codigo, "\\u%04x", unsigned(c));
            citado += codigo;
        } else {
            citado += c;
        }
    }
    return citado + '"';
}
inline std::string enJson(const char *texto) {
    return enJson(std::string(texto));
}

/// Un número, con los bits de un float; los que JSON no tiene, como texto: "nan", "inf", "-inf".
template<class Numero, std::enable_if_t<std::is_arithmetic_v<Numero>, int> = 0>
std::string enJson(Numero numero) {
    if constexpr (std::is_same_v<Numero, bool>)
        return numero ? "true" : "false";
    if constexpr (std::is_integral_v<Numero>)
        return std::to_string(numero);
    char texto[32];
    std::snprintf(texto, sizeof texto, std::isfinite(double(numero)) ? "%.9g" : "\"%g\"", double(numero));
    return std::isnan(double(numero)) ? "\"nan\"" : texto; // sin el signo, que no dice nada
}

/// Para leerlo, con esas cifras.
inline std::string cifras(double numero, int cuantas) {
    char texto[32];
    std::snprintf(texto, sizeof texto, "%.*g", cuantas, numero);
    return texto;
}

/// Un objeto, clave a clave.
class Json {
    std::string dentro;

public:
    struct Par {
        std::string texto;
        template<class Valor>
        Par(const char *clave, const Valor &valor);
    };
    Json(std::initializer_list<Par> pares = {}) {
        for (const Par &par : pares)
            anade(par);
    }
    Json &anade(const Par &par) {
        dentro += (dentro.empty() ? "" : ",\n") + par.texto;
        return *this;
    }
    template<class Valor>
    Json &pon(const char *clave, const Valor &valor);
    std::string texto() const {
        return "{" + dentro + "}";
    }
};

inline std::string enJson(const Json &objeto) {
    return objeto.texto();
}
template<class Valor>
std::string enJson(const std::optional<Valor> &valor);
template<class Valor, std::size_t n>
std::string enJson(const std::array<Valor, n> &lista);

template<class Lista>
std::string listaEnJson(const Lista &lista) {
    std::string texto;
    for (const auto &valor : lista)
        texto += (texto.empty() ? "" : ",") + enJson(valor);
    return "[" + texto + "]";
}
template<class Valor>
std::string enJson(const std::vector<Valor> &lista) {
    return listaEnJson(lista);
}
template<class Valor, std::size_t n>
std::string enJson(const std::array<Valor, n> &lista) {
    return listaEnJson(lista);
}
template<class Valor>
std::string enJson(const std::optional<Valor> &valor) {
    return valor ? enJson(*valor) : "null";
}

template<class Valor>
Json::Par::Par(const char *clave, const Valor &valor) : texto(enJson(clave) + ":" + enJson(valor)) {
}
template<class Valor>
Json &Json::pon(const char *clave, const Valor &valor) {
    return anade({clave, valor});
}

} // namespace explica
