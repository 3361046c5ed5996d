#include "glsl.h"
#include "reescritor.h"
#include <algorithm>

namespace explica {

Reescrito reescribe(const std::string &fuente, int salidas, Etapa etapa, const Define &define,
                    bool lecturas) {
    try {
        return Reescritor(preprocesa(fuente, define), salidas, etapa == Etapa::Fragmento, lecturas).hace();
    } catch (const NoSe &e) {
        return {"", {}, {{e.linea, e.fichero, e.what()}}};
    }
}

int huecosDe(int salidas) {
    return std::clamp(salidas - 2, 1, 4);
}

int pasosDe(const std::string &tipo) {
    const Forma f = forma(tipo);
    const bool entero = f.escalar == "int" || f.escalar == "uint";
    return f.columnas > 1 ? f.columnas : entero && f.filas > 2 ? 2 : 1;
}

std::vector<double> valor(const std::string &tipo, const float *pasos) {
    const Forma f = forma(tipo);
    std::vector<double> v;
    const bool entero = f.escalar == "int" || f.escalar == "uint";
    for (int c = 0; !f.escalar.empty() && c < f.columnas; ++c)
        for (int k = 0; k < f.filas; ++k)
            v.push_back(pasos[4 * c + k]);
    for (int k = 0; entero && k < f.filas; ++k)
        v[std::size_t(k)] += 65536.0 * pasos[f.filas > 2 ? 4 + k : f.filas + k];
    return v;
}

} // namespace explica
