#include "primitivas.h"
#include <algorithm>

namespace explica {
namespace {

using Indices = std::vector<GLuint>;

// Una tirada de vértices sin cortes.
void anade(GLenum modo, const Indices &v, Indices &salen) {
    const std::size_t n = v.size();
    const auto pon = [&](std::initializer_list<std::size_t> cuales) {
        for (const std::size_t i : cuales)
            salen.push_back(v[i]);
    };
    switch (modo) {
    case GL_LINE_LOOP:
    case GL_LINE_STRIP:
        for (std::size_t i = 1; i < n; ++i)
            pon({i - 1, i});
        if (modo == GL_LINE_LOOP && n > 1)
            pon({n - 1, 0});
        break;
    case GL_TRIANGLE_STRIP:
        for (std::size_t i = 2; i < n; ++i)
            i % 2 == 0 ? pon({i - 2, i - 1, i}) : pon({i - 1, i - 2, i});
        break;
    case GL_TRIANGLE_FAN:
        for (std::size_t i = 2; i < n; ++i)
            pon({0, i - 1, i});
        break;
    default: salen.insert(salen.end(), v.begin(), v.end() - long(n % (modo == GL_TRIANGLES ? 3 : modo + 1)));
    }
}

} // namespace

std::optional<Primitivas> sueltas(GLenum modo, const Indices &indices, std::optional<GLuint> reinicia) {
    Primitivas p;
    if (modo > GL_TRIANGLE_FAN)
        return {};
    if (modo != GL_POINTS)
        p.modo = modo < GL_TRIANGLES ? GL_LINES : GL_TRIANGLES, p.vertices = modo < GL_TRIANGLES ? 2 : 3;
    auto desde = indices.begin();
    while (desde != indices.end()) {
        const auto hasta = reinicia ? std::find(desde, indices.end(), *reinicia) : indices.end();
        anade(modo, Indices(desde, hasta), p.indices);
        desde = hasta == indices.end() ? hasta : hasta + 1;
    }
    return p;
}

std::string nombrePrimitiva(const Primitivas &p) {
    return p.vertices == 1 ? "punto" : p.vertices == 2 ? "segmento" : "triángulo";
}

std::string cuantasSon(const Primitivas &p) {
    return std::to_string(p.cuantas()) + " " + nombrePrimitiva(p) + (p.cuantas() == 1 ? "" : "s");
}

} // namespace explica
