#include "sombreado.h"
#include "enviado.h"
#include "glsl.h"
#include "texturas.h"
#include <algorithm>
#include <functional>
#include <map>
#include <regex>

namespace explica {
namespace {

const int SALIDAS = 6;           // las que salen cada vez
const long PASOS = 4000;         // los que se apuntan, como mucho
const std::size_t LECTURAS = 64; // de texturas, que se explican

using Salida = std::array<float, 4 * SALIDAS>; // de un vértice, o del fragmento
using Salidas = std::vector<Salida>;

// Un programa con uno de los dos shaders reescrito.
struct Reescribible {
    GLuint programa = 0;
    Reescrito reescrito;
    Desconocidas desconocidas;
    std::string motivo; // por qué no se puede
};

// Si OpenGL define ese nombre en un shader que empieza así: se le pregunta una vez.
bool define(const std::string &cabecera, const std::string &nombre) {
    static std::map<std::string, bool> sabidos;
    const std::string fuente =
        cabecera + "#ifndef " + nombre + "\n#error no\n#endif\nvoid main() { gl_Position = vec4(0.0); }\n";
    const auto [sabido, nuevo] = sabidos.insert({fuente, false});
    if (nuevo) {
        const GLuint shader = compila(GL_VERTEX_SHADER, sabido->first);
        sabido->second = shader != 0;
        glDeleteShader(shader);
    }
    return sabido->second;
}

Reescribible reescribeEn(GLuint original, Etapa etapa) {
    const GLenum cual = etapa == Etapa::Vertices ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER;
    Reescribible r;
    std::vector<GLuint> shaders;
    GLuint nuevo = 0;
    for (const Fuente &f : fuentesDe(original)) {
        if (f.tipo != cual) {
            shaders.push_back(f.shader);
            continue;
        }
        r.reescrito = reescribe(f.texto, SALIDAS, etapa, define, !EN_WEB);
        nuevo = compila(cual, r.reescrito.fuente);
        r.motivo = nuevo ? "" : "no sé seguir este shader";
        shaders.push_back(nuevo);
    }
    if (!nuevo && r.motivo.empty())
        r.motivo = "el programa ya no guarda el texto de su shader";
    if (r.motivo.empty()) {
        std::vector<std::string> salidas;
        for (int i = 0; i < SALIDAS; ++i)
            salidas.push_back("explica_" + std::to_string(i));
        r.programa = enlazaComo(original, shaders, [&](GLuint programa) {
            std::vector<const GLchar *> nombres;
            for (int i = 0; i < SALIDAS; ++i) {
                nombres.push_back(salidas[std::size_t(i)].c_str());
                if (!EN_WEB && etapa == Etapa::Fragmento)
                    glBindFragDataLocation(programa, GLuint(i), nombres.back());
            }
            if (etapa == Etapa::Vertices)
                glTransformFeedbackVaryings(programa, SALIDAS, nombres.data(), GL_INTERLEAVED_ATTRIBS);
        });
        if (!r.programa)
            r.motivo = "el shader reescrito no enlaza";
        else
            r.desconocidas = copiaUniforms(original, r.programa);
        if (!r.desconocidas.otra.empty())
            r.motivo = r.desconocidas.motivo();
    }
    glDeleteShader(nuevo);
    return r;
}

// Lo que apunta el fragmento: se dibuja en varios framebuffers de float a la vez.
class Fragmento {
    const Sueltas &sueltas;
    int cual;
    Punto pixel;
    GLuint marco = 0, colores[SALIDAS] = {};

public:
    Fragmento(const Sueltas &s, int primitiva, const Lienzo &l, Punto p)
        : sueltas(s), cual(primitiva), pixel(p) {
        GLenum cuales[SALIDAS];
        glGenFramebuffers(1, &marco);
        glGenRenderbuffers(SALIDAS, colores);
        glBindFramebuffer(GL_FRAMEBUFFER, marco);
        for (int i = 0; i < SALIDAS; ++i) {
            cuales[i] = GLenum(GL_COLOR_ATTACHMENT0 + i);
            glBindRenderbuffer(GL_RENDERBUFFER, colores[i]);
            glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, l.ancho, l.alto);
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, cuales[i], GL_RENDERBUFFER, colores[i]);
        }
        glDrawBuffers(SALIDAS, cuales);
        soloPregunta(p);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glDisable(GL_BLEND);
    }
    ~Fragmento() {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glDeleteFramebuffers(1, &marco);
        glDeleteRenderbuffers(SALIDAS, colores);
    }
    Fragmento(const Fragmento &) = delete;
    Fragmento &operator=(const Fragmento &) = delete;

    Salidas operator()() const {
        Salidas salidas(1);
        glClearColor(-1, -1, -1, -1); // lo que queda si no lo cubre: ningún paso
        deVerdad().borra(GL_COLOR_BUFFER_BIT);
        sueltas.dibuja(cual, cual + 1);
        for (int i = 0; i < SALIDAS; ++i) {
            glReadBuffer(GLenum(GL_COLOR_ATTACHMENT0 + i));
            glReadPixels(pixel.x, pixel.y, 1, 1, GL_RGBA, GL_FLOAT, &salidas[0][std::size_t(4 * i)]);
        }
        return salidas;
    }
};

// Un valor apuntado.
struct Paso {
    const Nota *nota;
    std::vector<double> valor;
};

struct Traza {
    long pasos = 0;
    std::vector<Paso> apuntado;

    const Paso *hallado(Clase clase, const std::string &nombre) const {
        const auto es = [&](const Paso &p) { return p.nota->clase == clase && p.nota->nombre == nombre; };
        const auto donde = std::find_if(apuntado.rbegin(), apuntado.rend(), es);
        return donde == apuntado.rend() ? nullptr : &*donde;
    }
};

// Lo apuntado, juntando los pasos de un mismo valor: de cada paso, su nota (-1: no hay más) y sus cuatro números.
std::vector<Paso> enOrden(const std::vector<Nota> &notas, const std::vector<int> &cuales,
                          const std::vector<float> &numeros) {
    std::vector<Paso> pasos;
    for (std::size_t i = 0; i < cuales.size() && cuales[i] >= 0;) {
        const Nota &nota = notas.at(std::size_t(cuales[i]));
        const std::size_t ocupa = std::size_t(pasosDe(nota.tipo));
        if (i + ocupa > cuales.size())
            break; // ha quedado cortado
        pasos.push_back({&nota, valor(nota.tipo, &numeros[4 * i])});
        i += ocupa;
    }
    return pasos;
}

// La traza de cada vértice, o la del fragmento. `ejecuta` da lo que sale desde el paso que se haya pedido.
template<class Ejecuta>
std::vector<Traza> apuntadas(const Reescribible &r, const Ejecuta &ejecuta) {
    const int huecos = huecosDe(SALIDAS);
    std::vector<Traza> todas;
    std::vector<std::vector<int>> notas;
    std::vector<std::vector<float>> valores;
    long pasos = 1;
    glUseProgram(r.programa);
    for (int desde = 0; desde < pasos; desde += huecos) {
        glUniform1i(glGetUniformLocation(r.programa, "explica_desde"), desde);
        const Salidas salidas = ejecuta();
        todas.resize(salidas.size());
        notas.resize(salidas.size());
        valores.resize(salidas.size());
        for (std::size_t i = 0; i < salidas.size(); ++i) {
            const float *suyas = salidas[i].data();
            todas[i].pasos = std::max(std::lround(suyas[4]) + 65536 * std::lround(suyas[5]), 0l);
            pasos = std::min(std::max(pasos, todas[i].pasos), PASOS);
            for (int k = 0; k < huecos; ++k)
                notas[i].push_back(int(std::lround(suyas[k])));
            valores[i].insert(valores[i].end(), suyas + 8, suyas + 8 + 4 * huecos);
        }
    }
    for (std::size_t i = 0; i < todas.size(); ++i)
        todas[i].apuntado = enOrden(r.reescrito.notas, notas[i], valores[i]);
    return todas;
}

// Sin lo que depende de lo que no se sabe cuánto vale: lo que con otro valor no es lo mismo.
template<class Ejecuta>
std::vector<Traza> trazas(const Reescribible &r, const Ejecuta &ejecuta) {
    std::vector<Traza> todas = apuntadas(r, ejecuta);
    if (r.desconocidas.uniforms.empty() && r.desconocidas.atributos.empty())
        return todas;
    r.desconocidas.pon(true);
    const std::vector<Traza> otras = apuntadas(r, ejecuta);
    r.desconocidas.pon(false);
    const auto distinto = [](double a, double b) { return a != b && (a == a || b == b); };
    for (std::size_t i = 0; i < todas.size(); ++i) {
        std::vector<Paso> &pasos = todas[i].apuntado;
        const std::vector<Paso> &suyos = otras[i].apuntado;
        std::size_t k = 0;
        for (; k < std::min(pasos.size(), suyos.size()) && pasos[k].nota == suyos[k].nota; ++k)
            if (!std::equal(pasos[k].valor.begin(), pasos[k].valor.end(), suyos[k].valor.begin(),
                            std::not_fn(distinto)))
                pasos[k].valor.clear();
        pasos.resize(k); // se va por otro lado
    }
    return todas;
}

const char *nombreClase(Clase clase) {
    const char *const NOMBRES[] = {"entrada",  "global", "declara",  "asigna",    "condicion",
                                   "vuelta",   "caso",   "entra",    "argumento", "sale",
                                   "devuelve", "vuelve", "descarta", "salida"};
    return NOMBRES[int(clase)];
}

std::vector<Json> lineas(const Traza &traza) {
    std::vector<Json> lista;
    for (const Paso &p : traza.apuntado) {
        if (p.nota->clase >= Clase::Lee)
            continue; // va aparte
        lista.push_back({{"linea", p.nota->linea},
                         {"clase", nombreClase(p.nota->clase)},
                         {"nombre", p.nota->nombre},
                         {"tipo", p.nota->tipo},
                         {"funcion", p.nota->funcion},
                         {"valor", p.valor}});
    }
    return lista;
}

Json enJsonDe(const Reescribible &r, const Traza &traza) {
    std::vector<Json> sinSeguir;
    for (const Aviso &a : r.reescrito.sinSeguir)
        sinSeguir.push_back(Json().pon("linea", a.linea).pon("motivo", a.motivo));
    for (const Paso &p : traza.apuntado)
        if (p.valor.empty() && p.nota->tipo != "void")
            sinSeguir.push_back(Json().pon("linea", p.nota->linea).pon("motivo", r.desconocidas.motivo()));
    std::vector<int>
        apuntables; // las líneas en que puede pasar algo: las que no están entre las otras no se ejecutan
    for (const Nota &nota : r.reescrito.notas)
        if (!nota.funcion.empty() && nota.clase < Clase::Lee &&
            (apuntables.empty() || apuntables.back() != nota.linea))
            apuntables.push_back(nota.linea);
    return {{"pasos", traza.pasos},
            {"lineas", lineas(traza)},
            {"sinSeguir", sinSeguir},
            {"apuntables", apuntables},
            {"motivo", r.motivo}};
}

std::vector<Json> lecturasDe([[maybe_unused]] GLuint programa,
                             [[maybe_unused]] const std::vector<Paso> &pasos) {
    std::vector<Json> lista;
#ifndef __EMSCRIPTEN__ // ahí las texturas no se pueden leer así
    for (std::size_t i = 0; i < pasos.size() && lista.size() < LECTURAS; ++i) {
        const Nota &nota = *pasos[i].nota;
        if (nota.clase == Clase::SinSeguir)
            lista.push_back({{"linea", nota.linea},
                             {"escrito", nota.nombre},
                             {"valor", pasos[i].valor},
                             {"motivo", "no sé de qué texels sale: solo sigo texture y textureLod de un "
                                        "sampler2D, sampler3D o samplerCube"}});
        if (nota.clase != Clase::Lee || i + 3 >= pasos.size())
            continue;
        const auto valor = [&](std::size_t k) { return pasos[i + k].valor; };
        if (!valor(0).empty() && !valor(1).empty() && !valor(2).empty() && !valor(3).empty())
            lista.push_back(deLectura(programa, {nota.linea, nota.nombre, pasos[i + 1].nota->nombre, valor(0),
                                                 valor(1), valor(2), valor(3)}));
        i += 3;
    }
#endif
    return lista;
}

using Pesos = std::array<double, 3>;

void reparte(Pesos &pesos) {
    const double suma = pesos[0] + pesos[1] + pesos[2];
    for (double &p : pesos)
        p /= suma;
}

// Lo que pesa cada vértice en el centro del píxel, con perspectiva y sin ella. La combinación de los tres puntos que se
// proyecta ahí se halla sin dividir por w, que en un vértice de detrás de la cámara no es positiva.
std::array<Pesos, 2> pesosDe(const std::array<std::vector<double>, 3> &posiciones, Punto p) {
    const auto v = cuatro(GL_VIEWPORT);
    const double X = 2 * (p.x + 0.5 - v[0]) / v[2] - 1, Y = 2 * (p.y + 0.5 - v[1]) / v[3] - 1;
    std::array<std::array<double, 2>, 3> a{};
    for (std::size_t i = 0; i < 3; ++i)
        a[i] = {posiciones[i][0] - X * posiciones[i][3], posiciones[i][1] - Y * posiciones[i][3]};
    Pesos con{}, sin{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto &b = a[(i + 1) % 3], &c = a[(i + 2) % 3];
        con[i] = b[0] * c[1] - b[1] * c[0];
    }
    reparte(con);
    for (std::size_t i = 0; i < 3; ++i)
        sin[i] = con[i] * posiciones[i][3];
    reparte(sin);
    return {con, sin};
}

// Si en ese shader se declara así: «flat in vec3 color;».
bool seDeclara(const std::string &fuente, const std::string &como, const std::string &nombre) {
    return std::regex_search(
        fuente, std::regex("\\b" + como + "\\s+(\\w+\\s+)*in\\s+\\w+\\s[^;]*\\b" + nombre + "\\b"));
}

// Cada entrada del fragmento que dan los vértices: lo que sale de mezclarlos y lo que se ha apuntado.
std::vector<Json> interpola(const std::vector<Traza> &vertices, const Traza &fragmento,
                            const std::array<Pesos, 2> &pesosCon, const std::string &fuente) {
    const auto &[con, sin] = pesosCon;
    std::vector<Json> lista;
    for (const Paso &p : fragmento.apuntado) {
        std::vector<double> suma(p.valor.size());
        const bool mezclable = p.nota->tipo == "float" || p.nota->tipo.compare(0, 3, "vec") == 0;
        bool estan = p.nota->clase == Clase::Entrada && mezclable && !suma.empty();
        const bool plana = estan && seDeclara(fuente, "flat", p.nota->nombre); // la del último vértice
        const Pesos pesos = plana                                                         ? Pesos{0, 0, 1}
                            : estan && seDeclara(fuente, "noperspective", p.nota->nombre) ? sin
                                                                                          : con;
        for (std::size_t i = 0; i < 3 && estan; ++i) {
            const Paso *suyo = vertices[i].hallado(Clase::Salida, p.nota->nombre);
            estan = suyo && suyo->valor.size() == suma.size();
            for (std::size_t k = 0; k < suma.size() && estan; ++k)
                suma[k] += pesos[i] * suyo->valor[k];
        }
        if (estan)
            lista.push_back({{"nombre", p.nota->nombre}, {"interpolado", suma}, {"valor", p.valor}});
    }
    return lista;
}

} // namespace

Json sombrea(const Orden &orden, const Lienzo &l, Punto p, int primitiva) {
    const std::optional<Primitivas> primitivas = primitivasDe(orden);
    const GLuint programa = GLuint(entero(GL_CURRENT_PROGRAM));
    Json json;
    if (!primitivas || !programa || orden.instancias != 1 || primitiva < 0 ||
        primitiva >= primitivas->cuantas())
        return json;
    const Guardado guardado;
    const Sueltas s(*primitivas);
    const Reescribible deFragmento = reescribeEn(programa, Etapa::Fragmento),
                       deVertices = reescribeEn(programa, Etapa::Vertices);
    std::vector<Traza> vertices;
    if (deVertices.motivo.empty())
        vertices = trazas(deVertices, [&] { return s.recoge<Salida>(primitiva, primitiva + 1); });
    Traza fragmento;
    if (deFragmento.motivo.empty())
        fragmento = trazas(deFragmento, Fragmento(s, primitiva, l, p))[0];
    std::vector<Json> deCada;
    std::array<std::vector<double>, 3> posiciones;
    bool conPosicion = vertices.size() == 3;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const std::size_t indice = std::size_t(primitiva * s.primitivas.vertices) + i;
        deCada.push_back(enJsonDe(deVertices, vertices[i]).pon("indice", s.primitivas.indices[indice]));
        const Paso *posicion = vertices[i].hallado(Clase::Salida, "gl_Position");
        conPosicion = conPosicion && posicion && !posicion->valor.empty();
        if (conPosicion)
            posiciones[i] = posicion->valor;
    }
    json.pon("fragmento", enJsonDe(deFragmento, fragmento)).pon("vertices", deCada);
    // en el reescrito está la textura aunque lo leído no llegue a nada, multiplicado por 0
    json.pon("lecturas", lecturasDe(deFragmento.programa, fragmento.apuntado));
    if (conPosicion) {
        const auto pesos = pesosDe(posiciones, p);
        json.pon("pesos", pesos[0]).pon("pesosSinPerspectiva", pesos[1]);
        json.pon("entradas", interpola(vertices, fragmento, pesos, fuenteDe(programa, GL_FRAGMENT_SHADER)));
    }
    for (const GLuint hecho : {deFragmento.programa, deVertices.programa})
        glDeleteProgram(hecho);
    return json;
}

} // namespace explica
