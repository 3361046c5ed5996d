#include "cableado.h"
#include "nombres.h"
#include <algorithm>
#include <cstdint>
#include <set>

namespace explica {
namespace {

const GLsizeiptr MUESTRA = 64; // vértices que se miran

std::set<std::pair<GLuint, GLint>> dados; // programa y uniform

GLint delAtributo(GLuint donde, GLenum cual) {
    GLint valor = 0;
    glGetVertexAttribiv(donde, cual, &valor);
    return valor;
}

void leePrimeros(Atributo &a) {
    const GLint antes = entero(GL_COPY_READ_BUFFER_BINDING);
    glBindBuffer(GL_COPY_READ_BUFFER, GLuint(a.bufer));
    GLint bytes = 0;
    glGetBufferParameteriv(GL_COPY_READ_BUFFER, GL_BUFFER_SIZE, &bytes);
    const GLsizeiptr ocupa = GLsizeiptr(sizeof(float)) * a.componentes, paso = a.paso ? a.paso : ocupa;
    for (GLsizeiptr i = 0; i < MUESTRA; ++i) {
        const GLsizeiptr desde = a.desplazamiento + i * paso;
        if (a.componentes < 1 || a.componentes > 4 || desde + ocupa > bytes)
            break;
        std::array<float, 4> valor{};
        glGetBufferSubData(GL_COPY_READ_BUFFER, desde, ocupa, valor.data());
        a.primeros.push_back(valor);
    }
    glBindBuffer(GL_COPY_READ_BUFFER, GLuint(antes));
}

Atributo atributo(const Variable &v) {
    const GLuint donde = GLuint(v.donde);
    Atributo a;
    a.variable = v;
    a.activo = delAtributo(donde, GL_VERTEX_ATTRIB_ARRAY_ENABLED);
    a.bufer = delAtributo(donde, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING);
    a.componentes = delAtributo(donde, GL_VERTEX_ATTRIB_ARRAY_SIZE);
    a.paso = delAtributo(donde, GL_VERTEX_ATTRIB_ARRAY_STRIDE);
    a.tipo = GLenum(delAtributo(donde, GL_VERTEX_ATTRIB_ARRAY_TYPE));
    void *puntero = nullptr;
    glGetVertexAttribPointerv(donde, GL_VERTEX_ATTRIB_ARRAY_POINTER, &puntero);
    a.desplazamiento = reinterpret_cast<std::intptr_t>(puntero);
    if (a.activo && a.bufer && a.tipo == GL_FLOAT)
        leePrimeros(a);
    return a;
}

struct Objetivo {
    GLenum sampler, objetivo, enlazada;
};
const Objetivo OBJETIVOS[] = {
    {GL_SAMPLER_1D, GL_TEXTURE_1D, GL_TEXTURE_BINDING_1D},
    {GL_SAMPLER_2D, GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D},
    {GL_SAMPLER_2D_SHADOW, GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D},
    {GL_UNSIGNED_INT_SAMPLER_2D, GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D},
    {GL_SAMPLER_3D, GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D},
    {GL_SAMPLER_CUBE, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP},
};

GLint delNivel(GLenum objetivo, GLint nivel, GLenum cual) {
    GLint valor = 0;
    glGetTexLevelParameteriv(objetivo == GL_TEXTURE_CUBE_MAP ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : objetivo,
                             nivel, cual, &valor);
    return valor;
}

GLint deTextura(GLenum objetivo, GLenum cual) {
    GLint valor = 0;
    glGetTexParameteriv(objetivo, cual, &valor);
    return valor;
}

std::string porQueNoEstaCompleta(const Textura &t) {
    if (!t.nombre)
        return "no hay ninguna en esa unidad";
    if (!t.ancho)
        return "no tiene imagen (glTexImage2D)";
    const bool conNiveles = t.reduce != GL_NEAREST && t.reduce != GL_LINEAR;
    if (conNiveles && std::max(t.ancho, t.alto) > 1 && deTextura(t.objetivo, GL_TEXTURE_MAX_LEVEL) > 0 &&
        !delNivel(t.objetivo, 1, GL_TEXTURE_WIDTH))
        return "su filtro de reducción es " + nombreDe(GLenum(t.reduce)) +
               " y solo tiene un nivel: falta glGenerateMipmap, o un filtro sin niveles";
    return "";
}

Textura textura(GLuint programa, const Variable &v, const Objetivo &o) {
    Textura t;
    t.sampler = v.nombre;
    t.objetivo = o.objetivo;
    glGetUniformiv(programa, v.donde, &t.unidad);
    const GLint antes = entero(GL_ACTIVE_TEXTURE);
    glActiveTexture(GLenum(GL_TEXTURE0 + t.unidad));
    t.nombre = entero(o.enlazada);
    if (t.nombre) {
        t.ancho = delNivel(o.objetivo, 0, GL_TEXTURE_WIDTH);
        t.alto = delNivel(o.objetivo, 0, GL_TEXTURE_HEIGHT);
        t.formato = delNivel(o.objetivo, 0, GL_TEXTURE_INTERNAL_FORMAT);
        t.reduce = deTextura(o.objetivo, GL_TEXTURE_MIN_FILTER);
        t.amplia = deTextura(o.objetivo, GL_TEXTURE_MAG_FILTER);
        t.repiteS = deTextura(o.objetivo, GL_TEXTURE_WRAP_S);
        t.repiteT = deTextura(o.objetivo, GL_TEXTURE_WRAP_T);
    }
    t.incompleta = porQueNoEstaCompleta(t);
    glActiveTexture(GLenum(antes));
    return t;
}

} // namespace

void apuntaUniforme(GLint donde) {
    if (donde >= 0)
        dados.insert({GLuint(entero(GL_CURRENT_PROGRAM)), donde});
}

Cableado cableadoActual() {
    const GLuint programa = GLuint(entero(GL_CURRENT_PROGRAM));
    Cableado c;
    if (!programa)
        return c;
    for (const Variable &v : atributosDe(programa))
        c.atributos.push_back(atributo(v));
    for (const Variable &v : uniformsDe(programa)) {
        const std::string primero =
            v.nombre.substr(0, v.nombre.rfind('[')) + "[0]"; // un array se da desde el primero
        const bool lista = v.nombre.back() == ']';
        const GLint desde = lista ? glGetUniformLocation(programa, primero.c_str()) : v.donde;
        c.uniformes.push_back(
            {v, valorDe(programa, v), dados.count({programa, v.donde}) || dados.count({programa, desde})});
        const auto o = std::find_if(std::begin(OBJETIVOS), std::end(OBJETIVOS),
                                    [&](const Objetivo &otro) { return otro.sampler == v.tipo; });
        if (o != std::end(OBJETIVOS))
            c.texturas.push_back(textura(programa, v, *o));
    }
    return c;
}

Json deCableado(const Cableado &c) {
    std::vector<Json> atributos, uniformes, texturas;
    for (const Atributo &a : c.atributos) {
        const std::vector<std::array<float, 4>> tres(
            a.primeros.begin(), a.primeros.begin() + std::min<long>(3, long(a.primeros.size())));
        Json json;
        json.pon("nombre", a.variable.nombre).pon("tipo", tipoDe(a.variable.tipo)).pon("activo", a.activo);
        json.pon("bufer", a.bufer).pon("componentes", a.componentes).pon("de", nombreDe(a.tipo));
        atributos.push_back(
            json.pon("paso", a.paso).pon("desplazamiento", a.desplazamiento).pon("primeros", tres));
    }
    for (const Uniforme &u : c.uniformes)
        uniformes.push_back(Json()
                                .pon("nombre", u.variable.nombre)
                                .pon("tipo", tipoDe(u.variable.tipo))
                                .pon("valor", u.valor)
                                .pon("dado", u.dado));
    for (const Textura &t : c.texturas) {
        Json json;
        json.pon("sampler", t.sampler)
            .pon("unidad", t.unidad)
            .pon("textura", t.nombre)
            .pon("objetivo", nombreDe(t.objetivo));
        json.pon("talla", std::array<GLint, 2>{t.ancho, t.alto}).pon("formato", nombreDe(GLenum(t.formato)));
        json.pon("reduce", nombreDe(GLenum(t.reduce))).pon("amplia", nombreDe(GLenum(t.amplia)));
        json.pon("repite", nombreDe(GLenum(t.repiteS)) + ", " + nombreDe(GLenum(t.repiteT)));
        texturas.push_back(json.pon("incompleta", t.incompleta));
    }
    return Json()
        .pon("indices", entero(GL_ELEMENT_ARRAY_BUFFER_BINDING))
        .pon("vao", entero(GL_VERTEX_ARRAY_BINDING))
        .pon("atributos", atributos)
        .pon("uniformes", uniformes)
        .pon("texturas", texturas);
}

} // namespace explica
