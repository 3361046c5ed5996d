#include "trazo.h"
#include "encima.h"
#include "proyeccion.h"
#include <GL/glew.h>
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace {

const int LADOS_PUNTO = 20;
const float LARGO_PUNTA = 4.5f, ANCHO_PUNTA = 1.9f; // de una flecha, en grosores; el ancho es la mitad
// Todo se corre esta fracción de píxel: un borde que caiga justo en el centro de los píxeles lo pinta cada controlador
// a su manera.
const glm::vec2 FUERA_DEL_EMPATE(1 / 64.0f, 1 / 48.0f);

float pixeles(float grosor) {
    return std::max(grosor * altoUtil() / 1080, 1.0f);
}

// Corta el segmento por el plano cerca (z = −w en coordenadas de recortado). Devuelve si queda algo.
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

// Perpendicular en la pantalla al segmento, de largo `medio`; 0 si el segmento no se ve largo.
glm::vec3 perpendicular(const glm::vec3 &a, const glm::vec3 &b, float medio) {
    const glm::vec2 d(b - a);
    const float largo = glm::length(d);
    return largo > 0 ? glm::vec3(-d.y, d.x, 0) * (medio / largo) : glm::vec3(0);
}

// Un trazo, en píxeles desde el centro del panel: lo que se apunta de él y los triángulos que lo pintan.
class Trazo {
    glm::vec3 porUnidad; // píxeles en una unidad de coordenadas normalizadas; z no cambia
    Pincelada pincelada;
    std::vector<VerticePintado> triangulos;

public:
    const float medio; // grosor

    Trazo(const char *tipo, const glm::vec3 &color, float grosor)
        : pincelada{tipo, color, pixeles(grosor), {}, ""}, medio(0.5f * pincelada.talla) {
        GLint v[4];
        glGetIntegerv(GL_VIEWPORT, v);
        porUnidad = {0.5f * float(std::max(v[2], 1)), 0.5f * float(std::max(v[3], 1)), 1};
    }
    glm::vec3 aPixeles(const glm::vec4 &recortado) const {
        return glm::vec3(recortado) / recortado.w * porUnidad;
    }
    // Lo que miden, a lo alto, esos píxeles en coordenadas normalizadas.
    float enUnidades(float pixeles) const {
        return pixeles / porUnidad.y;
    }
    void apunta(const glm::vec3 &punto) {
        pincelada.puntos.push_back(punto);
    }
    void triangulo(const glm::vec3 &a, const glm::vec3 &b, const glm::vec3 &c) {
        for (const glm::vec3 &v : {a, b, c})
            triangulos.push_back({(v + glm::vec3(FUERA_DEL_EMPATE, 0)) / porUnidad, {}});
    }
    // La banda del segmento, alargada por los dos extremos. Si va por un borde del panel, que se comería la mitad,
    // entra en él.
    void banda(glm::vec3 a, glm::vec3 b, float alarga) {
        for (int eje = 0; eje < 2; ++eje)
            for (const float borde : {-porUnidad[eje], porUnidad[eje]})
                if (std::fabs(a[eje] - borde) < medio && std::fabs(b[eje] - borde) < medio)
                    a[eje] = b[eje] = borde - std::copysign(medio, borde);
        const glm::vec3 n = perpendicular(a, b, medio);
        const glm::vec3 d = glm::vec3(n.y, -n.x, 0) * (alarga / medio);
        triangulo(a - d + n, a - d - n, b + d - n);
        triangulo(a - d + n, b + d - n, b + d + n);
    }
    // Lo apuntado y lo pintado hasta ahora, y vuelta a empezar.
    void pinta() {
        if (!pincelada.puntos.empty())
            pintaEncima(pincelada, triangulos, {{pincelada.color}}, true);
        pincelada.puntos.clear();
        triangulos.clear();
    }
};

} // namespace

void trazaSegmentos(const std::vector<glm::vec3> &extremos, const glm::mat4 &transformacion,
                    const glm::vec3 &color, float grosor) {
    Trazo t("segmentos", color, grosor);
    for (std::size_t i = 0; i + 1 < extremos.size(); i += 2) {
        glm::vec4 a = transformacion * glm::vec4(extremos[i], 1),
                  b = transformacion * glm::vec4(extremos[i + 1], 1);
        if (!cortaPorCerca(a, b))
            continue;
        const glm::vec3 p = t.aPixeles(a), q = t.aPixeles(b);
        t.apunta(p);
        t.apunta(q);
        t.banda(p, q, t.medio); // alargados medio grosor, los segmentos que se encuentran no dejan mella
    }
    t.pinta();
}

void trazaPolilinea(const std::vector<glm::vec3> &puntos, const glm::mat4 &transformacion,
                    const glm::vec3 &color, float grosor, bool cerrada) {
    Trazo t("polilinea", color, grosor);
    const std::size_t n = puntos.size();
    const std::size_t unos = cerrada ? n : n - 1;
    const std::size_t tramos = n < 2 ? 0 : unos;
    const auto recortado = [&](std::size_t i) { return transformacion * glm::vec4(puntos[i % n], 1); };
    bool sigue = false; // la línea apuntada llega al principio del tramo
    for (std::size_t i = 0; i < tramos; ++i) {
        glm::vec4 a = recortado(i), b = recortado(i + 1), c = recortado(i + 2);
        if (!cortaPorCerca(a, b)) {
            sigue = false;
            continue;
        }
        const glm::vec3 p = t.aPixeles(a), q = t.aPixeles(b);
        if (!sigue || a != recortado(i)) {
            t.pinta(); // el plano cerca la parte en dos
            t.apunta(p);
        }
        t.apunta(q);
        t.banda(p, q, 0);
        sigue = b == recortado(i + 1);
        glm::vec4 finDelTramo = b;
        if ((!cerrada && i + 2 == n) || !sigue || !cortaPorCerca(finDelTramo, c))
            continue; // no hay con quién empalmar
        const glm::vec3 siguiente = t.aPixeles(c), n1 = perpendicular(p, q, t.medio);
        const glm::vec3 n2 = perpendicular(q, siguiente, t.medio);
        // uno llena la cuña de fuera del giro y el otro cae dentro; comparten con la banda su lado entero, sin grietas
        t.triangulo(q - n1, q + n1, q + n2);
        t.triangulo(q + n1, q - n1, q - n2);
    }
    t.pinta();
}

std::vector<glm::vec3> circunferencia(float radio, int tramos) {
    std::vector<glm::vec3> puntos;
    for (int i = 0; i < tramos; ++i) {
        const float angulo = glm::two_pi<float>() * float(i) / float(tramos);
        puntos.push_back({radio * std::cos(angulo), radio * std::sin(angulo), 0});
    }
    return puntos;
}

std::vector<glm::vec3> cuadricula(float lado, float casilla) {
    std::vector<glm::vec3> extremos;
    const float borde = lado / 2;
    for (float p = -borde; p <= borde; p += casilla)
        extremos.insert(extremos.end(), {{p, -borde, 0}, {p, borde, 0}, {-borde, p, 0}, {borde, p, 0}});
    return extremos;
}

void trazaPuntos(const std::vector<glm::vec3> &puntos, const glm::mat4 &transformacion,
                 const glm::vec3 &color, float diametro) {
    Trazo t("puntos", color, diametro);
    const glm::mat4 filas = glm::transpose(transformacion);
    for (const glm::vec3 &punto : puntos) {
        const glm::vec4 p = transformacion * glm::vec4(punto, 1);
        if (p.w <= 0 || p.z < -p.w)
            continue;
        glm::vec3 centro = t.aPixeles(p);
        t.apunta(centro);
        // el disco se adelanta su radio hacia el ojo, y la superficie en que está no se lo come: lo que cambia la
        // profundidad al alejarse es a lo que cambia la altura al subir como uno de estos gradientes es al otro
        const auto cambio = [&](int eje) {
            return glm::length(glm::vec3(filas[eje] - filas[3] * (p[eje] / p.w)));
        };
        centro.z = std::max(centro.z - t.enUnidades(t.medio) * cambio(2) / cambio(1), -1.0f);
        const auto borde = [&](int k) {
            const float angulo = glm::two_pi<float>() * float(k) / LADOS_PUNTO;
            return centro + t.medio * glm::vec3(std::cos(angulo), std::sin(angulo), 0);
        };
        for (int k = 0; k < LADOS_PUNTO; ++k)
            t.triangulo(centro, borde(k), borde(k + 1));
    }
    t.pinta();
}

void trazaFlecha(const glm::vec3 &a, const glm::vec3 &b, const glm::mat4 &transformacion,
                 const glm::vec3 &color, float grosor) {
    Trazo t("flecha", color, grosor);
    glm::vec4 desde = transformacion * glm::vec4(a, 1), hasta = transformacion * glm::vec4(b, 1);
    const bool puntaDelante = hasta.z >= -hasta.w;
    if (!cortaPorCerca(desde, hasta))
        return;
    const glm::vec3 p = t.aPixeles(desde), q = t.aPixeles(hasta);
    t.apunta(p);
    t.apunta(q);
    const float largo = glm::length(glm::vec2(q - p));
    // una flecha corta es toda punta
    const float punta = puntaDelante ? std::min(2 * LARGO_PUNTA * t.medio, largo) : 0;
    const glm::vec3 base = largo > 0 ? glm::mix(q, p, punta / largo) : q;
    const glm::vec3 n = perpendicular(p, q, punta * ANCHO_PUNTA / LARGO_PUNTA);
    t.banda(p, base, 0);
    t.triangulo(base + n, base - n, q);
    t.pinta();
}

void trazaPoligono(const std::vector<glm::vec3> &puntos, const glm::mat4 &transformacion,
                   const glm::vec3 &color) {
    Trazo t("poligono", color, 0);
    std::vector<glm::vec3> vertices;
    for (const glm::vec3 &punto : puntos) {
        const glm::vec4 p = transformacion * glm::vec4(punto, 1);
        if (p.w <= 0 || p.z < -p.w)
            return; // los del lado de acá del plano cerca no se pintan
        vertices.push_back(t.aPixeles(p));
        t.apunta(vertices.back());
    }
    for (std::size_t i = 2; i < vertices.size(); ++i)
        t.triangulo(vertices[0], vertices[i - 1], vertices[i]);
    t.pinta();
}
