#include "trazo.h"
#include "shader.h"
#include "ventana.h"
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace {

const int LADOS_PUNTO = 20;
const float LARGO_PUNTA = 4.5f, ANCHO_PUNTA = 1.9f; // de una flecha, en grosores; el ancho es la mitad

/// De un punto normalizado a píxeles del viewport, y al revés; z no cambia.
struct Pantalla {
    glm::vec3 porUnidad; // píxeles en una unidad de coordenadas normalizadas
    Pantalla() {
        GLint v[4];
        glGetIntegerv(GL_VIEWPORT, v);
        porUnidad = {0.5f * static_cast<float>(std::max(v[2], 1)),
                     0.5f * static_cast<float>(std::max(v[3], 1)), 1};
    }
    glm::vec3 aPixeles(const glm::vec4 &recortado) const {
        return glm::vec3(recortado) / recortado.w * porUnidad;
    }
};

float pixeles(float grosor) {
    return std::max(grosor * altoUtil() / 1080, 1.0f);
}

/// Corta el segmento por el plano cerca (z = −w en coordenadas de recortado). Devuelve si queda algo.
bool cortaPorCerca(glm::vec4 &a, glm::vec4 &b) {
    const float da = a.z + a.w, db = b.z + b.w;
    if (da < 0 && db < 0)
        return false;
    if (da < 0)
        a = glm::mix(a, b, da / (da - db));
    else if (db < 0)
        b = glm::mix(b, a, db / (db - da));
    return a.w > 0 && b.w > 0;
}

/// Perpendicular en la pantalla al segmento, de largo `medio`; 0 si el segmento no se ve largo.
glm::vec3 perpendicular(const glm::vec3 &a, const glm::vec3 &b, float medio) {
    const glm::vec2 d(b - a);
    const float largo = glm::length(d);
    return largo > 0 ? glm::vec3(-d.y, d.x, 0) * (medio / largo) : glm::vec3(0);
}

struct Trazo {
    Pantalla pantalla;
    float medio; // grosor, en píxeles
    std::vector<glm::vec3> vertices;

    explicit Trazo(float grosor) : medio(0.5f * pixeles(grosor)) {
    }
    void triangulo(const glm::vec3 &a, const glm::vec3 &b, const glm::vec3 &c) {
        for (const glm::vec3 &v : {a, b, c})
            vertices.push_back(v / pantalla.porUnidad);
    }
    /// La banda del segmento, en píxeles, alargada por los dos extremos.
    void banda(const glm::vec3 &a, const glm::vec3 &b, float alarga) {
        const glm::vec3 n = perpendicular(a, b, medio), d = glm::vec3(n.y, -n.x, 0) * (alarga / medio);
        triangulo(a - d + n, a - d - n, b + d - n);
        triangulo(a - d + n, b + d - n, b + d + n);
    }
};

} // namespace

void pintaTriangulos(const std::vector<glm::vec3> &vertices, const glm::vec3 &color) {
    static GLuint programa = 0, vao, bufer;
    GLint programaPrevio, vaoPrevio, buferPrevio;
    glGetIntegerv(GL_CURRENT_PROGRAM, &programaPrevio);
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &vaoPrevio);
    glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &buferPrevio);
    const GLboolean oculta = glIsEnabled(GL_CULL_FACE);
    if (!programa) {
        programa = creaPrograma("common/trazo.vert", "common/trazo.frag");
        glGenVertexArrays(1, &vao);
        glGenBuffers(1, &bufer);
    }
    glUseProgram(programa);
    envia(programa, "colorTrazo", color);
    glBindVertexArray(vao);
    glBindBuffer(GL_ARRAY_BUFFER, bufer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(glm::vec3)),
                 vertices.data(), GL_STREAM_DRAW);
    glVertexAttribPointer(ATRIBUTO_POSICION, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(ATRIBUTO_POSICION);
    glDisable(GL_CULL_FACE);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
    if (oculta)
        glEnable(GL_CULL_FACE);
    glUseProgram(static_cast<GLuint>(programaPrevio));
    glBindVertexArray(static_cast<GLuint>(vaoPrevio));
    glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(buferPrevio));
}

void trazaSegmentos(const std::vector<glm::vec3> &extremos, const glm::mat4 &transformacion,
                    const glm::vec3 &color, float grosor) {
    Trazo t(grosor);
    for (std::size_t i = 0; i + 1 < extremos.size(); i += 2) {
        glm::vec4 a = transformacion * glm::vec4(extremos[i], 1),
                  b = transformacion * glm::vec4(extremos[i + 1], 1);
        if (cortaPorCerca(a, b)) // alargados medio grosor, los segmentos que se encuentran no dejan mella
            t.banda(t.pantalla.aPixeles(a), t.pantalla.aPixeles(b), t.medio);
    }
    pintaTriangulos(t.vertices, color);
}

void trazaPolilinea(const std::vector<glm::vec3> &puntos, const glm::mat4 &transformacion,
                    const glm::vec3 &color, float grosor, bool cerrada) {
    Trazo t(grosor);
    const std::size_t n = puntos.size(), tramos = n < 2 ? 0 : cerrada ? n : n - 1;
    const auto recortado = [&](std::size_t i) { return transformacion * glm::vec4(puntos[i % n], 1); };
    for (std::size_t i = 0; i < tramos; ++i) {
        glm::vec4 a = recortado(i), b = recortado(i + 1), c = recortado(i + 2);
        if (!cortaPorCerca(a, b))
            continue;
        const glm::vec3 p = t.pantalla.aPixeles(a), q = t.pantalla.aPixeles(b);
        t.banda(p, q, 0);
        glm::vec4 finDelTramo = b;
        if ((!cerrada && i + 2 == n) || b != recortado(i + 1) || !cortaPorCerca(finDelTramo, c))
            continue; // no hay con quién empalmar
        const glm::vec3 siguiente = t.pantalla.aPixeles(c), n1 = perpendicular(p, q, t.medio),
                        n2 = perpendicular(q, siguiente, t.medio);
        // uno llena la cuña de fuera del giro y el otro cae dentro; comparten con la banda su lado entero, sin grietas
        t.triangulo(q - n1, q + n1, q + n2);
        t.triangulo(q + n1, q - n1, q - n2);
    }
    pintaTriangulos(t.vertices, color);
}

void trazaPuntos(const std::vector<glm::vec3> &puntos, const glm::mat4 &transformacion,
                 const glm::vec3 &color, float diametro) {
    Trazo t(diametro);
    for (const glm::vec3 &punto : puntos) {
        const glm::vec4 p = transformacion * glm::vec4(punto, 1);
        if (p.w <= 0 || p.z < -p.w)
            continue;
        const glm::vec3 centro = t.pantalla.aPixeles(p);
        const auto borde = [&](int k) {
            const float angulo = glm::two_pi<float>() * static_cast<float>(k) / LADOS_PUNTO;
            return centro + t.medio * glm::vec3(std::cos(angulo), std::sin(angulo), 0);
        };
        for (int k = 0; k < LADOS_PUNTO; ++k)
            t.triangulo(centro, borde(k), borde(k + 1));
    }
    pintaTriangulos(t.vertices, color);
}

void trazaFlecha(const glm::vec3 &a, const glm::vec3 &b, const glm::mat4 &transformacion,
                 const glm::vec3 &color, float grosor) {
    Trazo t(grosor);
    glm::vec4 desde = transformacion * glm::vec4(a, 1), hasta = transformacion * glm::vec4(b, 1);
    const bool puntaDelante = hasta.z >= -hasta.w;
    if (!cortaPorCerca(desde, hasta))
        return;
    const glm::vec3 p = t.pantalla.aPixeles(desde), q = t.pantalla.aPixeles(hasta);
    const float largo = glm::length(glm::vec2(q - p));
    // una flecha corta es toda punta
    const float punta = puntaDelante ? std::min(2 * LARGO_PUNTA * t.medio, largo) : 0;
    const glm::vec3 base = largo > 0 ? glm::mix(q, p, punta / largo) : q;
    const glm::vec3 n = perpendicular(p, q, punta * ANCHO_PUNTA / LARGO_PUNTA);
    t.banda(p, base, 0);
    t.triangulo(base + n, base - n, q);
    pintaTriangulos(t.vertices, color);
}
