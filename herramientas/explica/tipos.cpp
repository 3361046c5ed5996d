#include "tipos.h"
#include <array>

namespace explica {

namespace {

const std::size_t HOJAS = 40;

bool esCifra(char c) {
    return c >= '2' && c <= '4';
}

// Si cabe. `quedan`: las veces que aún se puede mirar un tipo dentro de otro.
bool reparte(const std::string &nombre, const Tipo &tipo, std::vector<Campo> &todas, int &quedan) {
    if (--quedan < 0 || tipo.cuantos < 0 || todas.size() > HOJAS)
        return false;
    bool cabe = true;
    if (tipo.opaco())
        return true;
    if (tipo.cuantos > 0) {
        for (int i = 0; cabe && i < tipo.cuantos; ++i)
            cabe = reparte(nombre + "[" + std::to_string(i) + "]", elemento(tipo), todas, quedan);
    } else if (tipo.estructura) {
        for (const Campo &c : *tipo.estructura)
            cabe = cabe && reparte(nombre + "." + c.nombre, c.tipo, todas, quedan);
    } else if (tipo.numerico()) {
        todas.push_back({nombre, {nombreDe(forma(tipo.base)), nullptr, 0}});
    } else {
        cabe = false;
    }
    return cabe;
}

} // namespace

Forma forma(const std::string &base) {
    static const std::array<const char *, 4> ESCALARES = {"float", "int", "uint", "bool"};
    static const std::array<const char *, 4> VECTORES = {"vec", "ivec", "uvec", "bvec"};
    for (std::size_t i = 0; i < ESCALARES.size(); ++i) {
        const std::string v = VECTORES[i];
        if (base == ESCALARES[i])
            return {base, 1, 1};
        if (base.size() == v.size() + 1 && base.compare(0, v.size(), v) == 0 && esCifra(base.back()))
            return {ESCALARES[i], 1, base.back() - '0'};
    }
    if (base.compare(0, 3, "mat") == 0 && base.size() >= 4 && esCifra(base[3])) {
        if (base.size() == 4)
            return {"float", base[3] - '0', base[3] - '0'};
        if (base.size() == 6 && base[4] == 'x' && esCifra(base[5]))
            return {"float", base[3] - '0', base[5] - '0'};
    }
    return {};
}

std::string nombreDe(const Forma &f) {
    const std::string filas = std::to_string(f.filas), columnas = std::to_string(f.columnas);
    if (f.columnas > 1)
        return "mat" + columnas + (f.filas == f.columnas ? "" : "x" + filas);
    return f.filas == 1 ? f.escalar : (f.escalar == "float" ? "" : f.escalar.substr(0, 1)) + "vec" + filas;
}

bool Tipo::numerico() const {
    return cuantos == 0 && !estructura && !forma(base).escalar.empty();
}

bool Tipo::opaco() const {
    const std::size_t i = base.compare(0, 1, "i") == 0 || base.compare(0, 1, "u") == 0;
    return !estructura && base.compare(i, 7, "sampler") == 0;
}

bool esDeGlsl(const std::string &palabra) {
    const Tipo tipo{palabra, nullptr, 0};
    return palabra == "void" || tipo.numerico() || tipo.opaco();
}

Tipo miembro(const Tipo &de, const std::string &campo) {
    if (de.cuantos != 0)
        return {};
    if (de.estructura) {
        for (const Campo &c : *de.estructura)
            if (c.nombre == campo)
                return c.tipo;
        return {};
    }
    Forma f = forma(de.base);
    if (f.escalar.empty() || f.columnas > 1 || campo.size() > 4)
        return {};
    f.filas = int(campo.size());
    return {nombreDe(f), nullptr, 0};
}

Tipo elemento(const Tipo &de) {
    if (de.cuantos != 0)
        return {de.base, de.estructura, 0};
    Forma f = forma(de.base);
    if (de.estructura || f.escalar.empty())
        return {};
    if (f.columnas == 1)
        f.filas = 1;
    f.columnas = 1;
    return {nombreDe(f), nullptr, 0};
}

std::vector<Campo> hojas(const std::string &nombre, const Tipo &tipo) {
    std::vector<Campo> todas;
    int quedan = 200;
    if (!reparte(nombre, tipo, todas, quedan) || todas.size() > HOJAS)
        todas.clear();
    return todas;
}

} // namespace explica
