// Lo que un programa de dibujo plano debe pintar, en doble precisión y sin OpenGL: capas de trazos, discos, flechas y polígonos, unas sobre
// otras, en píxeles desde abajo a la izquierda. Se compara la ventana entera, salvo los rótulos, que se leen.
#pragma once
#include "ejecuta.h"
#include "oraculo/camara.h"
#include "oraculo/cobertura.h"
#include "oraculo/compara.h"
#include "rotulos.h"
#include "trazo.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

struct Lienzo {
    using Puntos = std::vector<glm::dvec2>;
    const int ancho, alto;
    glm::ivec4 panel; // x, y, ancho y alto

    Lienzo(int elAncho, int elAlto)
        : ancho(elAncho), alto(elAlto), panel(0, 0, elAncho, elAlto),
          tapado(static_cast<std::size_t>(elAncho * elAlto), 0) {
    }

    double grosor(double g) const {
        return std::max(g * oraculo::altoUtil(ancho, alto) / 1080, 1.0);
    }
    /// De coordenadas normalizadas del panel a píxeles.
    glm::dvec2 normalizado(double x, double y) const {
        return {panel.x + panel.z * (x + 1) / 2, panel.y + panel.w * (y + 1) / 2};
    }
    /// De las de paralelaVentana(semialto) centrada en `centro`.
    glm::dvec2 paralela(const glm::dvec2 &p, double semialto = 1, const glm::dvec2 &centro = {0, 0}) const {
        return glm::dvec2(panel.x + 0.5 * panel.z, panel.y + 0.5 * panel.w) +
               (p - centro) * (0.5 * oraculo::altoUtil(panel.z, panel.w) / semialto);
    }

    void fondo(const glm::vec3 &color) {
        const glm::dvec2 a(panel.x, panel.y), b(panel.x + panel.z, panel.y + panel.w);
        nueva(color, {a, b}, 0).llena(a, b, [](const glm::dvec2 &) { return 1e9; });
    }
    void poligono(const Puntos &puntos, const glm::vec3 &color) {
        oraculo::Poligono p;
        for (const glm::dvec2 &v : puntos)
            p.push_back({v.x, v.y});
        nueva(color, puntos, 2).llena({0, 0}, {ancho, alto}, [&](const glm::dvec2 &c) {
            return oraculo::distanciaDentro(p, c.x, c.y);
        });
    }
    /// Con extremos rectos, como los de trazaPolilinea; trazaSegmentos los alarga medio grosor.
    void linea(const Puntos &puntos, const glm::vec3 &color, double g, bool cerrada = false,
               bool alarga = false) {
        const double medio = 0.5 * grosor(g), extra = alarga ? medio : 0;
        const std::size_t n = puntos.size(), tramos = cerrada ? n : n - 1;
        std::vector<double> recorrido = {0}; // hasta el final de cada tramo
        for (std::size_t i = 0; i < tramos; ++i)
            recorrido.push_back(recorrido.back() + glm::distance(puntos[i], puntos[(i + 1) % n]));
        /// Lo que un punto se pasa del extremo p, en el que la línea acaba viniendo de q.
        const auto pasado = [](const glm::dvec2 &c, const glm::dvec2 &p, const glm::dvec2 &q) {
            return p == q ? 0 : glm::dot(c - p, glm::normalize(p - q));
        };
        const double cerca = 2 * medio + 2;
        Capa &capa = nueva(color, puntos, medio + 2);
        for (std::size_t i = 0; i < tramos; ++i) {
            const glm::dvec2 a = puntos[i], b = puntos[(i + 1) % n], d = b - a;
            const double largo = glm::length(d);
            if (largo == 0)
                continue;
            const bool alPrincipio = !cerrada && recorrido[i] < cerca,
                       alFinal = !cerrada && recorrido.back() - recorrido[i + 1] < cerca;
            capa.llena(glm::min(a, b) - medio - 2.0, glm::max(a, b) + medio + 2.0, [&](const glm::dvec2 &c) {
                const double t = glm::clamp(glm::dot(c - a, d) / (largo * largo), 0.0, 1.0);
                double v = medio - glm::distance(c, a + t * d);
                for (const bool alEmpezar : {true, false})
                    if (alEmpezar ? alPrincipio : alFinal) {
                        const double de = alEmpezar ? pasado(c, puntos[0], puntos[1])
                                                    : pasado(c, puntos[n - 1], puntos[n - 2]);
                        const double recto = std::fabs(d.x * (c.y - a.y) - d.y * (c.x - a.x)) / largo;
                        if (de > 0) // el extremo es recto, no redondo
                            v = std::min(medio - recto, extra - de);
                        else
                            v = std::min(v, extra - de);
                    }
                return v;
            });
        }
    }
    void punto(const glm::dvec2 &p, const glm::vec3 &color, double diametro) {
        const double radio = 0.5 * grosor(diametro);
        nueva(color, {p}, radio + 2).llena({0, 0}, {ancho, alto}, [&](const glm::dvec2 &c) {
            return radio - glm::distance(c, p);
        });
    }
    void flecha(const glm::dvec2 &a, const glm::dvec2 &b, const glm::vec3 &color, double g = GROSOR) {
        const double medio = 0.5 * grosor(g), largo = glm::distance(a, b), punta = std::min(9 * medio, largo);
        const glm::dvec2 d = (b - a) / largo, n(-d.y, d.x), base = b - d * punta;
        poligono({base + n * (punta * 1.9 / 4.5), base - n * (punta * 1.9 / 4.5), b}, color);
        if (largo > punta)
            linea({a, base}, color, g);
    }

    /// Comprueba que el texto se lee junto al punto, al lado que se dice (con CENTRO, en él), y no mira más ese sitio.
    void rotulo(const Imagen &imagen, const std::string &texto, const glm::dvec2 &p, const glm::vec3 &color,
                Lado lado, double talla = TALLA_ROTULO, int sobran = 8) {
        const int celda = celdaDe(ancho, alto, talla);
        const std::u32string letras = enLetras(texto);
        const double medioAncho = celda * (6.0 * static_cast<double>(letras.size()) - 1) / 2;
        glm::dvec2 centro = p;
        switch (lado) {
        case Lado::ENCIMA: centro.y += 6.5 * celda; break;
        case Lado::DEBAJO: centro.y -= 6.5 * celda; break;
        case Lado::IZQUIERDA: centro.x -= 3 * celda + medioAncho; break;
        case Lado::DERECHA: centro.x += 3 * celda + medioAncho; break;
        default: break;
        }
        // se busca solo cerca, que es lo que tarda
        const int margen = 12 * celda, x0 = std::max(static_cast<int>(centro.x - medioAncho) - margen, 0),
                  y0 = std::max(static_cast<int>(centro.y) - margen, 0),
                  x1 = std::min(static_cast<int>(centro.x + medioAncho) + margen, ancho),
                  y1 = std::min(static_cast<int>(centro.y) + margen, alto);
        Rotulo mejor{};
        double lejos = 1e9;
        for (Rotulo r :
             buscaRotulo(oraculo::recorta(imagen, x0, y0, x1 - x0, y1 - y0), letras, color, celda, sobran)) {
            r.x += x0, r.x0 += x0, r.x1 += x0, r.y += y0, r.y0 += y0, r.y1 += y0;
            if (r.lejosDe(centro.x, centro.y) < lejos) {
                mejor = r;
                lejos = r.lejosDe(centro.x, centro.y);
            }
        }
        ASSERT_LT(lejos, 1e9) << "no se lee «" << texto << "» cerca de " << centro.x << ", " << centro.y;
        EXPECT_LT(lejos, celda + 1.0) << "«" << texto << "» se lee en " << mejor.x << ", " << mejor.y
                                      << " y no en " << centro.x << ", " << centro.y;
        const int halo = std::max(celda / 2, 1);
        for (int y = std::max(mejor.y0 - halo, 0); y <= std::min(mejor.y1 + halo, alto - 1); ++y)
            for (int x = std::max(mejor.x0 - halo, 0); x <= std::min(mejor.x1 + halo, ancho - 1); ++x)
                tapado[static_cast<std::size_t>(y * ancho + x)] = 1;
    }

    /// Cada píxel es de la primera capa que lo cubre, mirando desde arriba; a menos de `borde` de un borde vale cualquiera de las dos
    /// que separa.
    void compara(const Imagen &imagen, double borde = 0.45) const {
        ASSERT_EQ(imagen.ancho, ancho);
        ASSERT_EQ(imagen.alto, alto);
        int mal = 0;
        double maximo = 0;
        glm::ivec4 caja(ancho, alto, 0, 0);
        std::string primero;
        for (int y = 0; y < alto; ++y)
            for (int x = 0; x < ancho; ++x) {
                const auto i = static_cast<std::size_t>(y * ancho + x);
                bool vale = tapado[i];
                for (std::size_t k = capas.size(); !vale && k-- > 0;) {
                    if (capas[k].en(x, y) > -borde && esColor(imagen, x, y, capas[k].color)) {
                        const glm::vec3 &c = capas[k].color;
                        vale = true;
                        maximo = std::max(maximo, oraculo::diferencia(imagen, x, y, {c.r, c.g, c.b}));
                    }
                    if (capas[k].en(x, y) > borde)
                        break;
                }
                if (!vale)
                    caja = {glm::min(glm::ivec2(caja), glm::ivec2(x, y)),
                            glm::max(glm::ivec2(caja.z, caja.w), glm::ivec2(x, y))};
                if (!vale && ++mal == 1) {
                    const Pixel p = pixel(imagen, x, y);
                    primero = "(" + std::to_string(x) + ", " + std::to_string(y) + ") es " +
                              std::to_string(p.r) + " " + std::to_string(p.g) + " " + std::to_string(p.b);
                }
            }
        apuntaDiferencia(mal ? 255 : maximo, -1, borde);
        EXPECT_EQ(mal, 0) << "píxeles que no son lo que debían; el primero, " << primero
                          << ", y todos entre (" << caja.x << ", " << caja.y << ") y (" << caja.z << ", "
                          << caja.w << ")";
    }

private:
    /// Un color y, en los píxeles de una caja, la distancia de cada centro al borde, positiva dentro.
    struct Capa {
        glm::vec3 color;
        int x0, y0, x1, y1;
        std::vector<float> dentro;
        float en(int x, int y) const {
            return x < x0 || y < y0 || x >= x1 || y >= y1
                       ? -1e9f
                       : dentro[static_cast<std::size_t>((y - y0) * (x1 - x0) + x - x0)];
        }
        /// f da la distancia de un punto; de varias, la mayor.
        template<typename F>
        void llena(const glm::dvec2 &desde, const glm::dvec2 &hasta, const F &f) {
            const int u0 = std::max(static_cast<int>(std::floor(desde.x)), x0),
                      v0 = std::max(static_cast<int>(std::floor(desde.y)), y0),
                      u1 = std::min(static_cast<int>(std::ceil(hasta.x)), x1),
                      v1 = std::min(static_cast<int>(std::ceil(hasta.y)), y1);
            for (int y = v0; y < v1; ++y)
                for (int x = u0; x < u1; ++x) {
                    float &d = dentro[static_cast<std::size_t>((y - y0) * (x1 - x0) + x - x0)];
                    d = std::max(d, static_cast<float>(f(glm::dvec2(x + 0.5, y + 0.5))));
                }
        }
    };
    std::vector<Capa> capas;
    std::vector<char> tapado;

    /// Una capa en la caja de esos puntos, con un margen, y dentro del panel.
    Capa &nueva(const glm::vec3 &color, const Puntos &puntos, double margen) {
        glm::dvec2 desde(1e9), hasta(-1e9);
        for (const glm::dvec2 &p : puntos) {
            desde = glm::min(desde, p - margen);
            hasta = glm::max(hasta, p + margen);
        }
        const auto entre = [](double v, int a, int b) {
            return static_cast<int>(std::clamp<double>(v, a, b));
        };
        Capa c{color,
               entre(std::floor(desde.x), panel.x, panel.x + panel.z),
               entre(std::floor(desde.y), panel.y, panel.y + panel.w),
               entre(std::ceil(hasta.x), panel.x, panel.x + panel.z),
               entre(std::ceil(hasta.y), panel.y, panel.y + panel.w),
               {}};
        c.dentro.assign(static_cast<std::size_t>((c.x1 - c.x0) * (c.y1 - c.y0)), -1e9f);
        capas.push_back(c);
        return capas.back();
    }
};
