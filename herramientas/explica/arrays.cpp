#include "arrays.h"
#include "nombres.h"
#include <algorithm>

namespace explica {
namespace {

const std::string EN_BYTES =
    "El paso y el desplazamiento son en bytes: sizeof(Vertice) y offsetof(Vertice, normal).";

std::string texto(std::intptr_t numero) {
    return std::to_string(numero);
}

// Lo que suele haber detrás de un buffer en que no cabe lo que se le pide.
std::string pista(GLint bytes) {
    const std::string cuantos = "glBufferData quiere bytes: v.size() * sizeof(v[0]).";
    return bytes == 8    ? "8 bytes es lo que ocupa un puntero. " + cuantos
           : bytes == 24 ? "24 bytes es lo que ocupa un std::vector. " + cuantos
                         : cuantos;
}

std::intptr_t ocupa(const Atributo &a) {
    return std::intptr_t(bytesDe(a.tipo)) * std::clamp(a.componentes, 1, 4);
}
std::intptr_t paso(const Atributo &a) {
    return a.paso ? a.paso : ocupa(a);
}

// De los índices, cuántos de cada `cada` no son 0 más que el primero.
bool sobranCeros(const std::vector<unsigned char> &bytes, std::size_t deUno, std::size_t deVerdad) {
    bool alguno = false;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        if (i % deVerdad >= deUno && bytes[i])
            return false;
        alguno = alguno || bytes[i];
    }
    return alguno && bytes.size() >= 6 * deUno;
}

Dicho deIndices(const Orden &o, const Tramo &t, GLint hay) {
    const auto suyos = std::intptr_t(bytesDe(o.tipoIndice)),
               desde = reinterpret_cast<std::intptr_t>(t.indices);
    const std::intptr_t pide = desde + suyos * t.vertices;
    const std::string tipo = nombreDe(o.tipoIndice);
    if (pide > hay)
        return {"se piden " + texto(t.vertices) + " índices " + tipo + ", que llegan al byte " + texto(pide) +
                    ", y su buffer tiene " + texto(hay) + " bytes",
                hay == desde + 2 * t.vertices ? "Parecen GL_UNSIGNED_SHORT: díselo a glDrawElements."
                                              : pista(hay)};
    std::vector<unsigned char> bytes(std::size_t(suyos * t.vertices));
    glGetBufferSubData(GL_ELEMENT_ARRAY_BUFFER, desde, GLsizeiptr(bytes.size()), bytes.data());
    if (suyos < 4 && desde + 4 * t.vertices <= hay && sobranCeros(bytes, std::size_t(suyos), 4))
        return {"los índices parecen GL_UNSIGNED_INT y se dibujan como " + tipo +
                    ": son 0 todos menos uno de cada " + texto(4 / suyos),
                "El tipo que se dice en glDrawElements es el que tienen en el buffer."};
    return {};
}

Dicho deAtributo(const Atributo &a, const std::vector<GLuint> &indices) {
    const std::string quien = "«" + a.variable.nombre + "»";
    const auto numero = std::intptr_t(bytesDe(a.tipo));
    for (const auto &[que, vale] :
         {std::pair("paso", std::intptr_t(a.paso)), {"desplazamiento", a.desplazamiento}})
        if (vale % numero)
            return {"el " + std::string(que) + " de " + quien + ", " + texto(vale) +
                        " bytes, no es múltiplo de los " + texto(numero) + " de un " + nombreDe(a.tipo),
                    EN_BYTES};
    if (a.paso && a.paso < ocupa(a))
        return {"el paso de " + quien + " es de " + texto(a.paso) + " bytes y cada uno ocupa " +
                    texto(ocupa(a)),
                EN_BYTES};
    const auto [menor, mayor] = std::minmax_element(indices.begin(), indices.end());
    const std::intptr_t hasta = a.desplazamiento + std::intptr_t(*mayor) * paso(a) + ocupa(a);
    if (a.bytes >= hasta)
        return {};
    const std::intptr_t caben =
        std::max((a.bytes - a.desplazamiento - ocupa(a) + paso(a)) / paso(a), std::intptr_t(0));
    return {"se usa el vértice " + texto(*mayor) + " y en el buffer de " + quien + ", de " + texto(a.bytes) +
                " bytes, caben " + texto(caben) + ", del 0 en adelante",
            *menor == 1 && caben == *mayor ? "¿Empiezan los índices en 1, como en un OBJ? Aquí empiezan en 0."
                                           : pista(a.bytes)};
}

// Dos que van mezclados en un buffer: los dos en cada vértice, uno detrás de otro.
Dicho deDos(const Atributo &a, const Atributo &b, std::intptr_t vertices) {
    const std::intptr_t separan = b.desplazamiento - a.desplazamiento;
    if (a.bufer != b.bufer || separan <= 0 || separan >= vertices * paso(a) ||
        (paso(a) == paso(b) && separan + ocupa(b) <= paso(a)))
        return {};
    const std::string los =
        "«" + a.variable.nombre + "» y «" + b.variable.nombre + "» van en el mismo buffer";
    if (paso(a) != paso(b))
        return {los + " y el paso de uno es de " + texto(paso(a)) + " bytes y el del otro de " +
                    texto(paso(b)),
                EN_BYTES};
    return {los + ", el segundo " + texto(separan) + " bytes detrás, y con un paso de " + texto(paso(a)) +
                " se pisan con los del vértice siguiente",
            EN_BYTES};
}

} // namespace

std::vector<Dicho> deArrays(const Cableado &c, const Orden &o, const std::vector<GLuint> &indices) {
    std::vector<Dicho> dichos;
    const auto pon = [&](const Dicho &d) {
        if (!d.first.empty())
            dichos.push_back(d);
    };
    const GLint ebo = entero(GL_ELEMENT_ARRAY_BUFFER_BINDING);
    const GLint hay = ebo ? contesta(glGetBufferParameteriv, GL_ELEMENT_ARRAY_BUFFER, GL_BUFFER_SIZE) : 0;
    if (o.tipoIndice != GL_NONE && !ebo)
        return {{"se dibuja con índices y el VAO no tiene ningún buffer de índices",
                 "Falta glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, …) con su VAO enlazado."}};
    for (const Tramo &t : o.tramos)
        if (o.tipoIndice != GL_NONE)
            pon(deIndices(o, t, hay));
        else if (ebo && t.vertices && (hay == 4 * t.vertices || hay == 2 * t.vertices) && o.instancias == 1)
            pon({"se dibujan " + texto(t.vertices) + " vértices seguidos y el VAO tiene otros tantos índices",
                 "Con índices se dibuja con glDrawElements, no con glDrawArrays."});
    if (!dichos.empty() || indices.empty())
        return dichos;
    std::vector<Atributo> suyos;
    for (const Atributo &a : c.atributos) {
        const auto donde = GLuint(a.variable.donde);
        if (a.activo && a.bufer && !contesta(glGetVertexAttribiv, donde, GL_VERTEX_ATTRIB_ARRAY_DIVISOR))
            suyos.push_back(a);
    }
    const auto vertices = std::intptr_t(*std::max_element(indices.begin(), indices.end())) + 1;
    for (const Atributo &a : suyos)
        for (const Atributo &b : suyos)
            if (dichos.empty())
                pon(deDos(a, b, vertices));
    for (const Atributo &a : suyos)
        if (dichos.empty())
            pon(deAtributo(a, indices));
    return dichos;
}

} // namespace explica
