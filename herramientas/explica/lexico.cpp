#include "lexico.h"
#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <map>
#include <set>
#include <string_view>

namespace explica {

namespace {

const std::size_t MAXIMO = 1000000; // letras: unas macros dentro de otras crecen sin medida

bool deNombre(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}
bool esCifra(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

// Dónde acaba el número que empieza en i: 1.5e-3f, .5, 0xffu.
std::size_t finNumero(const std::string &s, std::size_t i) {
    const bool hexadecimal = i + 1 < s.size() && s[i] == '0' && (s[i + 1] == 'x' || s[i + 1] == 'X');
    for (; i < s.size(); ++i) {
        const bool exponente = !hexadecimal && (s[i] == 'e' || s[i] == 'E');
        if (exponente && i + 1 < s.size() && (s[i + 1] == '-' || s[i + 1] == '+'))
            ++i;
        else if (!deNombre(s[i]) && s[i] != '.')
            break;
    }
    return i;
}

std::size_t largoSigno(const std::string &s, std::size_t i) {
    static const std::array<std::string_view, 22> SIGNOS = {
        "<<=", ">>=", "++", "--", "<<", ">>", "<=", ">=", "==", "!=", "&&",
        "||",  "^^",  "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "##"};
    for (const std::string_view signo : SIGNOS)
        if (s.compare(i, signo.size(), signo) == 0)
            return signo.size();
    return 1;
}

// Con líneas que acaban como en Unix.
std::string conSaltos(const std::string &s) {
    std::string t;
    for (std::size_t i = 0; i < s.size(); ++i)
        if (s[i] != '\r')
            t += s[i];
        else if (s.compare(i + 1, 1, "\n") != 0)
            t += '\n';
    return t;
}

struct Cruda : Palabra {
    bool primera = false; // de su línea
};

// El texto en palabras, sin comentarios ni líneas partidas.
std::vector<Cruda> separa(const std::string &s) {
    std::vector<Cruda> todas;
    Cruda p;
    p.linea = 1;
    p.primera = true;
    for (std::size_t i = 0; i < s.size();) {
        const std::size_t inicio = i;
        if (s.compare(i, 2, "//") == 0) {
            for (; i < s.size() && s[i] != '\n'; ++i) // también lo que sigue a una \ al final
                if (s.compare(i, 2, "\\\n") == 0)
                    ++i, ++p.linea;
        } else if (s.compare(i, 2, "/*") == 0) {
            const std::size_t fin = s.find("*/", i + 2);
            i = fin == std::string::npos ? s.size() : fin + 2;
            for (std::size_t k = inicio; k < i; ++k)
                p.linea += s[k] == '\n';
        } else if (s.compare(i, 2, "\\\n") == 0) {
            i += 2;
            ++p.linea;
        } else if (s[i] == '\n') {
            ++i;
            ++p.linea;
            p.primera = true;
        } else if (std::isspace(static_cast<unsigned char>(s[i]))) {
            ++i;
        } else {
            if (esCifra(s[i]) || (s[i] == '.' && i + 1 < s.size() && esCifra(s[i + 1]))) {
                p.clase = Palabra::Numero;
                i = finNumero(s, i);
            } else if (deNombre(s[i])) {
                p.clase = Palabra::Nombre;
                while (i < s.size() && deNombre(s[i]))
                    ++i;
            } else {
                p.clase = Palabra::Signo;
                i += largoSigno(s, i);
            }
            p.texto = s.substr(inicio, i - inicio);
            todas.push_back(p);
            p.primera = p.blanco = false;
            continue;
        }
        p.blanco = true;
    }
    p.clase = Palabra::Fin;
    p.texto.clear();
    p.primera = true;
    todas.push_back(p);
    return todas;
}

struct Macro {
    bool conArgumentos = false;
    std::vector<std::string> parametros;
    Palabras cuerpo;
};

class Preprocesador {
public:
    explicit Preprocesador(const Define &quien) : define_(quien) {
    }
    Preprocesado hace(const std::string &fuente) {
        const std::vector<Cruda> crudas = separa(conSaltos(fuente));
        Palabras texto;
        int corrimiento = 0, fichero = 0;
        for (std::size_t i = 0; crudas[i].clase != Palabra::Fin;) {
            Palabras linea;
            const int siguiente = crudas[i].linea + 1;
            do {
                linea.push_back(crudas[i++]);
                linea.back().linea += corrimiento;
                linea.back().fichero = fichero;
            } while (!crudas[i].primera);
            if (linea[0].texto != "#") {
                if (activo())
                    texto.insert(texto.end(), linea.begin(), linea.end());
                continue;
            }
            vuelca(texto);
            if (linea.size() > 1 && linea[1].texto == "line" && activo()) {
                const Palabras numeros = expande({linea.begin() + 2, linea.end()});
                if (!numeros.empty())
                    corrimiento = std::atoi(numeros[0].texto.c_str()) - siguiente;
                if (numeros.size() > 1)
                    fichero = std::atoi(numeros[1].texto.c_str());
            } else if (linea.size() > 1) {
                directiva(linea);
            }
        }
        vuelca(texto);
        Palabra fin;
        fin.linea = crudas.back().linea + corrimiento;
        fin.fichero = fichero;
        resultado.palabras.push_back(fin);
        return std::move(resultado);
    }

private:
    struct Condicion {
        bool antes, ahora, alguna; // si fuera se compila; si esta rama; si ya una
    };
    const Define &define_;
    Preprocesado resultado;
    std::map<std::string, Macro> macros;
    std::vector<Condicion> condiciones;
    std::set<std::string> enCurso; // las macros que se están expandiendo: dentro de sí mismas no se expanden
    std::size_t expandidas = 0;
    int dentro = 0, version = 110;

    bool activo() const {
        return condiciones.empty() || (condiciones.back().antes && condiciones.back().ahora);
    }

    void vuelca(Palabras &texto) {
        const Palabras nuevas = expande(texto);
        resultado.palabras.insert(resultado.palabras.end(), nuevas.begin(), nuevas.end());
        texto.clear();
    }

    void directiva(const Palabras &linea) {
        const std::string &orden = linea[1].texto;
        const Palabras resto(linea.begin() + 2, linea.end());
        if (orden == "if" || orden == "ifdef" || orden == "ifndef") {
            const bool antes = activo(), si = antes && cumple(orden, resto);
            condiciones.push_back({antes, si, si});
        } else if (orden == "elif" || orden == "else" || orden == "endif") {
            if (condiciones.empty())
                throw NoSe(linea[1], "#" + orden + " sin #if");
            Condicion &c = condiciones.back();
            c.ahora = !c.alguna && c.antes && (orden == "else" || (orden == "elif" && cumple("if", resto)));
            c.alguna |= c.ahora;
            if (orden == "endif")
                condiciones.pop_back();
        } else if (activo() && orden == "define" && !resto.empty()) {
            define(resto);
        } else if (activo() && orden == "undef" && !resto.empty()) {
            macros.erase(resto[0].texto);
        } else if (activo() && (orden == "version" || orden == "extension" || orden == "pragma")) {
            resultado.cabecera += "#" + texto(&linea[1], linea.data() + linea.size()) + "\n";
            if (orden == "version" && !resto.empty())
                version = std::atoi(resto[0].texto.c_str());
            if (orden == "version" && resto.size() > 1 && resto[1].texto == "es")
                macros["GL_ES"].cuerpo =
                    macros["GL_FRAGMENT_PRECISION_HIGH"].cuerpo = {{Palabra::Numero, "1"}};
        }
    }

    void define(const Palabras &resto) {
        Macro m;
        std::size_t i = 1;
        if (resto.size() > 1 && resto[1].texto == "(" && !resto[1].blanco) {
            m.conArgumentos = true;
            for (i = 2; i < resto.size() && resto[i].texto != ")"; ++i)
                if (resto[i].texto != ",")
                    m.parametros.push_back(resto[i].texto);
            ++i;
        }
        if (i < resto.size())
            m.cuerpo.assign(resto.begin() + static_cast<std::ptrdiff_t>(i), resto.end());
        macros[resto[0].texto] = m;
    }

    static bool esNumero(const std::string &nombre) {
        return nombre == "__LINE__" || nombre == "__FILE__" || nombre == "__VERSION__";
    }

    bool definida(const Palabra &nombre) {
        const bool esta = macros.count(nombre.texto) > 0 || esNumero(nombre.texto);
        if (esta || nombre.texto.compare(0, 3, "GL_") != 0)
            return esta;
        if (define_ && define_(resultado.cabecera, nombre.texto)) {
            macros[nombre.texto].cuerpo = {{Palabra::Numero, "1"}};
            return true;
        }
        if (!define_ && nombre.texto != "GL_ES") // ese lo dice la versión
            resultado.avisos.emplace_back(nombre, "depende de si OpenGL define " + nombre.texto +
                                                      ": sigo como si no");
        return esta;
    }

    bool cumple(const std::string &orden, const Palabras &condicion) {
        if (orden != "if")
            return !condicion.empty() && definida(condicion[0]) == (orden == "ifdef");
        Palabras sinDefined;
        for (std::size_t i = 0; i < condicion.size(); ++i) {
            if (condicion[i].texto != "defined") {
                definida(condicion[i]);
                sinDefined.push_back(condicion[i]);
                continue;
            }
            const bool parentesis = i + 1 < condicion.size() && condicion[i + 1].texto == "(";
            i += parentesis ? 2 : 1;
            if (i >= condicion.size())
                throw NoSe(condicion.back(), "defined sin nombre");
            sinDefined.push_back(condicion[i]);
            sinDefined.back().clase = Palabra::Numero;
            sinDefined.back().texto = definida(condicion[i]) ? "1" : "0";
            i += parentesis;
        }
        const Palabras e = expande(sinDefined);
        long long valor = 0;
        if (e.empty() ||
            !evalua(
                e.data(), e.data() + e.size(), [](const auto &, long long &v) { return v = 0, true; }, valor))
            throw NoSe(condicion.empty() ? Palabra() : condicion[0], "no sé qué vale esta condición de #if");
        return valor != 0;
    }

    // Las palabras con sus macros expandidas, hasta que no queda ninguna. `pila`: lo que falta, al revés; una palabra
    // vacía señala dónde acaba lo que puso la macro que nombra su clase Fin.
    Palabras expande(const Palabras &entrada) {
        Palabras salida, pila(entrada.rbegin(), entrada.rend());
        while (!pila.empty()) {
            Palabra p = std::move(pila.back());
            pila.pop_back();
            if (p.clase == Palabra::Fin) {
                enCurso.erase(p.texto);
                continue;
            }
            expandidas += 1 + p.texto.size();
            if (expandidas > MAXIMO)
                throw NoSe(p, "las macros dan un texto demasiado largo");
            const auto m = macros.find(p.texto);
            if (esNumero(p.texto)) {
                p.texto = std::to_string(p.texto == "__LINE__"   ? p.linea
                                         : p.texto == "__FILE__" ? p.fichero
                                                                 : version);
                p.clase = Palabra::Numero;
            } else if (p.clase == Palabra::Nombre && m != macros.end() && enCurso.count(p.texto) == 0 &&
                       (!m->second.conArgumentos || sigueParentesis(pila))) {
                sustituye(p, m->second, pila);
                continue;
            }
            salida.push_back(std::move(p));
        }
        return salida;
    }

    static bool sigueParentesis(const Palabras &pila) {
        for (auto p = pila.rbegin(); p != pila.rend(); ++p)
            if (p->clase != Palabra::Fin)
                return p->texto == "(";
        return false;
    }

    // Los argumentos de una llamada a macro, que se quitan de la pila, cada uno ya expandido.
    std::vector<Palabras> argumentos(const Palabra &nombre, Palabras &pila) {
        std::vector<Palabras> todos(1);
        for (int hondo = 0; !pila.empty();) {
            Palabra p = std::move(pila.back());
            pila.pop_back();
            if (p.clase == Palabra::Fin) {
                enCurso.erase(p.texto);
                continue;
            }
            const bool abre = p.texto == "(", cierra = p.texto == ")";
            hondo += abre - cierra;
            if (hondo == 0)
                return todos;
            if (abre && hondo == 1)
                continue;
            if (p.texto == "," && hondo == 1)
                todos.emplace_back();
            else
                todos.back().push_back(std::move(p));
        }
        throw NoSe(nombre, "a la macro " + nombre.texto + " le falta su )");
    }

    void sustituye(const Palabra &uso, const Macro &macro, Palabras &pila) {
        std::vector<Palabras> dados, crudos;
        if (macro.conArgumentos) {
            dados = argumentos(uso, pila);
            if (macro.parametros.empty() && dados.size() == 1 && dados[0].empty())
                dados.clear();
            if (dados.size() != macro.parametros.size())
                throw NoSe(uso, "a la macro " + uso.texto + " le faltan o le sobran argumentos");
            if (++dentro > 100)
                throw NoSe(uso, "macros dentro de macros sin fin");
            crudos = dados;
            for (Palabras &a : dados)
                a = expande(a);
            --dentro;
        }
        Palabras nuevas;
        const auto pega = [&](std::size_t k) { // si esa es un ##: lo de sus lados va junto y sin expandir
            return k < macro.cuerpo.size() && macro.cuerpo[k].texto == "##";
        };
        for (std::size_t k = 0; k < macro.cuerpo.size(); ++k) {
            const Palabra &p = macro.cuerpo[k];
            if (pega(k))
                continue;
            std::size_t cual = 0;
            while (cual < dados.size() && macro.parametros[cual] != p.texto)
                ++cual;
            Palabras suyas = cual == dados.size()         ? Palabras{p}
                             : pega(k + 1) || pega(k - 1) ? crudos[cual]
                                                          : dados[cual];
            if (pega(k - 1) && !nuevas.empty() && !suyas.empty()) {
                nuevas.back().texto += suyas[0].texto;
                suyas.erase(suyas.begin());
            }
            nuevas.insert(nuevas.end(), suyas.begin(), suyas.end());
            if (nuevas.size() + pila.size() > MAXIMO)
                throw NoSe(uso, "las macros dan un texto demasiado largo");
        }
        for (Palabra &p : nuevas) {
            p.linea = uso.linea;
            p.fichero = uso.fichero;
        }
        if (!nuevas.empty())
            nuevas[0].blanco = uso.blanco;
        Palabra fin;
        fin.texto = uso.texto;
        pila.push_back(fin);
        enCurso.insert(uso.texto);
        pila.insert(pila.end(), nuevas.rbegin(), nuevas.rend());
    }
};

// Enteros de C, sin nada que desborde ni divida por cero: lo que no se sabe calcular lanza.
class Calculadora {
public:
    Calculadora(const Palabra *desde, const Palabra *hasta,
                const std::function<bool(const std::string &, long long &)> &c)
        : p(desde), fin(hasta), conoce(c) {
    }
    long long todo() {
        const long long v = binaria(0);
        if (p != fin)
            throw NoSe(*p, "");
        return v;
    }

private:
    const Palabra *p, *fin;
    const std::function<bool(const std::string &, long long &)> &conoce;
    int hondo = 0;

    long long binaria(int minima) {
        if (++hondo > 100)
            throw NoSe(Palabra(), "");
        long long a = unaria();
        while (p != fin && prioridad(p->texto) > minima) {
            const std::string op = (p++)->texto;
            a = opera(a, op, binaria(prioridad(op)));
        }
        --hondo;
        return a;
    }
    long long unaria() {
        if (p == fin || ++hondo > 100)
            throw NoSe(Palabra(), "");
        const Palabra &q = *p++;
        long long v = 0;
        if (q.texto == "(") {
            v = binaria(0);
            if (p == fin || (p++)->texto != ")")
                throw NoSe(q, "");
        } else if (q.texto == "-" || q.texto == "+" || q.texto == "!" || q.texto == "~") {
            v = unaria();
            v = q.texto == "-" ? -v : q.texto == "!" ? !v : q.texto == "~" ? ~v : v;
        } else if (q.clase == Palabra::Numero) {
            char *cola = nullptr;
            errno = 0;
            v = std::strtoll(q.texto.c_str(), &cola, 0);
            if (errno != 0 || v > 0x7fffffff || (*cola != '\0' && *cola != 'u' && *cola != 'U'))
                throw NoSe(q, "");
        } else if (q.clase != Palabra::Nombre || !conoce(q.texto, v)) {
            throw NoSe(q, "");
        }
        --hondo;
        return v;
    }
    static long long opera(long long a, const std::string &op, long long b) {
        const bool cabe = std::llabs(a) < (1LL << 31) && std::llabs(b) < (1LL << 31);
        if (!cabe || ((op == "/" || op == "%") && b == 0) ||
            ((op == "<<" || op == ">>") && (a < 0 || b < 0 || b > 31)))
            throw NoSe(Palabra(), "");
        switch (op[0]) {
        case '|': return op == "||" ? a || b : a | b;
        case '&': return op == "&&" ? a && b : a & b;
        case '^': return a ^ b;
        case '=': return a == b;
        case '!': return a != b;
        case '<': return op == "<<" ? a << b : op == "<=" ? a <= b : a < b;
        case '>': return op == ">>" ? a >> b : op == ">=" ? a >= b : a > b;
        case '+': return a + b;
        case '-': return a - b;
        case '*': return a * b;
        case '/': return a / b;
        default: return a % b;
        }
    }
};

} // namespace

int prioridad(const std::string &signo) {
    static const std::map<std::string, int> PRIORIDAD = {
        {"||", 1}, {"^^", 2}, {"&&", 3}, {"|", 4},  {"^", 5},  {"&", 6},  {"==", 7},
        {"!=", 7}, {"<", 8},  {">", 8},  {"<=", 8}, {">=", 8}, {"<<", 9}, {">>", 9},
        {"+", 10}, {"-", 10}, {"*", 11}, {"/", 11}, {"%", 11}};
    const auto suya = PRIORIDAD.find(signo);
    return suya == PRIORIDAD.end() ? 0 : suya->second;
}

Preprocesado preprocesa(const std::string &fuente, const Define &define) {
    return Preprocesador(define).hace(fuente);
}

std::string texto(const Palabra *desde, const Palabra *hasta) {
    std::string s;
    for (const Palabra *p = desde; p != hasta; ++p)
        s += (p != desde && p->blanco ? " " : "") + p->texto;
    return s;
}

bool evalua(const Palabra *desde, const Palabra *hasta,
            const std::function<bool(const std::string &nombre, long long &valor)> &conoce,
            long long &resultado) {
    try {
        resultado = Calculadora(desde, hasta, conoce).todo();
        return true;
    } catch (const NoSe &) {
        return false;
    }
}

} // namespace explica
