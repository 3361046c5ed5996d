#include "deduce.h"
#include "lexico.h"
#include <algorithm>

namespace explica {

std::vector<Division> divisionesEnteras(const std::string &fuente) {
    Palabras p;
    try {
        p = preprocesa(fuente).palabras;
    } catch (const NoSe &) {
        return {};
    }
    std::string junto = fuente; // con N / 2, si N es una macro, no está escrito
    junto.erase(std::remove_if(junto.begin(), junto.end(), [](char c) { return c == ' ' || c == '\t'; }),
                junto.end());
    const auto entero = [&](std::size_t i, long long &valor) {
        const auto ninguna = [](const std::string &, long long &) { return false; };
        return p[i].clase == Palabra::Numero && evalua(&p[i], &p[i] + 1, ninguna, valor);
    };
    const auto sigueOtro = [&](std::size_t i) { // 2 * 1 / 2 es (2 * 1) / 2
        return i < p.size() && std::string("*/%.").find(p[i].texto) != std::string::npos;
    };
    std::vector<Division> hay;
    for (std::size_t i = 1; i + 1 < p.size(); ++i) {
        Division d{p[i].linea, 0, 0};
        if (p[i].texto == "/" && entero(i - 1, d.dividendo) && entero(i + 1, d.divisor) && 0 < d.dividendo &&
            d.dividendo < d.divisor && !sigueOtro(i - 2) &&
            junto.find(p[i - 1].texto + "/" + p[i + 1].texto) != std::string::npos)
            hay.push_back(d);
    }
    return hay;
}

} // namespace explica
