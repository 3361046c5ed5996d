#include "preludio.h"
#include "reescritor.h"
#include <algorithm>
#include <utility>

namespace explica {

namespace {
const std::size_t NOTAS = 4096, LETRAS = 80, LUGAR = 300;
}

Reescritor::Reescritor(Preprocesado entrada, int cuantasSalidas, bool esFragmento, bool conLecturas)
    : p(std::move(entrada.palabras)), cabeceraDelShader(std::move(entrada.cabecera)), salidas(cuantasSalidas),
      fragmento(esFragmento), apuntaLecturas(conLecturas && esFragmento) {
    for (const NoSe &e : entrada.avisos)
        r.sinSeguir.push_back({e.linea, e.fichero, e.what()});
    for (const Palabra &palabra : p)
        ++apariciones[palabra.texto];
}

Reescrito Reescritor::hace() {
    const auto propio = std::find_if(p.begin(), p.end(),
                                     [](const Palabra &q) { return q.texto.compare(0, 8, "explica_") == 0; });
    if (propio != p.end())
        throw NoSe(*propio, "los nombres que empiezan por explica_ los pone esto");
    if (apariciones["main"] == 0)
        throw NoSe(p.back(), "no hay main");
    abre();
    entradasDelSistema();
    std::string cuerpoDelShader;
    while (ahora().clase != Palabra::Fin)
        cuerpoDelShader += global() + "\n";
    for (std::size_t k = 0; k < r.notas.size(); ++k) {
        std::string &textura = r.notas[k].nombre; // de las cuatro notas de una lectura, la primera
        if (r.notas[k].clase != Clase::Lee)
            continue;
        if (textura.find('/') != textura.npos) {
            const std::set<std::string> texturas = deDonde(textura, 20);
            textura = texturas.size() == 1 ? *texturas.begin() : "";
        }
        k += 3;
    }
    const bool enES = cabeceraDelShader.find(" es\n") != std::string::npos;
    r.fuente = cabeceraDelShader;
    if (fragmento && !enES)
        r.fuente += "#ifndef GL_ES\n#extension GL_ARB_explicit_attrib_location : enable\n#endif\n";
    r.fuente += preludio(salidas, fragmento, tipos, varian, lecturas);
    if (fragmento && apariciones["gl_FragColor"])
        r.fuente += "vec4 explica_FragColor;\n";
    if (fragmento && apariciones["gl_FragData"])
        r.fuente += "vec4 explica_FragData [ 8 ];\n";
    r.fuente += cuerpoDelShader + "void main() {\n" + alEmpezar + "explica_principal();\n" + alAcabar +
                "explica_acaba();\n}\n";
    return std::move(r);
}

bool Reescritor::es(const char *que, std::size_t mas) const {
    return i + mas < p.size() && p[i + mas].clase != Palabra::Fin && p[i + mas].texto == que;
}

bool Reescritor::toma(const char *que) {
    const bool esta = es(que);
    i += esta;
    return esta;
}

void Reescritor::exige(const char *que) {
    if (!toma(que))
        throw NoSe(ahora(), "esperaba «" + std::string(que) + "» y hay «" + ahora().texto + "»");
}

std::size_t Reescritor::nombreNuevo() {
    if (ahora().clase != Palabra::Nombre)
        throw NoSe(ahora(), "esperaba un nombre y hay «" + ahora().texto + "»");
    return i++;
}

std::string Reescritor::emite(const Palabra &palabra) const {
    if (fragmento && (palabra.texto == "gl_FragColor" || palabra.texto == "gl_FragData"))
        return "explica_" + palabra.texto.substr(3);
    return palabra.texto == "discard" ? "explica_descarta ( )" : palabra.texto;
}

std::string Reescritor::copia(std::size_t desde, std::size_t hasta) const {
    std::string s;
    for (; desde < hasta; ++desde)
        s += (p[desde].texto == "main" && p[desde + 1].texto == "(" ? "explica_principal" : emite(p[desde])) +
             " ";
    return s;
}

std::size_t Reescritor::cierre(std::size_t desde) const {
    int abiertos = 0;
    for (std::size_t k = desde; p[k].clase != Palabra::Fin; ++k) {
        const std::string &t = p[k].texto;
        abiertos += t == "(" || t == "[" || t == "{";
        abiertos -= t == ")" || t == "]" || t == "}";
        if (abiertos <= 0)
            return k;
    }
    throw NoSe(p[desde], "a «" + p[desde].texto + "» le falta su cierre");
}

// Hasta su ; o su }, sin entenderla. Al menos, una palabra.
std::string Reescritor::copiaSentencia() {
    const std::size_t desde = i;
    const bool hasta_punto = es("do") || es("struct") || es("uniform");
    int abiertos = 0;
    while (ahora().clase != Palabra::Fin) {
        const std::string &t = p[i].texto;
        if (t == "}" && abiertos == 0)
            break;
        abiertos += t == "(" || t == "[" || t == "{";
        abiertos -= t == ")" || t == "]" || t == "}";
        ++i;
        if (abiertos == 0 && (t == ";" || (t == "}" && !hasta_punto && !es("else"))))
            break;
    }
    if (i == desde) { // una } de más: que la vea quien abrió, si alguien abrió
        if (ambitos.size() > 1)
            throw NoSe(ahora(), "no sé seguir desde aquí");
        ++i;
    }
    return copia(desde, i);
}

int Reescritor::apunta(Clase clase, const Palabra &donde, const std::string &nombre,
                       const std::string &tipo) {
    if (r.notas.size() >= NOTAS) {
        if (!std::exchange(lleno, true))
            avisa(donde, "desde aquí no apunto más: son más de " + std::to_string(NOTAS) + " sitios");
        return -1;
    }
    r.notas.push_back(
        {clase, donde.linea, donde.fichero, nombre.substr(0, LETRAS), tipo, nombreFuncion.texto});
    if (tipo != "void")
        tipos.insert(tipo);
    return int(r.notas.size()) - 1;
}

std::string Reescritor::sinValor(Clase clase, const Palabra &donde, const std::string &nombre) {
    const int nota = apunta(clase, donde, nombre, "void");
    return nota < 0 ? "" : "explica_n ( " + std::to_string(nota) + " ) ;\n";
}

std::string Reescritor::envuelve(Clase clase, const Palabra &donde, const std::string &nombre,
                                 const Tipo &tipo, const std::string &valor) {
    const int nota = apunta(clase, donde, nombre, nombreDe(forma(tipo.base)));
    return nota < 0 ? valor : "explica_v ( " + std::to_string(nota) + " , " + valor + " )";
}

// Sentencias que apuntan lo que vale ya `valor`, por partes si no es un número.
std::string Reescritor::partes(Clase clase, const Palabra &donde, const std::string &nombre, const Tipo &tipo,
                               const std::string &valor) {
    const std::vector<Campo> nombres = hojas(nombre, tipo), valores = hojas(valor, tipo);
    if ((nombres.empty() && !tipo.opaco()) || valor.size() > LUGAR)
        avisa(donde,
              "no sé apuntar «" + nombre.substr(0, LETRAS) + "» entero: tiene demasiado, o no sé cuánto");
    std::string s;
    for (std::size_t k = 0; k < nombres.size() && valor.size() <= LUGAR; ++k)
        s += envuelve(clase, donde, nombres[k].nombre, nombres[k].tipo, valores[k].nombre) + " ;\n";
    return s;
}

void Reescritor::avisa(const Palabra &donde, const std::string &motivo) {
    r.sinSeguir.push_back({donde.linea, donde.fichero, motivo});
}

std::string Reescritor::comoEsta(const Expresion &e) const {
    return texto(&p[e.desde], &p[e.hasta]).substr(0, LETRAS);
}

const Nombrado *Reescritor::busca(const std::string &nombre) const {
    for (auto ambito = ambitos.rbegin(); ambito != ambitos.rend(); ++ambito) {
        const auto k = ambito->find(nombre);
        if (k != ambito->end())
            return &k->second;
    }
    return nullptr;
}

void Reescritor::abre() {
    ambitos.emplace_back();
}

void Reescritor::cierra() {
    ambitos.pop_back();
}

void Reescritor::declara(std::size_t donde, const Tipo &tipo, bool esTipo) {
    ambitos.back()[p[donde].texto] = {tipo, esTipo, donde, false, 0};
}

} // namespace explica
