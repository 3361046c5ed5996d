#include "preludio.h"
#include "tipos.h"

namespace explica {

namespace {

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

// Un vec4 por paso. mix con un bvec4 elige sin calcular: NaN, infinitos y -0 pasan como son.
std::string hueco(int salidas) {
    std::string s = R"(
void explica_hueco(int nota, vec4 v) {
    if (!explica_mudo) {
        int k = explica_paso - explica_desde;
        ++explica_paso;
        bool indices = explica_modo == 0;
        if (k >= 0 && k < (indices ? )" +
                    numero(4 * (salidas - 1)) + " : " + numero(salidas) + R"()) {
            bvec4 cual = indices ? equal(ivec4(0, 1, 2, 3), ivec4(k & 3)) : bvec4(true);
            if (indices) {
                v = vec4(float(nota));
                k = 1 + (k >> 2);
            }
)";
    for (int i = 0; i < salidas; ++i)
        s += "            if (k == " + numero(i) + ") explica_s" + numero(i) + " = mix(explica_s" +
             numero(i) + ", v, cual);\n";
    return s + "        }\n    }\n}\nvoid explica_n(int nota) { explica_hueco(nota, vec4(0.0)); }\n";
}

std::string empiezaYAcaba(int salidas) {
    std::string empieza = "void explica_empieza() {\n", acaba = "void explica_acaba() {\n";
    for (int i = 0; i < salidas; ++i) {
        empieza += "    explica_s" + numero(i) + " = vec4(explica_modo == 0 ? -1.0 : 0.0);\n";
        acaba += "    explica_" + numero(i) + " = explica_s" + numero(i) + ";\n";
    }
    return empieza + "}\n" + acaba +
           "    if (explica_modo == 0)\n        explica_0 = vec4(float(explica_paso & 65535), "
           "float(explica_paso >> 16), explica_mudo ? 1.0 : 0.0, 0.0);\n}\n";
}

// Un vec4 con los números de `v`, que son n.
std::string rellena(const std::string &v, int n) {
    static const char *const CEROS[] = {"", ", 0.0, 0.0, 0.0", ", 0.0, 0.0", ", 0.0", ""};
    return n == 4 ? v : "vec4(" + v + CEROS[n] + ")";
}

// Con qué se apunta un `v` de esa forma: las llamadas a explica_hueco.
std::string huecos(const Forma &f) {
    const auto llama = [](const std::string &v) { return "explica_hueco(n, " + v + "); "; };
    if (f.columnas > 1) {
        std::string s;
        for (int c = 0; c < f.columnas; ++c)
            s += llama(rellena("v[" + numero(c) + "]", f.filas));
        return s;
    }
    const std::string real = f.filas == 1 ? "float" : "vec" + numero(f.filas);
    if (f.escalar == "float" || f.escalar == "bool")
        return llama(rellena(f.escalar == "bool" ? real + "(v)" : "v", f.filas));
    const std::string u = f.escalar == "uint" ? "u" : "";
    const std::string baja = real + "(v & 65535" + u + ")", alta = real + "(v >> 16" + u + ")";
    if (f.filas <= 2)
        return llama("vec4(" + baja + ", " + alta + (f.filas == 1 ? ", 0.0, 0.0)" : ")"));
    return llama(rellena(baja, f.filas)) + llama(rellena(alta, f.filas));
}

} // namespace

std::string preludio(int salidas, bool fragmento, const std::set<std::string> &tipos,
                     const std::set<std::string> &varian) {
    std::string s = "#ifdef GL_ES\nprecision highp float;\nprecision highp int;\n#endif\n" +
                    declaraSalidas(salidas, fragmento) +
                    "uniform int explica_modo, explica_desde;\n"
                    "int explica_paso = 0, explica_vueltas = 0;\nbool explica_mudo = false;\n";
    for (int i = 0; i < salidas; ++i)
        s += "vec4 explica_s" + numero(i) + ";\n";
    s += hueco(salidas) + empiezaYAcaba(salidas) +
         "bool explica_sigue(bool v) { return v && (!explica_mudo || ++explica_vueltas < 65536); }\n";
    for (const std::string &t : tipos)
        s += t + " explica_v(int n, " + t + " v) { " + huecos(forma(t)) + "return v; }\n";
    for (const std::string &t : varian)
        for (const bool mas : {true, false})
            s += t + (mas ? " explica_mas" : " explica_menos") + "(int n, inout " + t + " x) { " + t +
                 " v = x" + (mas ? "++" : "--") + "; explica_v(n, x); return v; }\n";
    return s;
}

} // namespace explica
