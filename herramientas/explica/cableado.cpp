#include "cableado.h"
#include "enviado.h"
#include "estado.h"
#include "nombres.h"
#include <algorithm>
#include <cstdint>
#include <cstring>

namespace explica {
namespace {

const GLsizeiptr MUESTRA = 65536; // vértices que se miran, como mucho

using Bytes = std::vector<unsigned char>;

// FNV-1a, de 64 bits.
std::string sumaDe(const Bytes &bytes) {
    std::uint64_t suma = 14695981039346656037u;
    for (const unsigned char b : bytes)
        suma = (suma ^ b) * 1099511628211u;
    char texto[20];
    std::snprintf(texto, sizeof texto, "%016llx", static_cast<unsigned long long>(suma));
    return texto;
}

Bytes deBufer(GLint bufer) {
    const GLint antes = entero(GL_COPY_READ_BUFFER_BINDING);
    glBindBuffer(GL_COPY_READ_BUFFER, GLuint(bufer));
    const GLint ocupa = contesta(glGetBufferParameteriv, GL_COPY_READ_BUFFER, GL_BUFFER_SIZE);
    Bytes bytes(std::size_t(std::max(ocupa, 0)));
    glGetBufferSubData(GL_COPY_READ_BUFFER, 0, ocupa, bytes.data());
    glBindBuffer(GL_COPY_READ_BUFFER, GLuint(antes));
    return bytes;
}

// Sin lo que haya en medio de otros atributos.
std::string sumaDe(const Atributo &a) {
    const Bytes todo = deBufer(a.bufer);
    const std::size_t ocupa = bytesDe(a.tipo) * std::size_t(std::clamp(a.componentes, 1, 4)),
                      paso = a.paso > 0 ? std::size_t(a.paso) : ocupa;
    Bytes suyo;
    for (std::size_t desde = std::size_t(std::max<std::intptr_t>(a.desplazamiento, 0));
         desde + ocupa <= todo.size(); desde += paso)
        suyo.insert(suyo.end(), todo.begin() + long(desde), todo.begin() + long(desde + ocupa));
    return sumaDe(suyo);
}

void leePrimeros(Atributo &a) {
    const GLint antes = entero(GL_COPY_READ_BUFFER_BINDING);
    glBindBuffer(GL_COPY_READ_BUFFER, GLuint(a.bufer));
    a.bytes = contesta(glGetBufferParameteriv, GL_COPY_READ_BUFFER, GL_BUFFER_SIZE);
    const GLsizeiptr ocupa = GLsizeiptr(sizeof(float)) * a.componentes, paso = a.paso ? a.paso : ocupa;
    const GLsizeiptr hay = a.bytes - a.desplazamiento, todos = std::min(hay, MUESTRA * paso + ocupa);
    if (a.tipo == GL_FLOAT && a.componentes >= 1 && a.componentes <= 4 && a.desplazamiento >= 0 &&
        hay >= ocupa) {
        Bytes leidos(std::size_t(todos), 0); // de una vez, que en la página cada lectura espera
        glGetBufferSubData(GL_COPY_READ_BUFFER, a.desplazamiento, todos, leidos.data());
        for (GLsizeiptr i = 0; i < MUESTRA && i * paso + ocupa <= todos; ++i)
            std::memcpy(a.primeros.emplace_back().data(), &leidos[std::size_t(i * paso)], std::size_t(ocupa));
    }
    glBindBuffer(GL_COPY_READ_BUFFER, GLuint(antes));
}

Atributo atributo(const Variable &v) {
    const GLuint donde = GLuint(v.donde);
    Atributo a;
    a.variable = v;
    a.activo = contesta(glGetVertexAttribiv, donde, GL_VERTEX_ATTRIB_ARRAY_ENABLED);
    a.bufer = contesta(glGetVertexAttribiv, donde, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING);
    a.componentes = contesta(glGetVertexAttribiv, donde, GL_VERTEX_ATTRIB_ARRAY_SIZE);
    a.paso = contesta(glGetVertexAttribiv, donde, GL_VERTEX_ATTRIB_ARRAY_STRIDE);
    a.tipo = GLenum(contesta(glGetVertexAttribiv, donde, GL_VERTEX_ATTRIB_ARRAY_TYPE));
    void *puntero = nullptr;
    glGetVertexAttribPointerv(donde, GL_VERTEX_ATTRIB_ARRAY_POINTER, &puntero);
    a.desplazamiento = reinterpret_cast<std::intptr_t>(puntero);
    if (a.activo && a.bufer)
        leePrimeros(a);
    std::array<float, 4> suyo{};
    glGetVertexAttribfv(donde, GL_CURRENT_VERTEX_ATTRIB, suyo.data());
    a.constante = !a.activo && suyo != std::array<float, 4>{0, 0, 0, 1};
    return a;
}

struct Objetivo {
    GLenum sampler, objetivo, enlazada;
};
const Objetivo OBJETIVOS[] = {
#define DE_ENTEROS(sampler, objetivo)                                                                        \
    {GL_SAMPLER_##sampler, GL_TEXTURE_##objetivo, GL_TEXTURE_BINDING_##objetivo},                            \
        {GL_INT_SAMPLER_##sampler, GL_TEXTURE_##objetivo, GL_TEXTURE_BINDING_##objetivo}, {                  \
        GL_UNSIGNED_INT_SAMPLER_##sampler, GL_TEXTURE_##objetivo, GL_TEXTURE_BINDING_##objetivo              \
    }
#define Y_DE_SOMBRA(cual)                                                                                    \
    DE_ENTEROS(cual, cual), {                                                                                \
        GL_SAMPLER_##cual##_SHADOW, GL_TEXTURE_##cual, GL_TEXTURE_BINDING_##cual                             \
    }
    Y_DE_SOMBRA(1D),
    Y_DE_SOMBRA(2D),
    Y_DE_SOMBRA(1D_ARRAY),
    Y_DE_SOMBRA(2D_ARRAY),
    DE_ENTEROS(3D, 3D),
    DE_ENTEROS(CUBE, CUBE_MAP),
    DE_ENTEROS(2D_RECT, RECTANGLE),
    {GL_SAMPLER_2D_RECT_SHADOW, GL_TEXTURE_RECTANGLE, GL_TEXTURE_BINDING_RECTANGLE},
    DE_ENTEROS(BUFFER, BUFFER),
};

GLint delNivel(GLenum objetivo, GLint nivel, GLenum cual) {
    const GLenum imagen = objetivo == GL_TEXTURE_CUBE_MAP ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : objetivo;
    return contesta(glGetTexLevelParameteriv, imagen, nivel, cual);
}

std::string porQueNoEstaCompleta(const Textura &t) {
    if (!t.nombre)
        return "no hay ninguna en esa unidad";
    if (EN_WEB || t.objetivo == GL_TEXTURE_BUFFER)
        return ""; // no se sabe, o no le hace falta nada
    if (!t.ancho)
        return "no tiene imagen (glTexImage2D)";
    if (t.reduce == GL_NEAREST || t.reduce == GL_LINEAR)
        return "";
    GLint hay = 1, faltan = 0;
    for (GLint talla = std::max(t.ancho, t.alto) / 2;
         talla && hay + faltan <= contesta(glGetTexParameteriv, t.objetivo, GL_TEXTURE_MAX_LEVEL); talla /= 2)
        ++(faltan || !delNivel(t.objetivo, hay, GL_TEXTURE_WIDTH) ? faltan : hay);
    return faltan ? "su filtro de reducción es " + nombreDe(GLenum(t.reduce)) + " y solo tiene " +
                        (hay == 1 ? "un nivel"
                                  : std::to_string(hay) + " niveles, faltan " + std::to_string(faltan)) +
                        ": falta glGenerateMipmap, o un filtro sin niveles"
                  : "";
}

// De la que está enlazada: lo que se lee de cada texel.
std::string sumaDe(const Textura &t) {
    const Guardado guardado;
    const bool profundidad = t.formato == GL_DEPTH_COMPONENT || t.formato == GL_DEPTH_COMPONENT16 ||
                             t.formato == GL_DEPTH_COMPONENT24 || t.formato == GL_DEPTH_COMPONENT32F;
    const GLint hondo = std::max(delNivel(t.objetivo, 0, GL_TEXTURE_DEPTH), 1);
    const bool deEnteros = delNivel(t.objetivo, 0, GL_TEXTURE_RED_TYPE) == GL_UNSIGNED_INT ||
                           delNivel(t.objetivo, 0, GL_TEXTURE_RED_TYPE) == GL_INT;
    const GLenum que = profundidad ? GL_DEPTH_COMPONENT : deEnteros ? GL_RGBA_INTEGER : GL_RGBA;
    const std::size_t ocupa = std::size_t(profundidad ? 4 : 16) * std::size_t(t.ancho) * std::size_t(t.alto);
    const bool cubo = t.objetivo == GL_TEXTURE_CUBE_MAP;
    Bytes bytes(ocupa * std::size_t(cubo ? 6 : hondo));
    for (std::size_t cara = 0; cara < (cubo ? 6 : 1); ++cara)
        glGetTexImage(cubo ? GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + cara) : t.objetivo, 0, que,
                      deEnteros ? GL_UNSIGNED_INT : GL_FLOAT, bytes.data() + cara * ocupa);
    return sumaDe(bytes);
}

Textura textura(GLuint programa, const Variable &v, const Objetivo &o, bool conSuma) {
    Textura t;
    t.sampler = v.nombre;
    t.objetivo = o.objetivo;
    glGetUniformiv(programa, v.donde, &t.unidad);
    const GLint antes = entero(GL_ACTIVE_TEXTURE);
    glActiveTexture(GLenum(GL_TEXTURE0 + t.unidad));
    t.nombre = entero(o.enlazada);
    if (t.nombre && o.objetivo != GL_TEXTURE_BUFFER) {
        t.ancho = delNivel(o.objetivo, 0, GL_TEXTURE_WIDTH);
        t.alto = delNivel(o.objetivo, 0, GL_TEXTURE_HEIGHT);
        t.formato = delNivel(o.objetivo, 0, GL_TEXTURE_INTERNAL_FORMAT);
        t.reduce = contesta(glGetTexParameteriv, o.objetivo, GL_TEXTURE_MIN_FILTER);
        t.amplia = contesta(glGetTexParameteriv, o.objetivo, GL_TEXTURE_MAG_FILTER);
        t.repiteS = contesta(glGetTexParameteriv, o.objetivo, GL_TEXTURE_WRAP_S);
        t.repiteT = contesta(glGetTexParameteriv, o.objetivo, GL_TEXTURE_WRAP_T);
    }
    t.incompleta = porQueNoEstaCompleta(t);
    if (conSuma && t.ancho > 0 && t.alto > 0)
        t.suma = sumaDe(t);
    glActiveTexture(GLenum(antes));
    return t;
}

} // namespace

std::size_t bytesDe(GLenum tipo) {
    switch (tipo) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE: return 1;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
    case GL_HALF_FLOAT: return 2;
    case GL_DOUBLE: return 8;
    default: return 4;
    }
}

Cableado cableadoActual(bool sumas) {
    const GLuint programa = GLuint(entero(GL_CURRENT_PROGRAM));
    Cableado c;
    if (!programa)
        return c;
    for (const Variable &v : atributosDe(programa)) {
        c.atributos.push_back(atributo(v));
        Atributo &a = c.atributos.back();
        if (sumas && a.activo && a.bufer)
            a.suma = sumaDe(a);
    }
    if (sumas && entero(GL_ELEMENT_ARRAY_BUFFER_BINDING))
        c.sumaIndices = sumaDe(deBufer(entero(GL_ELEMENT_ARRAY_BUFFER_BINDING)));
    for (const Variable &v : uniformsDe(programa)) {
        const std::string primero =
            v.nombre.substr(0, v.nombre.rfind('[')) + "[0]"; // un array se da desde el primero
        const bool lista = v.nombre.back() == ']';
        const GLint desde = lista ? glGetUniformLocation(programa, primero.c_str()) : v.donde;
        const GLint dado = seHaDado(programa, v.donde) ? v.donde : desde;
        c.uniformes.push_back({v, valorDe(programa, v), seHaDado(programa, dado), malDado(programa, v),
                               pilaDelEnvio(programa, dado)});
        const auto o = std::find_if(std::begin(OBJETIVOS), std::end(OBJETIVOS),
                                    [&](const Objetivo &otro) { return otro.sampler == v.tipo; });
        if (o != std::end(OBJETIVOS))
            c.texturas.push_back(textura(programa, v, *o, sumas));
    }
    return c;
}

Json deCableado(const Cableado &c) {
    std::vector<Json> atributos, uniformes, texturas;
    for (const Atributo &a : c.atributos) {
        const std::vector<std::array<float, 4>> tres(
            a.primeros.begin(), a.primeros.begin() + std::min<long>(3, long(a.primeros.size())));
        atributos.push_back({{"nombre", a.variable.nombre},
                             {"tipo", tipoDe(a.variable.tipo)},
                             {"activo", a.activo},
                             {"bufer", a.bufer},
                             {"componentes", a.componentes},
                             {"de", nombreDe(a.tipo)},
                             {"paso", a.paso},
                             {"desplazamiento", a.desplazamiento},
                             {"primeros", tres},
                             {"suma", a.suma}});
    }
    for (const Uniforme &u : c.uniformes)
        uniformes.push_back({{"nombre", u.variable.nombre},
                             {"tipo", tipoDe(u.variable.tipo)},
                             {"valor", u.valor},
                             {"dado", u.dado},
                             {"pila", u.pila}});
    for (const Textura &t : c.texturas) {
        std::vector<GLint> talla;
        if (!EN_WEB)
            talla = {t.ancho, t.alto};
        texturas.push_back({{"sampler", t.sampler},
                            {"unidad", t.unidad},
                            {"textura", t.nombre},
                            {"objetivo", nombreDe(t.objetivo)},
                            {"talla", talla},
                            {"formato", EN_WEB ? "" : nombreDe(GLenum(t.formato))},
                            {"reduce", nombreDe(GLenum(t.reduce))},
                            {"amplia", nombreDe(GLenum(t.amplia))},
                            {"repite", nombreDe(GLenum(t.repiteS)) + ", " + nombreDe(GLenum(t.repiteT))},
                            {"incompleta", t.incompleta},
                            {"suma", t.suma}});
    }
    return {{"indices", entero(GL_ELEMENT_ARRAY_BUFFER_BINDING)},
            {"sumaIndices", c.sumaIndices},
            {"vao", entero(GL_VERTEX_ARRAY_BINDING)},
            {"atributos", atributos},
            {"uniformes", uniformes},
            {"texturas", texturas}};
}

} // namespace explica
