#include "enviado.h"
#include "cuadro.h"
#include "nombres.h"
#include "pila.h"
#include <algorithm>
#include <map>
#include <regex>
#include <set>

#define DE(HAZ, n)                                                                                           \
    HAZ(glUniform##n##f, n)                                                                                  \
    HAZ(glUniform##n##i, n)                                                                                  \
    HAZ(glUniform##n##ui, n)                                                                                 \
    HAZ(glUniform##n##fv, n)                                                                                 \
    HAZ(glUniform##n##iv, n)                                                                                 \
    HAZ(glUniform##n##uiv, n)
#define UNIFORMS(HAZ)                                                                                        \
    DE(HAZ, 1)                                                                                               \
    DE(HAZ, 2)                                                                                               \
    DE(HAZ, 3)                                                                                               \
    DE(HAZ, 4)                                                                                               \
    HAZ(glUniformMatrix2fv, 4)                                                                               \
    HAZ(glUniformMatrix3fv, 9)                                                                               \
    HAZ(glUniformMatrix4fv, 16)                                                                              \
    HAZ(glUniformMatrix2x3fv, 6)                                                                             \
    HAZ(glUniformMatrix3x2fv, 6)                                                                             \
    HAZ(glUniformMatrix2x4fv, 8)                                                                             \
    HAZ(glUniformMatrix4x2fv, 8)                                                                             \
    HAZ(glUniformMatrix3x4fv, 12)                                                                            \
    HAZ(glUniformMatrix4x3fv, 12)
#define DECLARA_UNIFORM(funcion, numeros) DECLARA(funcion)
UNIFORMS(DECLARA_UNIFORM)
DECLARA(glGetUniformLocation)
DECLARA(glBindAttribLocation)
DECLARA(glLinkProgram)
DECLARA(glCreateProgram)

namespace explica {
namespace {

// Una llamada a glUniform*, que se puede repetir en otro sitio.
struct Envio {
    std::string forma; // de glUniform3fv, «3f»; de glUniformMatrix2x3fv, «Matrix2x3f»
    std::function<void(GLint donde)> repite;
};

struct Programa {
    std::map<std::string, GLuint> porAtar, atados; // lo segundo, desde que se enlaza
    std::map<GLint, std::string> enSitio; // lo que no está, en un sitio que le damos, por debajo de -1
    std::map<GLint, std::set<std::string>> sitiosDados; // con las formas en que se ha dado
    std::map<GLint, int> pilas;                         // desde dónde, la última vez
    std::vector<std::pair<std::string, Envio>> dados;   // por su orden
};
std::map<GLuint, Programa> programas;

template<class HazEnvio>
void apunta(GLint donde, const std::string &forma, const HazEnvio &hazEnvio) {
    Programa &p = programas[GLuint(entero(GL_CURRENT_PROGRAM))];
    const auto sitio = p.enSitio.find(donde);
    if (sitio == p.enSitio.end())
        return;
    p.sitiosDados[donde].insert(forma);
    p.pilas[donde] = pilaActual();
    if (EN_WEB && donde >= 0 && !seExplica())
        return; // al explicar se dibuja otra vez, y se envía otra vez
    const auto es = [&](const auto &dado) { return dado.first == sitio->second; };
    p.dados.erase(std::remove_if(p.dados.begin(), p.dados.end(), es), p.dados.end());
    p.dados.push_back({sitio->second, hazEnvio()});
}

template<class... Numeros>
std::function<void(GLint)> copia(int, void (*envia)(GLint, Numeros...), Numeros... numeros) {
    return [=](GLint donde) { envia(donde, numeros...); };
}

template<class Numero>
std::function<void(GLint)> copia(int cada, void (*envia)(GLint, GLsizei, const Numero *), GLsizei n,
                                 const Numero *v) {
    const std::vector<Numero> suyos(v, v + std::max(n, 0) * cada);
    return [=](GLint donde) { envia(donde, n, suyos.data()); };
}

std::function<void(GLint)> copia(int cada, void (*envia)(GLint, GLsizei, GLboolean, const GLfloat *),
                                 GLsizei n, GLboolean traspone, const GLfloat *v) {
    const std::vector<GLfloat> suyos(v, v + std::max(n, 0) * cada);
    return [=](GLint donde) { envia(donde, n, traspone, suyos.data()); };
}

// Cada una de las que dan valor a un uniform, con sus parámetros.
template<auto funcion>
struct Uniform;

template<class... Parametros, void (*envia)(GLint, Parametros...)>
struct Uniform<envia> {
    static inline std::string forma;
    static inline int cada = 0; // los números de cada elemento

    static void da(GLint donde, Parametros... parametros) {
        if (!esNuestro())
            apunta(donde, forma, [&] { return Envio{forma, copia(cada, envia, parametros...)}; });
        envia(std::max(donde, -1), parametros...);
    }
};

template<auto funcion>
Direccion tapaUniform(const std::string &nombre, int cada) {
    Uniform<funcion>::forma = nombre.substr(9, nombre.find_last_not_of('v') - 8);
    Uniform<funcion>::cada = cada;
    return reinterpret_cast<Direccion>(Uniform<funcion>::da);
}

GLint sitioDe(GLuint programa, const GLchar *nombre) {
    static std::map<std::pair<GLuint, std::string>, GLint> ausentes;
    GLint donde = DE_VERDAD(glGetUniformLocation)(programa, nombre);
    if (esNuestro())
        return donde;
    if (donde < 0)
        donde = ausentes.insert({{programa, nombre}, -2 - GLint(ausentes.size())}).first->second;
    programas[programa].enSitio[donde] = nombre;
    return donde;
}

void ata(GLuint programa, GLuint donde, const GLchar *nombre) {
    programas[programa].porAtar[nombre] = donde;
    DE_VERDAD(glBindAttribLocation)(programa, donde, nombre);
}

void enlaza(GLuint programa) {
    DE_VERDAD(glLinkProgram)(programa);
    Programa nuevo; // los uniforms vuelven a valer lo que al principio
    nuevo.porAtar = nuevo.atados = programas[programa].porAtar;
    programas[programa] = nuevo;
}

GLuint crea() {
    const GLuint programa = DE_VERDAD(glCreateProgram)();
    programas.erase(programa); // el número puede ser el de otro que ya no está
    return programa;
}

// Si a un uniform de ese tipo se le da valor con glUniform«forma».
bool admite(GLenum tipo, const std::string &forma) {
    const std::string t = tipoDe(tipo), cuantos = std::to_string(componentesDe(tipo));
    if (t[0] == 'm')
        return forma == "Matrix" + t.substr(3) + "f";
    if (t[0] == 'b')
        return forma.compare(0, 1, cuantos) == 0;
    const bool sinSigno = t == "uint" || t.compare(0, 4, "uvec") == 0;
    return forma == cuantos + (!esEntero(tipo) ? "f" : sinSigno ? "ui" : "i");
}

// «pesos», de «pesos[2]».
std::string sinIndice(const std::string &nombre) {
    return nombre.back() == ']' ? nombre.substr(0, nombre.rfind('[')) : nombre;
}

// Da a un uniform que en el original no está lo que se le ha enviado. Falso si no se sabe: si no se le ha enviado nada
// y es 0, es que el programa está a medias.
bool daAusente(const Programa &programa, const Variable &uniform, GLuint otro) {
    bool dado = false;
    for (const auto &[nombre, envio] : programa.dados)
        if (sinIndice(nombre) == sinIndice(uniform.nombre) && admite(uniform.tipo, envio.forma)) {
            dado = true;
            if (const GLint donde = glGetUniformLocation(otro, nombre.c_str()); donde >= 0)
                envio.repite(donde);
        }
    const std::vector<double> vale = valorDe(otro, uniform); // si nadie se lo da, lo que diga el shader
    return dado || esSampler(uniform.tipo) ||
           std::any_of(vale.begin(), vale.end(), [](double x) { return x != 0; });
}

// De un atributo: si lo dice el programa o su shader, aunque nada lo use.
bool seSabeDonde(GLuint programa, const std::string &atributo) {
    const std::regex conSitio("\\blayout\\s*\\([^)]*\\)\\s*in\\s+\\w+\\s+" + atributo + "\\b");
    const std::vector<Fuente> fuentes = fuentesDe(programa);
    return programas[programa].atados.count(atributo) ||
           std::any_of(fuentes.begin(), fuentes.end(),
                       [&](const Fuente &f) { return std::regex_search(f.texto, conSitio); });
}

// Los sampler que el original no tiene y están en la unidad de otro de otra clase: con los dos, OpenGL no dibuja. Da el
// nombre de alguno.
std::string aparta(GLuint otro, const std::vector<Variable> &todas, const std::set<std::string> &suyas) {
    std::map<GLint, GLenum> clases;
    std::string apartado;
    GLint libre = entero(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
    for (const bool delOriginal : {true, false})
        for (const Variable &v : todas) {
            if (!esSampler(v.tipo) || delOriginal != (suyas.count(v.nombre) > 0))
                continue;
            const GLint unidad = GLint(valorDe(otro, v)[0]);
            if (clases.insert({unidad, v.tipo}).first->second == v.tipo)
                continue;
            glUniform1i(v.donde, --libre);
            apartado = v.nombre;
        }
    return apartado;
}

} // namespace

Direccion tapaEnvio(const std::string &nombre) {
#define TAPA(funcion, por)                                                                                   \
    if (nombre == #funcion)                                                                                  \
        return reinterpret_cast<Direccion>(por);
#define UNIFORM(funcion, numeros)                                                                            \
    if (nombre == #funcion)                                                                                  \
        return tapaUniform<DE_VERDAD(funcion)>(nombre, numeros);
    TAPA(glGetUniformLocation, sitioDe)
    TAPA(glBindAttribLocation, ata)
    TAPA(glLinkProgram, enlaza)
    TAPA(glCreateProgram, crea)
    UNIFORMS(UNIFORM)
    return nullptr;
}

bool seHaDado(GLuint programa, GLint donde) {
    return programas[programa].sitiosDados.count(donde) > 0;
}

int pilaDelEnvio(GLuint programa, GLint donde) {
    const auto suya = programas[programa].pilas.find(donde);
    return suya == programas[programa].pilas.end() ? -1 : suya->second;
}

std::string malDado(GLuint programa, const Variable &uniform) {
    const auto dado = programas[programa].sitiosDados.find(uniform.donde);
    if (dado != programas[programa].sitiosDados.end())
        for (const std::string &forma : dado->second)
            if (!admite(uniform.tipo, forma))
                return "glUniform" + forma;
    return "";
}

bool ataComo(GLuint original, GLuint programa) {
    std::set<std::string> suyos;
    for (const Variable &v : atributosDe(original)) {
        glBindAttribLocation(programa, GLuint(v.donde), v.nombre.c_str());
        suyos.insert(v.nombre);
    }
    for (const auto &[nombre, donde] : programas[original].atados)
        if (!suyos.count(nombre))
            glBindAttribLocation(programa, donde, nombre.c_str());
    GLuint libre = GLuint(entero(GL_MAX_VERTEX_ATTRIBS));
    bool hay = false;
    for (const Variable &v : atributosDe(programa)) {
        if (suyos.count(v.nombre) || seSabeDonde(original, v.nombre))
            continue;
        libre -= tipoDe(v.tipo)[0] == 'm' ? 4 : 1;
        hay = hay || GLuint(v.donde) != libre;
        glBindAttribLocation(programa, libre, v.nombre.c_str());
    }
    return hay;
}

Desconocidas daLoEnviado(GLuint original, GLuint otro) {
    std::set<std::string> suyas;
    for (const auto &variables : {uniformsDe(original), atributosDe(original)})
        for (const Variable &v : variables)
            suyas.insert(v.nombre);
    const std::vector<Variable> uniforms = uniformsDe(otro);
    Desconocidas d;
    for (const Variable &v : uniforms)
        if (v.nombre.compare(0, 8, "explica_") && !suyas.count(v.nombre) &&
            !daAusente(programas[original], v, otro))
            d.uniforms.push_back(v);
    for (const Variable &v : atributosDe(otro))
        if (!suyas.count(v.nombre) && !seSabeDonde(original, v.nombre))
            d.atributos.push_back(v);
    for (const Bloque &bloque : bloquesDe(otro))
        if (glGetUniformBlockIndex(original, bloque.nombre.c_str()) == GL_INVALID_INDEX)
            d.otra = bloque.nombre;
    if (const std::string apartado = aparta(otro, uniforms, suyas); !apartado.empty())
        d.otra = apartado;
    return d;
}

std::string Desconocidas::motivo() const {
    std::string nombres;
    const auto anade = [&](const std::string &n) { nombres += (nombres.empty() ? "«" : "», «") + n; };
    for (const auto &variables : {uniforms, atributos})
        for (const Variable &v : variables)
            anade(v.nombre);
    if (!otra.empty())
        anade(otra);
    return "depende de lo que el programa aún no usa (" + nombres + "»), y de ello OpenGL no guarda el valor";
}

void Desconocidas::pon(bool otro) const {
    for (const Variable &v : uniforms)
        daOtroValor(v);
    for (const Variable &v : atributos)
        glVertexAttrib4f(GLuint(v.donde), otro ? 0.3f : 0, otro ? 0.7f : 0, otro ? 0.45f : 0,
                         otro ? 0.8f : 1);
}

} // namespace explica
