#include "deduce.h"
#include "lexico.h"
#include "tipos.h"
#include <algorithm>
#include <map>

namespace explica {
namespace {

using Nombres = std::initializer_list<const char *>;

const Nombres DE_LO_QUE_LE_DEN = {"abs", "sign", "min", "max", "clamp"};

bool deReales(const std::string &tipo) {
    return forma(tipo).escalar == "float";
}

class Divisiones {
    std::string fuente;                 // sin blancos
    Palabras p;                         // tras una que no dice nada, para poder mirar siempre la anterior
    std::map<std::string, bool> reales; // lo que se declara, y si es de reales en todas partes
    std::map<std::string, long long> constantes; // las enteras
    std::string devuelve;                        // el tipo de la función en que se está

    bool es(std::size_t i, Nombres cuales) const {
        return std::find(cuales.begin(), cuales.end(), p[i].texto) != cuales.end();
    }
    bool abre(std::size_t i) const {
        return es(i, {"(", "[", "{"});
    }
    bool cierra(std::size_t i) const {
        return es(i, {")", "]", "}"});
    }
    bool esFin(std::size_t i) const {
        return p[i].clase == Palabra::Fin;
    }
    // Desde esa, la siguiente hacia ese lado sin entrar en paréntesis.
    std::size_t otra(std::size_t i, int lado) const {
        int hondo = 0;
        do {
            hondo += (abre(i) - cierra(i)) * lado;
            i += std::size_t(lado);
        } while (hondo > 0 && !esFin(i));
        return i;
    }

    bool entero(std::size_t i, long long &valor) const {
        const auto suya = constantes.find(p[i].texto);
        if (suya != constantes.end())
            valor = suya->second;
        const auto ninguna = [](const std::string &, long long &) { return false; };
        return suya != constantes.end() ||
               (p[i].clase == Palabra::Numero && evalua(&p[i], &p[i] + 1, ninguna, valor));
    }
    bool esReal(std::size_t i) const {
        long long valor;
        if (p[i].clase != Palabra::Nombre)
            return p[i].clase == Palabra::Numero && !entero(i, valor);
        const auto suyo = reales.find(p[i].texto);
        return suyo != reales.end() ? suyo->second : es(i + 1, {"("}) && daReales(i);
    }
    // Una función de GLSL o un constructor.
    bool daReales(std::size_t i) const {
        return esDeGlsl(p[i].texto)
                   ? deReales(p[i].texto)
                   : !es(i, DE_LO_QUE_LE_DEN) &&
                         !es(i, {"textureSize", "texelFetch", "if", "while", "for", "switch", "return"});
    }

    void apuntaDeclarados() {
        for (std::size_t i = 1; !esFin(i) && !esFin(i + 1); ++i) {
            const std::string &tipo = p[i].texto;
            long long valor;
            const bool suya = tipo == "struct" || (p[i].clase == Palabra::Nombre && es(i + 2, {"("}));
            if (p[i + 1].clase == Palabra::Nombre && suya && !es(i, {"return", "else", "do"}))
                reales.insert({p[i + 1].texto, deReales(tipo)}); // y no es una función de GLSL
            if (!esDeGlsl(tipo) || p[i + 1].clase != Palabra::Nombre || suya)
                continue;
            if (tipo == "int" && es(i - 1, {"const"}) && es(i + 2, {"="}) && entero(i + 3, valor) &&
                es(i + 4, {";"}))
                constantes[p[i + 1].texto] = valor;
            for (std::size_t j = i; j == i || es(j, {","});) { // y las demás de la misma declaración
                if (p[++j].clase != Palabra::Nombre || p[j + 1].clase == Palabra::Nombre)
                    break;
                const auto [suyo, nuevo] = reales.insert({p[j].texto, deReales(tipo)});
                suyo->second = suyo->second && deReales(tipo);
                while (!esFin(j) && !es(j, {",", ";"}) && !cierra(j))
                    j = otra(j, 1);
            }
        }
    }

    bool estaEscrita(const std::string &division) const {
        const auto sigue = [&](std::size_t i) {
            return i < fuente.size() && (fuente[i] == '.' || (fuente[i] >= '0' && fuente[i] <= '9'));
        };
        std::size_t i = fuente.find(division);
        while (i != fuente.npos && (sigue(i - 1) || sigue(i + division.size())))
            i = fuente.find(division, i + 1);
        return i != fuente.npos;
    }

    // Si lo que hay de la palabra a a la b, que da ese cociente, acaba entre reales.
    bool acabaEntreReales(std::size_t a, std::size_t b, long long cociente, int quedan = 100) const {
        static const Nombres CORTA = {",", ";", "?", ":", "&&", "||"};
        const std::size_t desde = a, hasta = b;
        bool condicion = false; // a la izquierda de ? : && || y hasta el =, no es con lo que se opera
        for (b = otra(b, 1); !esFin(b) && !cierra(b) && !es(b, CORTA); b = otra(b, 1))
            if (esReal(b))
                return true;
        for (a = otra(a, -1); !esFin(a) && !abre(a) && !es(a, {",", ";", "}", "return"}); a = otra(a, -1)) {
            condicion = (condicion || es(a, CORTA)) && !es(a, {"="});
            if (!condicion && esReal(a))
                return true;
        }
        if (es(a, {"return"}))
            return deReales(devuelve);
        const bool sola = a + 1 == desde && b == hasta + 1;
        while (!esFin(a) && !abre(a) && !es(a, {";", "}"})) // de un argumento, a su paréntesis
            a = otra(a, -1);
        if (!es(a, {"("}))
            return false;
        const std::size_t fin = otra(a, 1) - 1;
        const bool igual = es(a - 1, DE_LO_QUE_LE_DEN);
        if (igual || p[a - 1].clase != Palabra::Nombre)
            return quedan && (cociente == 0 || sola) &&
                   acabaEntreReales(a - igual, fin, cociente, quedan - 1);
        // float(n / 2) puede ser a propósito
        return !reales.count(p[a - 1].texto) && daReales(a - 1) &&
               (!esDeGlsl(p[a - 1].texto) || (cociente == 0 && sola));
    }

public:
    explicit Divisiones(const std::string &texto) : fuente(texto), p(preprocesa(texto).palabras) {
        fuente.erase(
            std::remove_if(fuente.begin(), fuente.end(), [](char c) { return c == ' ' || c == '\t'; }),
            fuente.end());
        p.insert(p.begin(), Palabra());
        p.push_back(Palabra());
        apuntaDeclarados();
    }

    std::vector<Division> todas() {
        std::vector<Division> hay;
        int hondo = 0;
        for (std::size_t i = 2; !esFin(i - 1) && !esFin(i); ++i) {
            hondo += es(i, {"{"}) - es(i, {"}"});
            if (hondo == 0 && es(i + 1, {"("}) && p[i].clase == Palabra::Nombre)
                devuelve = p[i - 1].texto;
            Division d{p[i].linea, 0, 0};
            if (!es(i, {"/"}) || es(i - 2, {"*", "/", "%", "."}) || es(i + 2, {"(", "[", "."}) ||
                !entero(i - 1, d.dividendo) || !entero(i + 1, d.divisor) || d.divisor == 0 ||
                d.dividendo % d.divisor == 0)
                continue;
            // con un cociente que no es 0, puede ser la mitad de un tamaño: n / 2
            const bool escrita = estaEscrita(std::to_string(d.dividendo) + "/" + std::to_string(d.divisor));
            if ((escrita || d.dividendo < d.divisor) &&
                acabaEntreReales(i - 1, i + 1, d.dividendo / d.divisor))
                hay.push_back(d);
        }
        return hay;
    }
};

} // namespace

std::vector<Division> divisionesEnteras(const std::string &fuente) {
    try {
        return Divisiones(fuente).todas();
    } catch (const NoSe &) {
        return {};
    }
}

} // namespace explica
