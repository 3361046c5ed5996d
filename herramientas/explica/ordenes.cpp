#include "ordenes.h"
#include "nombres.h"
#include "programas.h"
#include <cstdint>
#include <map>

DECLARA(glBlitFramebuffer)

namespace explica {

namespace {

std::string texto(GLsizei numero) {
    return std::to_string(numero);
}
std::string texto(const void *indices) {
    return std::to_string(reinterpret_cast<std::intptr_t>(indices));
}
std::string texto(const std::string &palabra) {
    return palabra;
}

template<class... Parametros>
std::string llamada(const std::string &funcion, const Parametros &...parametros) {
    std::string dentro;
    ((dentro += (dentro.empty() ? "" : ", ") + texto(parametros)), ...);
    return funcion + "(" + dentro + ")";
}

// Con índices si `tipo` no es GL_NONE.
Orden dibuja(const std::string &como, GLenum modo, GLenum tipo, const std::vector<Tramo> &tramos,
             GLsizei instancias = 1) {
    Orden o{Orden::Que::Dibuja, como, {}};
    o.modo = modo, o.tipoIndice = tipo, o.tramos = tramos, o.instancias = instancias;
    return o;
}

#ifndef __EMSCRIPTEN__ // en la página nada las usa, y WebGL 2 no tiene la mitad
Orden instancias(const char *funcion, GLenum modo, GLint primero, GLsizei n, GLsizei veces) {
    return dibuja(llamada(funcion, nombreModo(modo), primero, n, veces), modo, GL_NONE, {{primero, n}},
                  veces);
}

// Las que tienen índices: `mas` son los parámetros que las distinguen.
template<class... Mas>
Orden conIndices(const char *funcion, GLenum modo, const Tramo &t, GLenum tipo, GLsizei veces, Mas... mas) {
    const std::string como =
        llamada(funcion, nombreModo(modo), t.vertices, nombreDe(tipo), t.indices, mas...);
    return dibuja(como, modo, tipo, {t}, veces);
}
Orden instanciasConIndices(const char *funcion, GLenum modo, GLsizei n, GLenum tipo, const void *desde,
                           GLsizei veces) {
    return conIndices(funcion, modo, {0, n, desde}, tipo, veces, veces);
}
Orden instanciasConBase(const char *funcion, GLenum modo, GLsizei n, GLenum tipo, const void *desde,
                        GLsizei veces, GLint base) {
    return conIndices(funcion, modo, {0, n, desde, base}, tipo, veces, veces, base);
}
Orden enTramo(const char *funcion, GLenum modo, GLuint, GLuint, GLsizei n, GLenum tipo, const void *desde) {
    return conIndices(funcion, modo, {0, n, desde}, tipo, 1);
}
Orden conBase(const char *funcion, GLenum modo, GLsizei n, GLenum tipo, const void *desde, GLint base) {
    return conIndices(funcion, modo, {0, n, desde, base}, tipo, 1, base);
}
Orden enTramoConBase(const char *funcion, GLenum modo, GLuint, GLuint, GLsizei n, GLenum tipo,
                     const void *desde, GLint base) {
    return conBase(funcion, modo, n, tipo, desde, base);
}

Orden varios(const char *funcion, GLenum modo, const GLint *primeros, const GLsizei *cuantos, GLsizei n) {
    std::vector<Tramo> tramos;
    for (GLsizei i = 0; i < n; ++i)
        tramos.push_back({primeros[i], cuantos[i]});
    return dibuja(llamada(funcion, nombreModo(modo), n), modo, GL_NONE, tramos);
}
Orden variosConBase(const char *funcion, GLenum modo, const GLsizei *cuantos, GLenum tipo,
                    const void *const *desde, GLsizei n, const GLint *bases) {
    std::vector<Tramo> tramos;
    for (GLsizei i = 0; i < n; ++i)
        tramos.push_back({0, cuantos[i], desde[i], bases ? bases[i] : 0});
    return dibuja(llamada(funcion, nombreModo(modo), nombreDe(tipo), n), modo, tipo, tramos);
}
Orden variosConIndices(const char *funcion, GLenum modo, const GLsizei *cuantos, GLenum tipo,
                       const void *const *desde, GLsizei n) {
    return variosConBase(funcion, modo, cuantos, tipo, desde, n, nullptr);
}

template<class... Valor>
Orden borra(const char *funcion, GLenum bufer, GLint cual, Valor...) {
    Orden o{Orden::Que::Borra, llamada(funcion, nombreDe(bufer), cual), {}};
    o.buferes = bufer == GL_COLOR     ? GL_COLOR_BUFFER_BIT
                : bufer == GL_DEPTH   ? GL_DEPTH_BUFFER_BIT
                : bufer == GL_STENCIL ? GL_STENCIL_BUFFER_BIT
                                      : GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
    return o;
}

#endif

Orden copia(const char *funcion, GLint x0, GLint y0, GLint x1, GLint y1, GLint u0, GLint v0, GLint u1,
            GLint v1, GLbitfield buferes, GLenum filtro) {
    const std::string cuales = nombreBuferes(buferes), como = nombreDe(filtro);
    Orden o{Orden::Que::Copia, llamada(funcion, x0, y0, x1, y1, u0, v0, u1, v1, cuales, como), {}};
    o.origen = {x0, y0, x1, y1}, o.destino = {u0, v0, u1, v1}, o.buferes = buferes;
    return o;
}

void (*llegaA)(const Orden &orden);

// Sin ellos Mesa los lee de donde no hay memoria.
bool faltanIndices(const Orden &o) {
    return o.tipoIndice != GL_NONE && entero(GL_VERTEX_ARRAY_BINDING) &&
           !entero(GL_ELEMENT_ARRAY_BUFFER_BINDING);
}

// Una función, por la que la cambia: `orden` dice lo que hace con esos parámetros.
template<auto funcion, auto orden>
struct Tapada;
template<class... Parametros, void (*funcion)(Parametros...), Orden (*orden)(const char *, Parametros...)>
struct Tapada<funcion, orden> {
    static inline const char *nombre = "";
    static void llama(Parametros... parametros) {
        Orden suya = orden(nombre, parametros...);
        suya.hazla = [=] {
            if (!faltanIndices(suya))
                funcion(parametros...);
        };
        llegaA(suya);
    }
};
template<auto funcion, auto orden>
Direccion tapada(const char *nombre) {
    Tapada<funcion, orden>::nombre = nombre;
    return reinterpret_cast<Direccion>(Tapada<funcion, orden>::llama);
}

} // namespace

Direccion tapaOrden(const std::string &nombre, void (*llega)(const Orden &orden)) {
    llegaA = llega;
#define TAPA(funcion, ...)                                                                                   \
    { #funcion, tapada < DE_VERDAD(funcion), __VA_ARGS__>(#funcion) }
    static const std::map<std::string, Direccion> TAPADAS = {
#ifndef __EMSCRIPTEN__
        TAPA(glDrawArraysInstanced, instancias),
        TAPA(glDrawElementsInstanced, instanciasConIndices),
        TAPA(glDrawElementsInstancedBaseVertex, instanciasConBase),
        TAPA(glDrawRangeElements, enTramo),
        TAPA(glDrawElementsBaseVertex, conBase),
        TAPA(glDrawRangeElementsBaseVertex, enTramoConBase),
        TAPA(glMultiDrawArrays, varios),
        TAPA(glMultiDrawElements, variosConIndices),
        TAPA(glMultiDrawElementsBaseVertex, variosConBase),
        TAPA(glClearBufferfv, borra<const GLfloat *>),
        TAPA(glClearBufferiv, borra<const GLint *>),
        TAPA(glClearBufferuiv, borra<const GLuint *>),
        TAPA(glClearBufferfi, borra<GLfloat, GLint>),
#endif
        TAPA(glBlitFramebuffer, copia)};
#undef TAPA
    const auto suya = TAPADAS.find(nombre);
    return suya == TAPADAS.end() ? nullptr : suya->second;
}

Orden ordenBorra(GLbitfield buferes) {
    Orden o{Orden::Que::Borra, llamada("glClear", nombreBuferes(buferes)),
            [=] { deVerdad().borra(buferes); }};
    o.buferes = buferes;
    return o;
}

Orden ordenDibuja(GLenum modo, GLint primero, GLsizei vertices) {
    const std::string como = llamada("glDrawArrays", nombreModo(modo), primero, vertices);
    Orden o = dibuja(como, modo, GL_NONE, {{primero, vertices}});
    o.hazla = [=] { deVerdad().dibujaVertices(modo, primero, vertices); };
    return o;
}

Orden ordenDibuja(GLenum modo, GLsizei vertices, GLenum tipo, const void *indices) {
    const std::string como = llamada("glDrawElements", nombreModo(modo), vertices, nombreDe(tipo), indices);
    Orden o = dibuja(como, modo, tipo, {{0, vertices, indices}});
    o.hazla = [=] {
        if (!faltanIndices(o))
            deVerdad().dibujaIndices(modo, vertices, tipo, indices);
    };
    return o;
}

GLsizei Orden::vertices() const {
    GLsizei suma = 0;
    for (const Tramo &t : tramos)
        suma += t.vertices;
    return suma;
}

namespace {

template<class Indice>
std::vector<GLuint> leeIndices(std::intptr_t desde, GLsizei cuantos) {
    std::vector<Indice> leidos(static_cast<std::size_t>(cuantos));
    const auto bytes = GLsizeiptr(leidos.size() * sizeof(Indice));
    if (desde < 0 ||
        desde + bytes > contesta(glGetBufferParameteriv, GL_ELEMENT_ARRAY_BUFFER, GL_BUFFER_SIZE))
        return {};
    glGetBufferSubData(GL_ELEMENT_ARRAY_BUFFER, desde, bytes, leidos.data());
    return {leidos.begin(), leidos.end()};
}

std::vector<GLuint> indicesDe(GLenum tipo, const Tramo &t) {
    const auto desde = reinterpret_cast<std::intptr_t>(t.indices);
    switch (tipo) {
    case GL_UNSIGNED_BYTE: return leeIndices<GLubyte>(desde, t.vertices);
    case GL_UNSIGNED_SHORT: return leeIndices<GLushort>(desde, t.vertices);
    case GL_UNSIGNED_INT: return leeIndices<GLuint>(desde, t.vertices);
    default: break;
    }
    std::vector<GLuint> seguidos;
    for (GLsizei i = 0; i < t.vertices; ++i)
        seguidos.push_back(GLuint(t.primero + i));
    return seguidos;
}

std::string titulo(const Orden &o) {
    if (o.que == Orden::Que::Copia)
        return "copia de un framebuffer";
    if (o.que == Orden::Que::Borra) {
        std::string que;
        for (const auto &[bit, nombre] : {std::pair(GL_COLOR_BUFFER_BIT, "color"),
                                          {GL_DEPTH_BUFFER_BIT, "profundidad"},
                                          {GL_STENCIL_BUFFER_BIT, "plantilla"}})
            if (o.buferes & GLbitfield(bit))
                que += (que.empty() ? "" : ", ") + std::string(nombre);
        return "borra " + que;
    }
    const std::optional<Primitivas> p = primitivasDe(o);
    return (p ? cuantasSon(*p) : std::to_string(o.vertices()) + " vértices") +
           (o.instancias == 1 ? "" : " × " + std::to_string(o.instancias) + " instancias");
}

std::string en(GLenum cual, int n) {
    GLfloat valores[4] = {};
    glGetFloatv(cual, valores);
    std::string texto;
    for (int i = 0; i < n; ++i)
        texto += (i ? " " : "") + cifras(double(valores[i]), 6);
    return texto;
}

std::string constante(GLenum cual) {
    return nombreDe(GLenum(entero(cual)));
}

std::string mascaraColor() {
    std::string texto = "rgba";
    for (std::size_t i = 0; i < 4; ++i)
        texto[i] = mascaraDeColor()[i] ? texto[i] : '-';
    return texto;
}

// Lo que está puesto: cada prueba, apagada o con lo que pide.
std::vector<std::pair<std::string, std::string>> estadoActual() {
    const auto si = [](GLenum interruptor, const std::string &texto) {
        return glIsEnabled(interruptor) ? texto : "no";
    };
    const std::string mezcla = constante(GL_BLEND_EQUATION_RGB) + ": " +
                               nombreFactor(GLenum(entero(GL_BLEND_SRC_RGB))) + ", " +
                               nombreFactor(GLenum(entero(GL_BLEND_DST_RGB))) + "; alfa " +
                               nombreFactor(GLenum(entero(GL_BLEND_SRC_ALPHA))) + ", " +
                               nombreFactor(GLenum(entero(GL_BLEND_DST_ALPHA)));
    const std::string plantilla =
        constante(GL_STENCIL_FUNC) + " " + std::to_string(pideLaPlantilla()) + ", máscara " +
        std::to_string(GLuint(entero(GL_STENCIL_VALUE_MASK))) + "; " + constante(GL_STENCIL_FAIL) + ", " +
        constante(GL_STENCIL_PASS_DEPTH_FAIL) + ", " + constante(GL_STENCIL_PASS_DEPTH_PASS);
    return {
        {"glViewport", en(GL_VIEWPORT, 4)},
        {"GL_CULL_FACE",
         si(GL_CULL_FACE, constante(GL_CULL_FACE_MODE) + ", de frente " + constante(GL_FRONT_FACE))},
        {"GL_SCISSOR_TEST", si(GL_SCISSOR_TEST, en(GL_SCISSOR_BOX, 4))},
        {"GL_STENCIL_TEST", si(GL_STENCIL_TEST, plantilla)},
        {"GL_DEPTH_TEST", si(GL_DEPTH_TEST, constante(GL_DEPTH_FUNC))},
        {"glDepthRange", en(GL_DEPTH_RANGE, 2)},
        {"glDepthMask", entero(GL_DEPTH_WRITEMASK) ? "escribe" : "no escribe"},
        {"GL_BLEND", si(GL_BLEND, mezcla)},
        {"glColorMask", mascaraColor()},
        {"glPolygonMode", EN_WEB ? "GL_FILL" : constante(GL_POLYGON_MODE)},
        {"GL_POLYGON_OFFSET_FILL",
         si(GL_POLYGON_OFFSET_FILL, en(GL_POLYGON_OFFSET_FACTOR, 1) + " " + en(GL_POLYGON_OFFSET_UNITS, 1))},
    };
}

// Lo que distingue una orden de otra, en pocas palabras.
std::vector<std::string> pruebas(const Orden &o) {
    std::vector<std::string> lista;
    if (glIsEnabled(GL_SCISSOR_TEST))
        lista.push_back("recorte");
    if (o.que != Orden::Que::Dibuja)
        return lista;
    if (glIsEnabled(GL_STENCIL_TEST))
        lista.push_back("plantilla " + constante(GL_STENCIL_FUNC).substr(3) + " " +
                        std::to_string(pideLaPlantilla()));
    if (glIsEnabled(GL_CULL_FACE))
        lista.push_back("quita caras");
    if (glIsEnabled(GL_BLEND))
        lista.push_back("mezcla");
    if (!escribeColor())
        lista.push_back("sin color");
    if (!glIsEnabled(GL_DEPTH_TEST))
        lista.push_back("sin profundidad");
    return lista;
}

std::string nombreLienzo(const Lienzo &l) {
    if (l.nombre == 0)
        return "la ventana";
    std::string texto = "framebuffer " + std::to_string(l.nombre) + ", de " + std::to_string(l.ancho) + "×" +
                        std::to_string(l.alto);
    if (l.muestras)
        texto += " y " + std::to_string(l.muestras) + " muestras";
    return texto + (l.buferColor == GL_NONE ? ", sin color" : "");
}

} // namespace

std::optional<Primitivas> primitivasDe(const Orden &o) {
    if (o.que != Orden::Que::Dibuja || !entero(GL_VERTEX_ARRAY_BINDING) ||
        (o.tipoIndice != GL_NONE && !entero(GL_ELEMENT_ARRAY_BUFFER_BINDING)))
        return {};
    std::optional<GLuint> reinicia;
    if (!EN_WEB && glIsEnabled(GL_PRIMITIVE_RESTART))
        reinicia = GLuint(entero(GL_PRIMITIVE_RESTART_INDEX));
    std::optional<Primitivas> todas = sueltas(o.modo, {}, reinicia);
    for (const Tramo &t : o.tramos) {
        if (!todas || t.vertices < 0)
            return {};
        const std::optional<Primitivas> suyas = sueltas(o.modo, indicesDe(o.tipoIndice, t), reinicia);
        for (const GLuint indice : suyas->indices)
            todas->indices.push_back(indice + GLuint(t.base));
    }
    return todas;
}

Json describe(const Orden &o, const Lienzo &l) {
    std::vector<Json> estado;
    if (o.que == Orden::Que::Dibuja)
        for (const auto &[nombre, valor] : estadoActual())
            estado.push_back(Json().pon("nombre", nombre).pon("valor", valor));
    Json orden = {{"llamada", o.llamada},  {"titulo", titulo(o)},
                  {"pruebas", pruebas(o)}, {"framebuffer", nombreLienzo(l)},
                  {"pinta", l.textura},    {"talla", std::array<int, 2>{l.ancho, l.alto}},
                  {"estado", estado}};
    if (const GLint programa = entero(GL_CURRENT_PROGRAM); programa && o.que == Orden::Que::Dibuja)
        orden.pon("programa", programa);
    return orden;
}

} // namespace explica
