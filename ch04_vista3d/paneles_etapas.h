// Los seis paneles de etapas_pipeline: dónde están, qué matrices usan, qué números llevan al lado y qué vértice señala
// el ratón. Sin OpenGL.
#pragma once
#include "aspecto.h"
#include "ch03_transformaciones/transformaciones.h"
#include "etapas.h"
#include "orbita.h"
#include "recuadro.h"
#include "texto.h"
#include "vista.h"
#include <array>

/// La cámara cuyo pipeline se enseña.
const double ANGULO = 0.62, CERCA = 3, LEJOS = 7.5; // el ángulo, en radianes
const glm::dvec3 OJO(2.0, 3.4, 5.4), INTERES(0.1, 0.7, 0);

/// `escena`: donde se dibuja; debajo, en lo que queda de `panel`, van los números. Lo del mundo pasa por `delMundo` a
/// las coordenadas que el panel enseña, y de ellas lo dibujan `camara` y `proyeccion`.
struct Panel {
    Recuadro panel, escena;
    glm::dmat4 delMundo = glm::dmat4(1);
    glm::mat4 camara = glm::mat4(1), proyeccion = glm::mat4(1);

    glm::mat4 aRecortado() const {
        return glm::mat4(glm::dmat4(proyeccion) * glm::dmat4(camara) * delMundo);
    }
};
enum { OBJETO, MUNDO, CAMARA, NDC, VENTANA, PROFUNDIDAD, PANELES };
const char *const TITULOS[PANELES] = {"1 objeto",        "2 mundo",   "3 cámara",
                                      "4 recortado, ÷w", "5 ventana", "6 test de z"};
/// El procesador programable que da lo que enseña el panel (figura 1.3): los demás son fijos.
const char *const PROCESADOR[PANELES] = {"", "vertex\nshader", "vertex\nshader", "", "fragment\nshader", ""};

inline std::array<Panel, PANELES> colocaPaneles(const std::vector<Recuadro> &donde) {
    std::array<Panel, PANELES> paneles;
    for (std::size_t k = 0; k < PANELES; ++k) {
        const Recuadro &r = donde[k];
        const int numeros = 7 * r.alto / 20;
        paneles[k].panel = r;
        paneles[k].escena = {r.x, r.y + numeros, r.ancho, r.alto - numeros};
    }
    return paneles;
}

/// Las matrices de todas las etapas, para una ventana en ese recuadro.
inline Matrices matricesEn(const Recuadro &ventana, const glm::dmat4 &M) {
    const double aspecto = double(std::max(ventana.ancho, 1)) / std::max(ventana.alto, 1);
    return {M, transformacionCamara(OJO, INTERES, {0, 1, 0}),
            proyeccionPerspectiva(anguloVertical(ANGULO, aspecto), aspecto, CERCA, LEJOS),
            transformacionViewport(ventana.x, ventana.y, ventana.ancho, ventana.alto)};
}

/// Pone en cada panel sus tres matrices. `orbita` es la de quien mira desde fuera; su distancia multiplica la del
/// panel.
inline void colocaMatrices(std::array<Panel, PANELES> &paneles, const Matrices &m, const Orbita &orbita,
                           float distanciaObjeto) {
    paneles[OBJETO].delMundo = glm::inverse(m.M);
    paneles[CAMARA].delMundo = m.camara;
    paneles[NDC].delMundo = paneles[VENTANA].delMundo = m.proyeccion * m.camara;
    const auto mira = [&](Panel &p, const glm::vec3 &centro, float distancia) {
        const double aspecto = double(std::max(p.escena.ancho, 1)) / std::max(p.escena.alto, 1);
        p.proyeccion = proyeccionPerspectiva(anguloVertical(0.5, aspecto), aspecto, 0.5, 100);
        p.camara = camaraOrbita({orbita.azimut, orbita.elevacion, orbita.distancia * distancia, centro});
    };
    mira(paneles[OBJETO], {0, 0.2f, 0}, distanciaObjeto);
    mira(paneles[MUNDO], {0.6f, 1.3f, 1.4f}, 16);
    mira(paneles[CAMARA], {0, 0, -3.7f}, 17);
    mira(paneles[NDC], {0, 0, 0}, 8);
    paneles[NDC].camara *=
        escalado({1, 1, -1}); // su base es a izquierdas: la profundidad crece hacia el fondo
}

/// El vértice que se ve más cerca del centro del píxel (x, y), a menos de un octavo de la escena en que está el
/// píxel; si no hay ninguno, `siNinguno`.
inline std::size_t verticeSenalado(const std::array<Panel, PANELES> &paneles, const glm::dmat4 &M,
                                   const std::vector<glm::vec3> &vertices, int x, int y,
                                   std::size_t siNinguno) {
    for (std::size_t i = 0; i < PROFUNDIDAD; ++i) {
        const Recuadro &r = paneles[i].escena;
        if (x < r.x || x >= r.x + r.ancho || y < r.y || y >= r.y + r.alto)
            continue;
        const glm::dmat4 viewport = transformacionViewport(r.x, r.y, r.ancho, r.alto);
        double menor = r.alto / 8.0;
        for (std::size_t k = 0; k < vertices.size(); ++k) {
            const glm::dvec4 v = glm::dmat4(paneles[i].aRecortado()) * M * glm::dvec4(vertices[k], 1);
            const glm::dvec4 w = viewport * glm::dvec4(divide(v), 1);
            const double distancia = std::hypot(w.x - x - 0.5, w.y - y - 0.5);
            if (v.w > 0 && distancia < menor) {
                menor = distancia;
                siNinguno = k;
            }
        }
    }
    return siNinguno;
}

/// Las cuatro esquinas de la cara z = −1 (cerca) o z = 1 (lejos) del volumen canónico.
inline std::vector<glm::vec3> caraVolumen(float z) {
    return {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}};
}

inline std::string conDosDecimales(const char *nombre, double valor) {
    return formatea("%s%.2f", nombre, aCentesimas(valor));
}

/// Los números de un panel, uno por línea. Lo que se recorta no llega a dividirse por w ni a la ventana.
inline std::string numerosPanel(std::size_t panel, const Etapas &e, double guardada) {
    const auto tres = [](const glm::dvec3 &v) {
        return conDosDecimales("x ", v.x) + "\n" + conDosDecimales("y ", v.y) + "\n" +
               conDosDecimales("z ", v.z);
    };
    const char *const nombres[] = {"x ", "y ", "z "};
    std::string numeros = conDosDecimales("w ", e.recortado.w);
    switch (panel) {
    case OBJETO: return tres(e.objeto);
    case MUNDO: return tres(e.mundo);
    case CAMARA: return tres(e.camara);
    case NDC:
        for (int i = 0; i < 3; ++i) // cada coordenada de recortado y, si no se recorta, la normalizada
            numeros += "\n" + conDosDecimales(nombres[i], e.recortado[i]) +
                       (e.dentro ? conDosDecimales(" → ", e.ndc[i]) : "");
        return numeros;
    default:
        if (!e.dentro)
            return "no llega";
        if (panel == VENTANA)
            return conDosDecimales("x ", e.ventana.x) + "\n" + conDosDecimales("y ", e.ventana.y);
        const bool pasa = e.ventana.z < guardada;
        return conDosDecimales("", e.ventana.z) + conDosDecimales(pasa ? " < " : " ≥ ", guardada) +
               (pasa ? "\nse pinta" : "\nse descarta");
    }
}
