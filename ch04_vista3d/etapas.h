// Un vértice por las etapas del pipeline (ejercicio 4.1) y el recortado de un polígono en coordenadas homogéneas.
// Sin OpenGL; lo usa etapas_pipeline. Todo en doble.
#pragma once
#include "texto.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <string>
#include <vector>

/// Las matrices de un vértice, en el orden en que se aplican. En el libro, M_M, M_C, M_Proy y M_vp.
struct Matrices {
    glm::dmat4 M, camara, proyeccion, viewport;
};

/// Lo que vale un vértice al salir de cada etapa. `ndc` y `ventana`, solo si está dentro del volumen de la
/// vista: lo que se recorta no llega a la división perspectiva.
struct Etapas {
    glm::dvec4 objeto, mundo, camara, recortado;
    bool dentro;
    glm::dvec3 ndc, ventana; // ventana.z es la profundidad
};

/// −w ≤ x, y, z ≤ w.
inline bool estaDentro(const glm::dvec4 &r) {
    return std::fabs(r.x) <= r.w && std::fabs(r.y) <= r.w && std::fabs(r.z) <= r.w;
}

/// División perspectiva (§4.5).
inline glm::dvec3 divide(const glm::dvec4 &r) {
    return glm::dvec3(r) / r.w;
}
inline std::vector<glm::vec3> divide(const std::vector<glm::dvec4> &puntos) {
    std::vector<glm::vec3> divididos;
    for (const glm::dvec4 &p : puntos)
        divididos.push_back(divide(p));
    return divididos;
}

/// Lleva un vértice del objeto hasta la ventana (§4.5, ecuación 4.4).
inline Etapas recorre(const glm::dvec3 &vertice, const Matrices &m) {
    Etapas e{};
    e.objeto = glm::dvec4(vertice, 1);
    e.mundo = m.M * e.objeto;
    e.camara = m.camara * e.mundo;
    e.recortado = m.proyeccion * e.camara;
    e.dentro = estaDentro(e.recortado) && e.recortado.w > 0;
    if (e.dentro) {
        e.ndc = divide(e.recortado);
        e.ventana = m.viewport * glm::dvec4(e.ndc, 1);
    }
    return e;
}

/// Lo que queda de un polígono convexo al recortarlo con los seis planos del volumen de la vista (Sutherland y
/// Hodgman). Se hace antes de dividir por w, en coordenadas de recortado: así vale también para lo que está
/// detrás del ojo, con w < 0. Vacío si no queda nada.
inline std::vector<glm::dvec4> recorta(std::vector<glm::dvec4> poligono) {
    for (int eje = 0; eje < 3; ++eje)
        for (const double signo : {-1.0, 1.0}) {
            const auto distancia = [&](const glm::dvec4 &v) { return v.w + signo * v[eje]; };
            std::vector<glm::dvec4> dentro;
            for (std::size_t k = 0; k < poligono.size(); ++k) {
                const glm::dvec4 &a = poligono[k], &b = poligono[(k + 1) % poligono.size()];
                const double da = distancia(a), db = distancia(b);
                if (da >= 0)
                    dentro.push_back(a);
                if ((da >= 0) != (db >= 0))
                    dentro.push_back((da * b - db * a) / (da - db));
            }
            poligono = dentro;
        }
    return poligono;
}

/// Lo mismo, de un polígono del objeto.
inline std::vector<glm::dvec4> recorta(const std::vector<glm::vec3> &poligono, const Matrices &m) {
    std::vector<glm::dvec4> enRecortado;
    for (const glm::vec3 &v : poligono)
        enRecortado.push_back(recorre(v, m).recortado);
    return recorta(enRecortado);
}

/// Área que ocupa en la ventana un polígono dado en coordenadas de recortado, en píxeles cuadrados.
inline double areaVentana(const std::vector<glm::dvec4> &poligono, const glm::dmat4 &viewport) {
    double area = 0;
    for (std::size_t k = 2; k < poligono.size(); ++k) {
        const auto enVentana = [&](std::size_t v) { return viewport * glm::dvec4(divide(poligono[v]), 1); };
        const glm::dvec4 a = enVentana(0);
        const glm::dvec4 u = enVentana(k - 1) - a, v = enVentana(k) - a;
        area += 0.5 * (u.x * v.y - u.y * v.x);
    }
    return std::fabs(area);
}

/// Una malla con la transformación del modelo.
struct Modelo {
    std::vector<glm::vec3> vertices;
    std::vector<unsigned> indices;
    glm::dmat4 M;
};

/// Profundidad del triángulo abc (en coordenadas de ventana) en un punto, o 1, la máxima, si no cae en él: es lineal en
/// la ventana.
inline double profundidadEn(const glm::dvec2 &punto, const glm::dvec3 &a, const glm::dvec3 &b,
                            const glm::dvec3 &c) {
    const auto cruz = [](const glm::dvec2 &u, const glm::dvec2 &v) { return u.x * v.y - u.y * v.x; };
    const glm::dvec2 ab(b - a), ac(c - a), ap = punto - glm::dvec2(a);
    const double s = cruz(ap, ac) / cruz(ab, ac), t = cruz(ab, ap) / cruz(ab, ac);
    return s >= 0 && t >= 0 && s + t <= 1 ? a.z + s * (b.z - a.z) + t * (c.z - a.z) : 1;
}

/// Lo que guarda el buffer de profundidad en el píxel de un vértice cuando se han pintado los triángulos que no lo
/// tocan: la menor de sus profundidades, o la máxima, 1, si ninguno cae ahí.
inline double profundidadGuardada(const std::vector<Modelo> &cuerpos, const Matrices &m, const Etapas &e) {
    double menor = 1;
    for (const Modelo &c : cuerpos)
        for (std::size_t i = 0; i < c.indices.size(); i += 3) {
            std::vector<glm::dvec4> poligono;
            bool toca = false;
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::dvec4 mundo = c.M * glm::dvec4(c.vertices[c.indices[i + k]], 1);
                toca = toca || mundo == e.mundo;
                poligono.push_back(m.proyeccion * (m.camara * mundo));
            }
            if (toca)
                continue;
            poligono = recorta(poligono);
            const auto enVentana = [&](std::size_t k) {
                return glm::dvec3(m.viewport * glm::dvec4(divide(poligono[k]), 1));
            };
            for (std::size_t k = 2; k < poligono.size(); ++k)
                menor = std::min(menor, profundidadEn(glm::dvec2(e.ventana), enVentana(0), enVentana(k - 1),
                                                      enVentana(k)));
        }
    return menor;
}

/// «clave: valores», con las cifras de un float.
inline std::string linea(const char *clave, const std::vector<double> &valores) {
    std::string texto = clave + std::string(":");
    for (const double v : valores)
        texto += formatea(" %.9g", v);
    return texto + "\n";
}

/// Una línea por etapa, con el test de profundidad (listado 4.1); las que no alcanza un vértice de fuera del volumen no
/// salen. Después, los lados y el área de lo que queda del polígono, si lo hay.
inline std::string describeEtapas(const Etapas &e, double guardada, const std::vector<glm::dvec4> &poligono,
                                  const glm::dmat4 &viewport) {
    const auto cuatro = [](const glm::dvec4 &v) { return std::vector<double>{v.x, v.y, v.z, v.w}; };
    std::string texto = linea("objeto", cuatro(e.objeto)) + linea("mundo", cuatro(e.mundo)) +
                        linea("cámara", cuatro(e.camara)) + linea("recortado", cuatro(e.recortado));
    if (e.dentro)
        texto += linea("NDC", {e.ndc.x, e.ndc.y, e.ndc.z}) + linea("ventana", {e.ventana.x, e.ventana.y}) +
                 linea("píxel", {std::floor(e.ventana.x), std::floor(e.ventana.y)}) +
                 linea("profundidad", {e.ventana.z}) + linea("guardada", {guardada}) +
                 (e.ventana.z < guardada ? "se pinta\n" : "se descarta\n");
    else
        texto += "fuera: se recorta\n";
    if (!poligono.empty())
        texto += linea("lados", {double(poligono.size())}) +
                 linea("área en píxeles", {areaVentana(poligono, viewport)});
    return texto;
}
