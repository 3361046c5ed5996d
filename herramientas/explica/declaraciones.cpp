#include "reescritor.h"

namespace explica {

bool Reescritor::esTipo(std::size_t donde) const {
    if (p[donde].clase != Palabra::Nombre)
        return false;
    const Nombrado *que = busca(p[donde].texto);
    return que ? que->esTipo : esDeGlsl(p[donde].texto);
}

bool Reescritor::empiezaDeclaracion() const {
    static const std::set<std::string> CALIFICADORES = {
        "const",         "in",       "out",       "inout",   "uniform",   "flat",  "smooth",
        "noperspective", "centroid", "invariant", "varying", "attribute", "highp", "mediump",
        "lowp",          "layout",   "struct"};
    if (CALIFICADORES.count(ahora().texto))
        return true;
    if (!esTipo(i))
        return false;
    return p[es("[", 1) ? cierre(i + 1) + 1 : i + 1].clase == Palabra::Nombre;
}

void Reescritor::calificador(Cabeza &c) {
    const std::string &q = ahora().texto;
    c.constante |= q == "const";
    c.entra |= q == "in" || q == "inout" || q == "varying" || q == "attribute";
    c.sale |= q == "out" || q == "inout";
    c.uniforme |= q == "uniform";
    const std::size_t desde = i++;
    if (q == "layout")
        i = cierre(i) + 1;
    c.calificadores += copia(desde, i);
}

Cabeza Reescritor::cabeza() {
    Cabeza c;
    while (ahora().clase == Palabra::Nombre && !esTipo(i) && !es("struct") && empiezaDeclaracion())
        calificador(c);
    if (es("struct")) {
        c.texto = defineEstructura(c.tipo);
    } else if (esTipo(i)) {
        const Nombrado *que = busca(ahora().texto);
        c.tipo = que ? que->tipo : Tipo{ahora().texto, nullptr, 0};
        c.texto = p[i++].texto;
    } else {
        c.sinTipo = true; // invariant x; o el nombre de un bloque
    }
    c.texto += corchetes(c.tipo);
    return c;
}

bool Reescritor::conoce(std::size_t desde, std::size_t hasta, long long &valor) const {
    const auto deNombre = [this](const std::string &nombre, long long &suyo) {
        const Nombrado *que = busca(nombre);
        suyo = que ? que->valor : 0;
        return que && que->conocido;
    };
    return desde < hasta && evalua(&p[desde], &p[hasta], deNombre, valor); // const int n; no es nada
}

std::string Reescritor::corchetes(Tipo &tipo) {
    if (!es("["))
        return "";
    const std::size_t desde = i, hasta = cierre(i);
    if (tipo.cuantos != 0)
        throw NoSe(ahora(), "no sé de arrays de arrays");
    long long n = 0;
    const bool sabe = conoce(desde + 1, hasta, n) && n > 0 && n < 100000;
    tipo.cuantos = sabe ? int(n) : -1;
    i = hasta + 1;
    return " " + copia(desde, i);
}

std::string Reescritor::defineEstructura(Tipo &tipo) {
    const std::size_t desde = i++;
    std::size_t nombre = 0;
    if (!es("{"))
        nombre = nombreNuevo();
    auto campos = std::make_shared<Estructura>();
    exige("{");
    while (!toma("}")) {
        const Cabeza c = cabeza();
        if (c.sinTipo)
            throw NoSe(ahora(), "no sé qué es «" + ahora().texto + "» en una struct");
        do {
            Campo campo{p[nombreNuevo()].texto, c.tipo};
            corchetes(campo.tipo);
            campos->push_back(campo);
        } while (toma(","));
        exige(";");
    }
    tipo = {nombre ? p[nombre].texto : "struct", campos, 0};
    if (nombre)
        declara(nombre, tipo, true);
    return copia(desde, i);
}

// Lo que sigue al tipo, hasta su ; sin él. En `despues`, lo que se apunta tras la sentencia.
std::string Reescritor::declaracion(const Cabeza &c, std::string &despues) {
    std::string s = c.calificadores + c.texto;
    if (es(";"))
        return s;
    do {
        const std::size_t nombre = nombreNuevo();
        Tipo tipo = c.tipo;
        s += " " + emite(p[nombre]) + corchetes(tipo);
        const std::size_t desde = i + 1;
        if (toma("="))
            s += " = " + inicial(c, nombre, tipo, despues);
        declara(nombre, tipo);
        if (c.constante && (tipo.base == "int" || tipo.base == "uint") && tipo.cuantos == 0) {
            Nombrado &n = ambitos.back()[p[nombre].texto];
            n.conocido = conoce(desde, i, n.valor);
        }
        s += es(",") ? " ," : "";
    } while (toma(","));
    return s;
}

std::string Reescritor::inicial(const Cabeza &c, std::size_t nombre, Tipo &tipo, std::string &despues) {
    const Palabra &donde = p[nombre];
    const bool global = ambitos.size() == 1;
    if (!c.constante && !global && tipo.numerico())
        return envuelve(Clase::Declara, donde, donde.texto, tipo,
                        tipo.base + " ( " + asignacion().texto + " )");
    const Expresion e = c.constante || global ? constante() : asignacion();
    if (tipo.cuantos < 0)
        tipo.cuantos = e.tipo.cuantos;
    if (global)
        alEmpezar += partes(Clase::Global, donde, donde.texto, tipo, donde.texto);
    else if (admite && (c.constante || es(";")))
        despues += partes(Clase::Declara, donde, donde.texto, tipo, donde.texto);
    else
        avisa(donde, "no sé apuntar aquí lo que vale «" + donde.texto + "»");
    return e.texto;
}

std::string Reescritor::global() {
    const std::string s = intenta([this] {
        if (toma(";"))
            return std::string(";");
        const std::size_t desde = i;
        if (toma("precision")) {
            while (!es(";"))
                nombreNuevo();
            return copia(desde, ++i);
        }
        if (!empiezaDeclaracion() && !esTipo(i))
            throw NoSe(ahora(), "no sé qué declara «" + ahora().texto + "»");
        const Cabeza c = cabeza();
        if (c.sinTipo && es("{", 1))
            return bloqueUniforme(c);
        if (!c.sinTipo && ahora().clase == Palabra::Nombre && es("(", 1))
            return definicion(c);
        return globales(c);
    });
    nombreFuncion = {};
    return s;
}

std::string Reescritor::globales(const Cabeza &c) {
    std::string nada, s;
    if (c.sinTipo && toma(";")) // layout(std140) uniform;
        return c.calificadores + ";";
    if (fragmento && ahora().texto.compare(0, 3, "gl_") == 0) { // ya se conoce
        const std::size_t desde = i;
        while (ahora().clase != Palabra::Fin && !es(";"))
            ++i;
        exige(";");
        return c.calificadores + c.texto + " " + copia(desde, i);
    }
    if (c.sinTipo) { // invariant a, b;
        do {
            const std::string &nombre = p[nombreNuevo()].texto;
            if (daba.count(nombre) == 0)
                s += c.calificadores + nombre + " ; ";
        } while (toma(","));
        exige(";");
        return s;
    }
    const std::size_t desde = i;
    Cabeza limpia = c;
    if (c.sale && fragmento)
        limpia.calificadores.clear();
    s = declaracion(limpia, nada);
    exige(";");
    for (std::size_t k = desde; (c.entra || c.sale) && k < i; ++k) {
        const auto n = ambitos[0].find(p[k].texto);
        if (n == ambitos[0].end() || n->second.donde != k)
            continue;
        if (c.sale && fragmento)
            daba.insert(p[k].texto);
        if (c.sale)
            alAcabar += partes(Clase::Salida, p[k], p[k].texto, n->second.tipo, p[k].texto);
        else if (apariciones[p[k].texto] > 1)
            alEmpezar += partes(Clase::Entrada, p[k], p[k].texto, n->second.tipo, p[k].texto);
    }
    return s + " ;";
}

std::string Reescritor::bloqueUniforme(const Cabeza &c) {
    const std::size_t desde = i++;
    ++i; // {
    const std::size_t primero = i;
    Estructura campos;
    ambitos.emplace_back(); // sus miembros, si el bloque tiene nombre, no son de nadie más
    while (!toma("}")) {
        const Cabeza cual = cabeza();
        std::string nada;
        declaracion(cual, nada);
        exige(";");
    }
    const auto miembros = ambitos.back();
    ambitos.pop_back();
    auto estructura = std::make_shared<Estructura>();
    for (std::size_t k = primero; k < i; ++k) {
        const auto n = miembros.find(p[k].texto);
        if (n != miembros.end() && n->second.donde == k)
            estructura->push_back({n->first, n->second.tipo});
    }
    if (ahora().clase == Palabra::Nombre) {
        const std::size_t nombre = i++;
        Tipo tipo{"", estructura, 0};
        corchetes(tipo);
        declara(nombre, tipo);
    } else {
        ambitos[0].insert(miembros.begin(), miembros.end());
    }
    exige(";");
    return c.calificadores + copia(desde, i);
}

std::string Reescritor::parametros() {
    parametrosFuncion.clear();
    std::string s;
    exige("(");
    if (es("void") && es(")", 1))
        ++i;
    while (!toma(")")) {
        if (!s.empty())
            exige(",");
        const Cabeza c = cabeza();
        if (c.sinTipo)
            throw NoSe(ahora(), "no sé qué tipo es «" + ahora().texto + "»");
        Parametro uno{0, c.tipo, !c.sale || c.entra, c.sale};
        s += (s.empty() ? " " : ", ") + c.calificadores + c.texto;
        if (ahora().clase == Palabra::Nombre) {
            uno.donde = i;
            s += " " + emite(p[i++]);
            s += corchetes(uno.tipo);
            declara(uno.donde, uno.tipo);
        }
        parametrosFuncion.push_back(uno);
    }
    return "(" + s + " )";
}

std::string Reescritor::definicion(const Cabeza &c) {
    devuelve = c;
    nombreFuncion = p[i++];
    funciones.insert(nombreFuncion.texto);
    abre();
    std::string s = c.calificadores + c.texto + " " +
                    (nombreFuncion.texto == "main" ? "explica_principal" : nombreFuncion.texto) + " " +
                    parametros();
    if (toma(";")) {
        cierra();
        return s + " ;";
    }
    exige("{");
    s += " {\n" + sinValor(Clase::Entra, nombreFuncion, nombreFuncion.texto);
    for (const Parametro &uno : parametrosFuncion)
        if (uno.donde && uno.entra)
            s += partes(Clase::Argumento, p[uno.donde], p[uno.donde].texto, uno.tipo, p[uno.donde].texto);
    abre();
    while (!es("}"))
        s += sentencia();
    if (c.tipo.base == "void")
        s += alSalir(p[i]);
    cierra();
    cierra();
    exige("}");
    return s + "}";
}

// Las variables de OpenGL que el shader lee.
void Reescritor::entradasDelSistema() {
    static const struct {
        const char *nombre, *tipo;
        bool fragmento, entrada;
    } TODAS[] = {{"gl_FragCoord", "vec4", true, true},   {"gl_FrontFacing", "bool", true, true},
                 {"gl_PointCoord", "vec2", true, true},  {"gl_VertexID", "int", false, true},
                 {"gl_InstanceID", "int", false, true},  {"gl_FragColor", "vec4", true, false},
                 {"gl_FragDepth", "float", true, false}, {"gl_Position", "vec4", false, false},
                 {"gl_PointSize", "float", false, false}};
    for (const auto &v : TODAS) {
        if (v.fragmento != fragmento)
            continue;
        const Tipo tipo{v.tipo, nullptr, 0};
        ambitos[0][v.nombre].tipo = tipo;
        if (!apariciones[v.nombre])
            continue;
        Palabra donde;
        donde.texto = v.nombre;
        for (std::size_t k = p.size(); k-- > 0;) // la primera vez que aparece
            if (p[k].texto == v.nombre)
                donde = p[k];
        (v.entrada ? alEmpezar : alAcabar) +=
            partes(v.entrada ? Clase::Entrada : Clase::Salida, donde, v.nombre, tipo, emite(donde));
    }
    ambitos[0][fragmento ? "gl_FragData" : "gl_ClipDistance"].tipo = {fragmento ? "vec4" : "float", nullptr,
                                                                      8};
}

} // namespace explica
