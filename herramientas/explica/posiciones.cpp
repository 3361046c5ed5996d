#include "posiciones.h"
#include "sueltas.h"
#include <algorithm>
#include <regex>

namespace explica {

namespace {
const std::size_t VERTICES = 256, TODOS = 100000; // los que se miran, si son demasiados para mirarlos todos
const std::size_t SE_ENSENAN = 1500;
} // namespace

Malla posicionesDe(const Orden &orden) {
    const GLuint programa = GLuint(entero(GL_CURRENT_PROGRAM));
    std::optional<Primitivas> p = primitivasDe(orden);
    const std::vector<GLuint> shaders = shadersDe(programa);
    if (!p || p->indices.empty() || shaders.empty() || orden.instancias != 1)
        return {};
    const Guardado guardado;
    const GLchar *const nombre = "gl_Position";
    const GLuint otro = gemelo(programa, "posiciones", [&] {
        return enlazaComo(programa, shaders, [&](GLuint suyo) {
            glTransformFeedbackVaryings(suyo, 1, &nombre, GL_INTERLEAVED_ATTRIBS);
        });
    });
    if (!otro)
        return {};
    Malla malla;
    if (p->modo == GL_TRIANGLES)
        malla.triangulos = p->indices;
    p->modo = GL_POINTS, p->vertices = 1;
    std::sort(p->indices.begin(), p->indices.end()); // cada vértice, una vez
    p->indices.erase(std::unique(p->indices.begin(), p->indices.end()), p->indices.end());
    const std::size_t hay = p->indices.size(), caben = hay > TODOS ? VERTICES : hay;
    for (GLuint &i : malla.triangulos)
        i = GLuint(std::lower_bound(p->indices.begin(), p->indices.end(), i) - p->indices.begin());
    if (caben < hay)
        malla.triangulos.clear();
    for (std::size_t i = 0; i < caben; ++i) // de toda la orden
        p->indices[i] = p->indices[i * hay / caben];
    p->indices.resize(caben);
    malla.vertices = p->indices;
    const Sueltas s(*p);
    glUseProgram(otro);
    malla.puntos = s.recoge<Puntos::value_type>(0, s.primitivas.cuantas());
    return malla;
}

Json mallaEnJson(const Orden &orden) {
    const Malla malla = posicionesDe(orden);
    const std::vector<Atributo> atributos = cableadoActual().atributos;
    const auto esPosicion = [](const Atributo &a) {
        return !a.primeros.empty() && a.componentes > 1 &&
               std::regex_search(a.variable.nombre, std::regex("[Pp]os|[Vv]ert"));
    };
    const auto suya = std::find_if(atributos.begin(), atributos.end(), esPosicion);
    Json json;
    if (suya == atributos.end() || malla.triangulos.empty() || malla.puntos.size() > SE_ENSENAN)
        return json;
    std::vector<std::array<float, 3>> antes;
    for (const GLuint v : malla.vertices) {
        if (v >= suya->primeros.size())
            return json;
        const auto &p = suya->primeros[v];
        antes.push_back({p[0], p[1], p[2]});
    }
    return json.pon("antes", antes).pon("despues", malla.puntos).pon("triangulos", malla.triangulos);
}

} // namespace explica
