#include "reescritor.h"

namespace explica {

namespace {

bool asigna(const Palabra &p) {
    static const std::set<std::string> SIGNOS = {
        "=", "+=", "-=", "*=", "/=", "%=", "&=", "<<=", ">>=", "|=", "^="};
    return SIGNOS.count(p.texto) > 0;
}

} // namespace

Expresion Reescritor::expresion() {
    Expresion e = asignacion();
    while (toma(","))
        e.sigue(" , ", asignacion());
    return e;
}

Expresion Reescritor::asignacion() {
    const Hondo aqui(hondo, ahora());
    const bool toda = arriba;
    arriba = false;
    Expresion a = ternaria();
    if (asigna(ahora())) {
        const std::string op = p[i++].texto, lugar = a.texto;
        const Expresion b = asignacion();
        const bool repetible = !a.efectos;
        a.texto += " " + op + " " + b.texto;
        apuntaAsignacion(a, lugar, repetible, toda);
        a.hasta = b.hasta;
    }
    arriba = toda;
    return a;
}

// Lo asignado se apunta en el sitio, y lo que no es un número, al acabar la sentencia si es solo eso.
void Reescritor::apuntaAsignacion(Expresion &a, const std::string &lugar, bool repetible, bool toda) {
    const std::string nombre = comoEsta(a);
    if (a.tipo.numerico() && !congelado)
        a.texto = envuelve(Clase::Asigna, p[a.desde], nombre, a.tipo, a.texto);
    else if (repetible && toda && es(";") && !a.tipo.base.empty())
        pendientes += partes(Clase::Asigna, p[a.desde], nombre, a.tipo, lugar);
    else
        avisa(p[a.desde], "no sé apuntar aquí lo que vale «" + nombre + "»");
    a.efectos = true;
    a.lugar = false;
}

Expresion Reescritor::constante() {
    const bool estaba = congelado;
    congelado = true;
    Expresion e = asignacion();
    congelado = estaba;
    return e;
}

Expresion Reescritor::ternaria() {
    Expresion c = binaria(0);
    if (!es("?"))
        return c;
    if (!congelado)
        c.texto = envuelve(Clase::Condicion, p[c.desde], comoEsta(c), {"bool", nullptr, 0}, c.texto);
    ++i;
    c.sigue(" ? ", expresion());
    exige(":");
    c.sigue(" : ", asignacion());
    return c;
}

Expresion Reescritor::binaria(int minima) {
    Expresion a = unaria();
    while (prioridad(ahora().texto) > minima) {
        const std::string op = p[i++].texto;
        a.sigue(" " + op + " ", binaria(prioridad(op)));
    }
    return a;
}

Expresion Reescritor::unaria() {
    const Hondo aqui(hondo, ahora());
    const std::size_t desde = i;
    const bool cambia = es("++") || es("--");
    if (!cambia && !es("+") && !es("-") && !es("!") && !es("~"))
        return posfija();
    const std::string op = p[i++].texto;
    Expresion e = unaria();
    e.texto.insert(0, op + " ");
    if (cambia && e.tipo.numerico() && !congelado)
        e.texto = envuelve(Clase::Asigna, p[desde], comoEsta(e), e.tipo, e.texto);
    else if (cambia)
        avisa(p[desde], "no sé apuntar aquí lo que vale «" + comoEsta(e) + "»");
    e.efectos |= cambia;
    e.desde = desde;
    e.yaNoEsLugar();
    return e;
}

Expresion Reescritor::posfija() {
    Expresion e = primaria();
    for (;;) {
        if (toma("[")) {
            const Expresion cual = expresion();
            exige("]");
            e.texto += " [ " + cual.texto + " ]";
            e.efectos |= cual.efectos;
            e.tipo = elemento(e.tipo);
        } else if (es(".") && es("length", 1) && es("(", 2)) {
            e.texto += " . length ( )";
            i += 3;
            exige(")");
            e.yaNoEsLugar();
        } else if (toma(".")) {
            const std::string campo = p[nombreNuevo()].texto;
            e.texto += " . " + campo;
            e.tipo = miembro(e.tipo, campo);
        } else if (es("++") || es("--")) {
            trasPosfijo(e);
        } else {
            return e;
        }
        e.hasta = i;
    }
}

// v++ vale lo que valía v: la suma la hace una función que además apunta cuánto queda.
void Reescritor::trasPosfijo(Expresion &e) {
    const bool mas = p[i++].texto == "++";
    const std::string nombre = comoEsta(e);
    const int nota = e.lugar && e.tipo.numerico() && !e.efectos && !congelado
                         ? apunta(Clase::Asigna, p[e.desde], nombre, nombreDe(forma(e.tipo.base)))
                         : -1;
    if (nota >= 0) {
        varian.insert(r.notas.back().tipo);
        e.texto =
            (mas ? "explica_mas ( " : "explica_menos ( ") + std::to_string(nota) + " , " + e.texto + " )";
    } else {
        avisa(p[e.desde], "no sé apuntar aquí lo que vale «" + nombre + "»");
        e.texto += mas ? " ++" : " --";
    }
    e.efectos = true;
    e.yaNoEsLugar();
}

Expresion Reescritor::primaria() {
    const std::size_t desde = i;
    Expresion e;
    if (toma("(")) {
        e = expresion();
        exige(")");
        e.texto = "( " + e.texto + " )";
    } else if (ahora().clase == Palabra::Nombre && (esTipo(i) || es("(", 1))) {
        e = llamada(esTipo(i));
    } else if (ahora().clase == Palabra::Nombre || ahora().clase == Palabra::Numero) {
        const Nombrado *que = busca(ahora().texto);
        e.lugar = que != nullptr;
        if (que)
            e.tipo = que->tipo;
        e.texto = emite(p[i++]);
    } else {
        throw NoSe(ahora(), "no sé leer «" + ahora().texto + "» en una expresión");
    }
    e.desde = desde;
    e.hasta = i;
    return e;
}

// Una función o un constructor: vec3(…), float[2](…).
Expresion Reescritor::llamada(bool construye) {
    const Palabra &nombre = p[i++];
    Expresion e;
    e.texto = emite(nombre);
    Tipo tipo{nombre.texto, nullptr, 0};
    if (construye)
        e.texto += corchetes(tipo);
    exige("(");
    const std::vector<Expresion> dados = argumentos(nombre.texto);
    for (std::size_t k = 0; k < dados.size(); ++k) {
        e.texto += (k ? " , " : " ( ") + dados[k].texto;
        e.efectos |= dados[k].efectos;
    }
    e.texto += dados.empty() ? " ( )" : " )";
    e.efectos |= funciones.count(nombre.texto) > 0;
    if (tipo.cuantos != 0)
        e.tipo.cuantos = int(dados.size());
    const bool suya = funciones.count(nombre.texto) > 0;
    for (std::size_t k = 0; suya && k < dados.size(); ++k)
        if (dados[k].tipo.opaco())
            llegan[nombre.texto + "/" + std::to_string(k)].insert(texturaDe(dados[k]));
    if (apuntaLecturas && !congelado && !suya && !dados.empty() && dados[0].tipo.opaco() &&
        nombre.texto.compare(0, 7, "texture") == 0 && nombre.texto != "textureSize")
        apuntaLectura(nombre.texto, e, dados);
    return e;
}

// La textura que nombra: un uniform, «material.color», o un parámetro, «funcion/0». Vacío, si no se sabe.
std::string Reescritor::texturaDe(const Expresion &e) const {
    const std::string nombre = texto(&p[e.desde], &p[e.hasta]);
    const Nombrado *que = busca(p[e.desde].texto);
    for (std::size_t k = 0; k < parametrosFuncion.size(); ++k)
        if (que && parametrosFuncion[k].donde && parametrosFuncion[k].donde == que->donde)
            return e.hasta - e.desde == 1 ? nombreFuncion.texto + "/" + std::to_string(k) : "";
    return nombre.find('[') == nombre.npos ? nombre : "";
}

// Los uniforms que puede ser.
std::set<std::string> Reescritor::deDonde(const std::string &textura, int quedan) const {
    const auto suyas = llegan.find(textura);
    if (suyas == llegan.end() || !quedan)
        return {textura};
    std::set<std::string> todas;
    for (const std::string &otra : suyas->second)
        todas.merge(deDonde(otra, quedan - 1));
    return todas;
}

// Lo que se lee de una textura y, si es de las que se siguen, con qué se sabrá de qué texels sale.
void Reescritor::apuntaLectura(const std::string &funcion, Expresion &e,
                               const std::vector<Expresion> &dados) {
    const Palabra &donde = p[dados[0].desde];
    const std::string como = funcion + std::to_string(dados.size()),
                      escrito = texto(&p[dados[0].desde - 2], &p[i]);
    const std::string &base = dados[0].tipo.base;
    const int ejes = ejesDe(base);
    if (!ejes || (como != "texture2" && como != "texture3" && como != "textureLod3")) {
        const bool entera = base[0] != 's', deSombra = base.find("Shadow") != base.npos;
        const std::string tipo = deSombra ? "float" : entera ? base.substr(0, 1) + "vec4" : "vec4";
        e.texto = envuelve(Clase::SinSeguir, donde, escrito, {tipo, nullptr, 0}, e.texto);
        return;
    }
    const std::string derivada = "vec" + std::to_string(ejes), lugar = "vec" + std::to_string(ejes + 1);
    const int nota = apunta(Clase::Lee, donde, texturaDe(dados[0]), derivada);
    apunta(Clase::Lee, donde, escrito, derivada);
    apunta(Clase::Lee, donde, "", lugar);
    if (apunta(Clase::Lee, donde, "", "vec4") < 0)
        return;
    e.texto.replace(0, (funcion + " (").size(), "explica_" + como + " ( " + std::to_string(nota) + " ,");
    lecturas.insert({base, como});
}

std::vector<Expresion> Reescritor::argumentos(const std::string &funcion) {
    std::vector<Expresion> dados;
    const bool conConstante =
        funcion.find("Offset") != std::string::npos && funcion.compare(0, 3, "tex") == 0;
    if (es("void") && es(")", 1))
        ++i;
    while (!es(")")) {
        if (!dados.empty())
            exige(",");
        dados.push_back(conConstante && dados.size() >= 2 ? constante() : asignacion());
    }
    ++i;
    if (funcion == "modf" && dados.size() == 2 && funciones.count(funcion) == 0) {
        const Expresion &entera = dados[1];
        if (admite && entera.lugar && !entera.efectos && entera.tipo.numerico())
            pendientes += partes(Clase::Asigna, p[entera.desde], comoEsta(entera), entera.tipo, entera.texto);
        else
            avisa(p[entera.desde], "no sé apuntar aquí lo que modf deja en «" + comoEsta(entera) + "»");
    }
    return dados;
}

} // namespace explica
