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
DECLARA(glUseProgram)

namespace explica {
namespace {

// Una llamada a glUniform*, que se puede repetir en otro sitio.
struct Envio {
    std::string forma; // de glUniform3fv, «3f»; de glUniformMatrix2x3fv, «Matrix2x3f»
    std::function<void(GLint donde)> repite;
};

// Lo que se ha preguntado por un nombre.
struct Nombre {
    bool esta = false;
    int preguntas = 0, seguidas = 0; // seguidas: las que van justo delante de un envío a donde no hay nada
};

struct Programa {
    std::map<std::string, GLuint> porAtar, atados; // lo segundo, desde que se enlaza
    std::map<std::string, Nombre> nombres;
    std::map<GLint, std::string> enSitio;
    std::map<GLint, std::set<std::string>> sitiosDados; // con las formas en que se ha dado
    std::map<GLint, int> pilas;                         // desde dónde, la última vez
    std::vector<std::pair<std::string, Envio>> dados;   // por su orden
    std::map<std::string, Envio> perdidos;              // por su forma, los que no se sabe a qué nombre van
};
std::map<GLuint, Programa> programas;
std::pair<GLuint, std::string> preguntado; // por lo último, si no está y aún no se ha hecho nada más

// A un sitio en que no hay nada no se sabe a qué nombre se envía: al que se acaba de preguntar o, si se preguntó hace
// tiempo, a alguno de los que no se enviaron entonces.
template<class HazEnvio>
void apunta(GLint donde, const std::string &forma, const HazEnvio &hazEnvio) {
    const GLuint actual = GLuint(entero(GL_CURRENT_PROGRAM));
    Programa &p = programas[actual];
    const auto [deCual, nombre] = preguntado;
    preguntado = {};
    const auto sitio = p.enSitio.find(donde);
    if (donde >= 0 && sitio == p.enSitio.end())
        return;
    if (donde >= 0) {
        p.sitiosDados[donde].insert(forma);
        p.pilas[donde] = pilaActual();
    }
    if (EN_WEB && donde >= 0 && !seExplica())
        return; // al explicar se dibuja otra vez, y se envía otra vez
    const std::string &suyo = donde >= 0 ? sitio->second : nombre;
    const Envio envio = hazEnvio();
    if (suyo.empty()) {
        p.perdidos[envio.forma] = envio;
        return;
    }
    if (donde < 0)
        ++programas[deCual].nombres[suyo].seguidas;
    if (donde < 0 && deCual != actual)
        return;
    const auto es = [&](const auto &dado) { return dado.first == suyo; };
    p.dados.erase(std::remove_if(p.dados.begin(), p.dados.end(), es), p.dados.end());
    p.dados.push_back({suyo, envio});
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
        envia(donde, parametros...);
    }
};

template<auto funcion>
Direccion tapaUniform(const std::string &nombre, int cada) {
    Uniform<funcion>::forma = nombre.substr(9, nombre.find_last_not_of('v') - 8);
    Uniform<funcion>::cada = cada;
    return reinterpret_cast<Direccion>(Uniform<funcion>::da);
}

GLint sitioDe(GLuint programa, const GLchar *nombre) {
    const GLint donde = DE_VERDAD(glGetUniformLocation)(programa, nombre);
    if (esNuestro())
        return donde;
    Programa &p = programas[programa];
    Nombre &suyo = p.nombres[nombre];
    ++suyo.preguntas;
    suyo.esta = donde >= 0;
    preguntado = {suyo.esta ? 0 : programa, suyo.esta ? "" : nombre};
    if (suyo.esta)
        p.enSitio[donde] = nombre;
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

void usa(GLuint programa) {
    if (!esNuestro())
        preguntado = {};
    DE_VERDAD(glUseProgram)(programa);
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

// Da a un uniform que en el original no está lo que se le ha enviado. Falso si no se sabe.
class Ausente {
    const Programa &programa;
    const std::map<std::string, GLenum> &tipos; // de los que en el otro están
    const Variable &uniform;

    bool esEl(const std::string &nombre) const {
        return sinIndice(nombre) == sinIndice(uniform.nombre);
    }
    // Si lo enviado quizá no era para él, sino para otro por el que se preguntó antes y a que no se envió nada
    // entonces.
    bool hayRivales() const {
        return std::any_of(programa.nombres.begin(), programa.nombres.end(), [&](const auto &otro) {
            const auto suyo = tipos.find(otro.first);
            return !otro.second.esta && otro.second.seguidas < otro.second.preguntas && !esEl(otro.first) &&
                   (suyo == tipos.end() || suyo->second == uniform.tipo);
        });
    }

public:
    Ausente(const Programa &p, const std::map<std::string, GLenum> &suyos, const Variable &v)
        : programa(p), tipos(suyos), uniform(v) {
    }
    bool da(GLuint otro) const {
        std::vector<std::pair<std::string, Envio>> suyos;
        int preguntas = 0, seguidas = 0; // por lo que no está: de un array puede estar una parte
        for (const auto &[nombre, n] : programa.nombres)
            if (esEl(nombre) && !n.esta)
                preguntas += n.preguntas, seguidas += n.seguidas;
        for (const auto &dado : programa.dados)
            if (esEl(dado.first) && admite(uniform.tipo, dado.second.forma))
                suyos.push_back(dado);
        for (const auto &[forma, perdido] : programa.perdidos)
            if (seguidas < preguntas && admite(uniform.tipo, forma))
                suyos.push_back({sinIndice(uniform.nombre), perdido});
        for (const auto &[nombre, envio] : suyos)
            if (const GLint donde = glGetUniformLocation(otro, nombre.c_str()); donde >= 0)
                envio.repite(donde);
        if (!suyos.empty())
            return (seguidas == preguntas && seguidas != 1) || !hayRivales();
        const std::vector<double> vale = valorDe(otro, uniform); // si nadie se lo da, lo que diga el shader
        return !preguntas && (esSampler(uniform.tipo) ||
                              std::any_of(vale.begin(), vale.end(), [](double x) { return x != 0; }));
    }
};

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
    TAPA(glUseProgram, usa)
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
    const Programa &p = programas[original];
    std::set<std::string> suyas;
    for (const auto &variables : {uniformsDe(original), atributosDe(original)})
        for (const Variable &v : variables)
            suyas.insert(v.nombre);
    const std::vector<Variable> uniforms = uniformsDe(otro);
    std::map<std::string, GLenum> tipos;
    for (const Variable &v : uniforms)
        tipos[v.nombre] = v.tipo;
    Desconocidas d;
    for (const Variable &v : uniforms) {
        const bool nuestro = v.nombre.compare(0, 8, "explica_") == 0;
        if (nuestro || suyas.count(v.nombre) || Ausente(p, tipos, v).da(otro))
            continue;
        if (esSampler(v.tipo))
            d.otra = v.nombre;
        else
            d.uniforms.push_back(v);
    }
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
