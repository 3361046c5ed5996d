#include "ordenes.h"
#include "nombres.h"
#include "programas.h"
#include <cstdint>

namespace explica {

Orden ordenBorra(GLbitfield buferes) {
    Orden o{Orden::Que::Borra, [=] { deVerdad().borra(buferes); }};
    o.buferes = buferes;
    return o;
}

Orden ordenDibuja(GLenum modo, GLint primero, GLsizei vertices) {
    Orden o{Orden::Que::Dibuja, [=] { deVerdad().dibujaVertices(modo, primero, vertices); }};
    o.modo = modo, o.primero = primero, o.vertices = vertices;
    return o;
}

Orden ordenDibuja(GLenum modo, GLsizei vertices, GLenum tipoIndice, const void *indices) {
    Orden o{Orden::Que::Dibuja, [=] { deVerdad().dibujaIndices(modo, vertices, tipoIndice, indices); }};
    o.modo = modo, o.vertices = vertices, o.tipoIndice = tipoIndice, o.indices = indices;
    return o;
}

Orden ordenCopia(const std::array<GLint, 4> &origen, const std::array<GLint, 4> &destino, GLbitfield buferes,
                 GLenum filtro) {
    Orden o{Orden::Que::Copia, [=] {
                deVerdad().copia(origen[0], origen[1], origen[2], origen[3], destino[0], destino[1],
                                 destino[2], destino[3], buferes, filtro);
            }};
    o.origen = origen, o.destino = destino, o.buferes = buferes, o.filtro = filtro;
    return o;
}

namespace {

template<class Indice>
std::vector<GLuint> leeIndices(std::intptr_t desde, GLsizei cuantos) {
    std::vector<Indice> leidos(static_cast<std::size_t>(cuantos));
    const auto bytes = GLsizeiptr(leidos.size() * sizeof(Indice));
    GLint hay = 0;
    glGetBufferParameteriv(GL_ELEMENT_ARRAY_BUFFER, GL_BUFFER_SIZE, &hay);
    if (desde < 0 || desde + bytes > hay)
        return {};
    glGetBufferSubData(GL_ELEMENT_ARRAY_BUFFER, desde, bytes, leidos.data());
    return {leidos.begin(), leidos.end()};
}

std::vector<GLuint> indicesDe(const Orden &o) {
    const auto desde = reinterpret_cast<std::intptr_t>(o.indices);
    switch (o.tipoIndice) {
    case GL_UNSIGNED_BYTE: return leeIndices<GLubyte>(desde, o.vertices);
    case GL_UNSIGNED_SHORT: return leeIndices<GLushort>(desde, o.vertices);
    case GL_UNSIGNED_INT: return leeIndices<GLuint>(desde, o.vertices);
    default: break;
    }
    std::vector<GLuint> seguidos;
    for (GLsizei i = 0; i < o.vertices; ++i)
        seguidos.push_back(GLuint(o.primero + i));
    return seguidos;
}

std::string llamada(const Orden &o) {
    const auto n = [](auto numero) { return std::to_string(numero); };
    if (o.que == Orden::Que::Borra)
        return "glClear(" + nombreBuferes(o.buferes) + ")";
    if (o.que == Orden::Que::Copia) {
        std::string texto = "glBlitFramebuffer(";
        for (const auto &rectangulo : {o.origen, o.destino})
            for (const GLint lado : rectangulo)
                texto += n(lado) + ", ";
        return texto + nombreBuferes(o.buferes) + ", " + nombreDe(o.filtro) + ")";
    }
    if (o.tipoIndice == GL_NONE)
        return "glDrawArrays(" + nombreModo(o.modo) + ", " + n(o.primero) + ", " + n(o.vertices) + ")";
    return "glDrawElements(" + nombreModo(o.modo) + ", " + n(o.vertices) + ", " + nombreDe(o.tipoIndice) +
           ", " + n(reinterpret_cast<std::intptr_t>(o.indices)) + ")";
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
    return p ? cuantasSon(*p) : std::to_string(o.vertices) + " vértices";
}

std::string en(GLenum cual, int n) {
    GLfloat valores[4] = {};
    glGetFloatv(cual, valores);
    std::string texto;
    for (int i = 0; i < n; ++i) {
        char numero[24];
        std::snprintf(numero, sizeof numero, i ? " %g" : "%g", double(valores[i]));
        texto += numero;
    }
    return texto;
}

std::string constante(GLenum cual) {
    return nombreDe(GLenum(entero(cual)));
}

std::string mascaraColor() {
    GLboolean m[4];
    glGetBooleanv(GL_COLOR_WRITEMASK, m);
    std::string texto;
    for (int i = 0; i < 4; ++i)
        texto += m[i] ? "rgba"[i] : '-';
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
    const std::string plantilla = constante(GL_STENCIL_FUNC) + " " + std::to_string(entero(GL_STENCIL_REF)) +
                                  ", máscara " + std::to_string(entero(GL_STENCIL_VALUE_MASK)) + "; " +
                                  constante(GL_STENCIL_FAIL) + ", " + constante(GL_STENCIL_PASS_DEPTH_FAIL) +
                                  ", " + constante(GL_STENCIL_PASS_DEPTH_PASS);
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
        {"glPolygonMode", constante(GL_POLYGON_MODE)},
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
                        std::to_string(entero(GL_STENCIL_REF)));
    if (glIsEnabled(GL_CULL_FACE))
        lista.push_back("quita caras");
    if (glIsEnabled(GL_BLEND))
        lista.push_back("mezcla");
    if (mascaraColor() == "----")
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
    if (o.que != Orden::Que::Dibuja || o.vertices < 0 || !entero(GL_VERTEX_ARRAY_BINDING) ||
        (o.tipoIndice != GL_NONE && !entero(GL_ELEMENT_ARRAY_BUFFER_BINDING)))
        return {};
    std::optional<GLuint> reinicia;
    if (glIsEnabled(GL_PRIMITIVE_RESTART))
        reinicia = GLuint(entero(GL_PRIMITIVE_RESTART_INDEX));
    return sueltas(o.modo, indicesDe(o), reinicia);
}

Json describe(const Orden &o, const Lienzo &l) {
    std::vector<Json> estado;
    if (o.que == Orden::Que::Dibuja)
        for (const auto &[nombre, valor] : estadoActual())
            estado.push_back(Json().pon("nombre", nombre).pon("valor", valor));
    Json orden;
    orden.pon("llamada", llamada(o)).pon("titulo", titulo(o)).pon("pruebas", pruebas(o));
    orden.pon("framebuffer", nombreLienzo(l))
        .pon("talla", std::array<int, 2>{l.ancho, l.alto})
        .pon("estado", estado);
    if (o.que == Orden::Que::Dibuja)
        orden.pon("programa", entero(GL_CURRENT_PROGRAM));
    return orden;
}

} // namespace explica
