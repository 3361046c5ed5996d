#include "preludio.h"
#include "glsl.h"
#include "tipos.h"

namespace explica {

namespace {

const std::string LETRAS = "xyzw";

std::string numero(int n) {
    return std::to_string(n);
}

std::string declaraSalidas(int salidas, bool fragmento) {
    std::string s;
    if (!fragmento) {
        for (int i = 0; i < salidas; ++i)
            s += "flat out vec4 explica_" + numero(i) + ";\n";
        return s;
    }
    s += "#if defined(GL_ES) || defined(GL_ARB_explicit_attrib_location)\n";
    for (int i = 0; i < salidas; ++i)
        s += "layout(location = " + numero(i) + ") out vec4 explica_" + numero(i) + ";\n";
    s += "#else\nout vec4 explica_0";
    for (int i = 1; i < salidas; ++i)
        s += ", explica_" + numero(i);
    return s + ";\n#endif\n";
}

// Sin bifurcar ni calcular: elegir cuesta una instrucción por número y deja pasar NaN, infinitos y -0 como son.
std::string elige(const std::string &cual, const std::string &que, const std::string &cuando) {
    return cual + " = " + cuando + " ? " + que + " : " + cual + "; ";
}

// Lo que va en cada paso de un `v` de esa forma, que son 1, 2 o más, y cuántos números tiene cada uno.
struct Parte {
    std::string valor;
    int numeros;
};
std::vector<Parte> partes(const Forma &f) {
    const std::string real = f.filas == 1 ? "float" : "vec" + numero(f.filas);
    if (f.columnas > 1) {
        std::vector<Parte> columnas;
        for (int c = 0; c < f.columnas; ++c)
            columnas.push_back({"v[" + numero(c) + "]", f.filas});
        return columnas;
    }
    if (f.escalar == "float" || f.escalar == "bool")
        return {{f.escalar == "bool" ? real + "(v)" : "v", f.filas}};
    const std::string u = f.escalar == "uint" ? "u" : "";
    const std::string baja = real + "(v & 65535" + u + ")", alta = real + "(v >> 16" + u + ")";
    if (f.filas > 2)
        return {{baja, f.filas}, {alta, f.filas}};
    return {{"vec" + numero(2 * f.filas) + "(" + baja + ", " + alta + ")", 2 * f.filas}};
}

// Apunta esas partes y pasa a lo siguiente.
std::string apunta(const std::vector<Parte> &cuales, int huecos) {
    std::string s = "int k = explica_paso - explica_desde; ";
    for (int p = 0; p < int(cuales.size()); ++p)
        for (int h = 0; h < huecos; ++h) {
            const std::string cuando = "k == " + numero(h - p);
            s += elige(std::string("explica_notas.") + LETRAS[std::size_t(h)], "float(n)", cuando);
            if (cuales[std::size_t(p)].numeros > 0)
                s += elige("explica_s" + numero(h) + "." +
                               LETRAS.substr(0, std::size_t(cuales[std::size_t(p)].numeros)),
                           cuales[std::size_t(p)].valor, cuando);
        }
    return s + "explica_paso += " + numero(int(cuales.size())) + "; ";
}

const char *const FIJO = R"(
void explica_descarta() {
    if (explica_dados < 0) {
        explica_dados = explica_paso;
        explica_paso = -1073741824;
    }
}
bool explica_sigue(bool v) { return v && (explica_dados < 0 || ++explica_vueltas < 65536); }
)";

std::string acaba(int huecos) {
    std::string s =
        "void explica_acaba() {\n    int dados = explica_dados < 0 ? explica_paso : explica_dados;\n"
        "    explica_0 = explica_notas;\n    explica_1 = vec4(float(dados & 65535), float(dados >> 16), "
        "explica_dados < 0 ? 0.0 : 1.0, 0.0);\n";
    for (int h = 0; h < huecos; ++h)
        s += "    explica_" + numero(h + 2) + " = explica_s" + numero(h) + ";\n";
    return s + "}\n";
}

} // namespace

int ejesDe(const std::string &sampler) {
    return sampler == "sampler2D" ? 2 : sampler == "sampler3D" || sampler == "samplerCube" ? 3 : 0;
}

std::string preludio(int salidas, bool fragmento, const std::set<std::string> &tipos,
                     const std::set<std::string> &varian, const std::set<Leida> &lecturas) {
    const int huecos = huecosDe(salidas);
    std::string s =
        "#ifdef GL_ES\nprecision highp float;\nprecision highp int;\n#endif\n" +
        declaraSalidas(huecos + 2, fragmento) +
        "uniform int explica_desde;\nint explica_paso = 0, explica_vueltas = 0, explica_dados = -1;\n"
        "vec4 explica_notas = vec4(-1.0);\n";
    for (int h = 0; h < huecos; ++h)
        s += "vec4 explica_s" + numero(h) + " = vec4(0.0);\n";
    s += FIJO + acaba(huecos) + "void explica_n(int n) { " + apunta({{"", 0}}, huecos) + "}\n";
    for (const std::string &t : tipos)
        s += t + " explica_v(int n, " + t + " v) { " + apunta(partes(forma(t)), huecos) + "return v; }\n";
    for (const std::string &t : varian)
        for (const bool mas : {true, false})
            s += t + (mas ? " explica_mas" : " explica_menos") + "(int n, inout " + t + " x) { " + t +
                 " v = x" + (mas ? "++" : "--") + "; explica_v(n, x); return v; }\n";
    for (const auto &[sampler, lectura] : lecturas) {
        const bool conMas = lectura != "texture2", nivel = lectura == "textureLod3";
        const std::string vec = "vec" + numero(ejesDe(sampler)), mas = conMas ? ", mas" : "",
                          lugar = "vec" + numero(ejesDe(sampler) + 1);
        const auto derivada = [&](const char *de) { // si dice el nivel, no cuenta
            return nivel ? vec + "(0.0)" : de + std::string("(c)");
        };
        s += "vec4 explica_" + lectura + "(int n, " + sampler + " s, " + vec + " c" +
             (conMas ? ", float mas" : "") + ") { explica_v(n, " + derivada("dFdx") + "); explica_v(n + 1, " +
             derivada("dFdy") + "); explica_v(n + 2, " + lugar + "(c, " + (conMas ? "mas" : "0.0") +
             ")); return explica_v(n + 3, " + lectura.substr(0, lectura.size() - 1) + "(s, c" + mas +
             ")); }\n";
    }
    return s;
}

} // namespace explica
