#include "reescritor.h"
#include <utility>

namespace explica {

std::string Reescritor::sentencia() {
    const Hondo aqui(hondo, ahora());
    return intenta([this] { return conocida(); });
}

std::string Reescritor::conocida() {
    static const std::map<std::string, std::string (Reescritor::*)()> ORDENES = {
        {"{", &Reescritor::bloque},        {"if", &Reescritor::si},        {"for", &Reescritor::para},
        {"while", &Reescritor::mientras},  {"do", &Reescritor::haz},       {"switch", &Reescritor::elige},
        {"case", &Reescritor::caso},       {"default", &Reescritor::caso}, {"return", &Reescritor::regresa},
        {"discard", &Reescritor::descarta}};
    const auto orden = ORDENES.find(ahora().texto);
    return orden == ORDENES.end() ? simple() : (this->*orden->second)();
}

std::string Reescritor::simple() {
    const std::size_t desde = i;
    if (toma(";"))
        return ";\n";
    if (es("break") || es("continue") || es("precision")) {
        while (!es(";"))
            nombreNuevo();
        return copia(desde, ++i) + "\n";
    }
    std::string s, despues;
    admite = true;
    if (empiezaDeclaracion()) {
        s = declaracion(cabeza(), despues);
    } else {
        arriba = true;
        s = expresion().texto;
    }
    exige(";");
    admite = arriba = false;
    return s + " ;\n" + despues + std::exchange(pendientes, "");
}

std::string Reescritor::bloque() {
    std::string s = "{\n";
    exige("{");
    abre();
    while (!es("}"))
        s += sentencia();
    cierra();
    exige("}");
    return s + "}\n";
}

// Lo que gobierna un if o un bucle, siempre entre llaves: donde había una sentencia puede haber varias.
std::string Reescritor::cuerpo() {
    if (es("{"))
        return bloque();
    abre();
    const std::string s = sentencia();
    cierra();
    return "{\n" + s + "}\n";
}

std::string Reescritor::condicion(Clase clase) {
    std::string antes, valor;
    Palabra donde = ahora();
    std::string nombre;
    if (empiezaDeclaracion()) { // while (bool b = …)
        const Cabeza c = cabeza();
        const std::size_t variable = nombreNuevo();
        exige("=");
        valor = asignacion().texto;
        antes = c.texto + " " + p[variable].texto + " = ";
        nombre = p[variable].texto;
        declara(variable, c.tipo);
    } else if (es(";")) {
        valor = "true";
        nombre = "for (;;)";
    } else {
        const Expresion e = expresion();
        valor = "( " + e.texto + " )";
        nombre = comoEsta(e);
    }
    valor = envuelve(clase, donde, nombre, {"bool", nullptr, 0}, valor);
    const bool acotada = clase == Clase::Vuelta && apariciones["discard"];
    return antes + (acotada ? "explica_sigue ( " + valor + " )" : valor);
}

std::string Reescritor::si() {
    std::string s;
    while (toma("if")) { // los else if, seguidos, que pueden ser muchos
        exige("(");
        s += "if ( " + condicion(Clase::Condicion) + " ) ";
        exige(")");
        s += cuerpo();
        if (!toma("else"))
            return s;
        s += "else ";
    }
    return s + cuerpo();
}

std::string Reescritor::para() {
    ++i;
    std::string s = "for ( ", despues;
    exige("(");
    abre();
    if (!es(";"))
        s += empiezaDeclaracion() ? declaracion(cabeza(), despues) : expresion().texto;
    exige(";");
    s += " ; " + condicion(Clase::Vuelta);
    exige(";");
    s += " ; ";
    if (!es(")"))
        s += expresion().texto;
    exige(")");
    s += " ) " + cuerpo();
    cierra();
    return s;
}

std::string Reescritor::mientras() {
    ++i;
    exige("(");
    abre();
    std::string s = "while ( " + condicion(Clase::Vuelta) + " ) ";
    exige(")");
    s += cuerpo();
    cierra();
    return s;
}

std::string Reescritor::haz() {
    ++i;
    std::string s = "do " + cuerpo();
    exige("while");
    exige("(");
    s += "while ( " + condicion(Clase::Vuelta) + " ) ;\n";
    exige(")");
    exige(";");
    return s;
}

std::string Reescritor::elige() {
    ++i;
    exige("(");
    std::string s = "switch ( " + expresion().texto + " ) ";
    exige(")");
    return s + bloque();
}

std::string Reescritor::caso() {
    const std::size_t desde = i++;
    if (!es(":"))
        constante();
    const std::string nombre = texto(&p[desde], &p[i]);
    exige(":");
    return copia(desde, i) + "\n" + sinValor(Clase::Caso, p[desde], nombre);
}

std::string Reescritor::descarta() {
    const Palabra &donde = p[i++];
    exige(";");
    return "{ " + sinValor(Clase::Descarta, donde, "discard") + "explica_descarta ( ) ; }\n";
}

std::string Reescritor::regresa() {
    const Palabra &donde = p[i++];
    if (toma(";"))
        return "{ " + alSalir(donde) + "return ; }\n";
    const Expresion e = expresion();
    exige(";");
    const std::string nombre = comoEsta(e);
    bool salen = false;
    for (const Parametro &uno : parametrosFuncion)
        salen |= uno.sale;
    if (devuelve.tipo.numerico() && !salen)
        return "return " +
               envuelve(Clase::Devuelve, donde, nombre, devuelve.tipo,
                        devuelve.tipo.base + " ( ( " + e.texto + " ) )") + // puede llevar comas
               " ;\n";
    const std::string suyo = partes(Clase::Devuelve, donde, nombre, devuelve.tipo, "explica_r");
    return "{ " + devuelve.texto + " explica_r = ( " + e.texto + " ) ;\n" + suyo + alSalir(donde) +
           "return explica_r ; }\n";
}

// Lo que dejan los parámetros de salida; el que aquí otra variable tapa no se puede leer.
std::string Reescritor::alSalir(const Palabra &donde) {
    std::string s;
    for (const Parametro &uno : parametrosFuncion) {
        if (!uno.sale || !uno.donde)
            continue;
        const std::string &nombre = p[uno.donde].texto;
        const Nombrado *que = busca(nombre);
        if (que && que->donde == uno.donde)
            s += partes(Clase::Sale, donde, nombre, uno.tipo, nombre);
        else
            avisa(donde, "otra variable tapa aquí al parámetro «" + nombre + "»");
    }
    return devuelve.tipo.base == "void" ? s + sinValor(Clase::Vuelve, donde, nombreFuncion.texto) : s;
}

} // namespace explica
