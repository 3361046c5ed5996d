// Las imágenes de los programas de curvas del capítulo 11, píxel a píxel: la curva exacta, en doble precisión y con las fórmulas del libro,
// llevada a la ventana, con sus puntos, flechas y rótulos; también después de arrastrar, de las teclas y de cambiar de tamaño.
#include "ch11_curvas/continuidad.h"
#include "ch11_curvas/editor.h"
#include "ch11_curvas/escenas_curvas.h"
#include "ch11_curvas/solenoide.h"
#include "ch11_lienzo.h"
#include "colores.h"
#include "oraculo/luz.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <string>

namespace {

using Puntos = std::vector<glm::dvec2>;
using Cuatro = std::array<glm::dvec2, 4>;

// ---- Las curvas, con la base de potencias del libro ----

glm::dvec2 enBase(const double M[4][4], const Cuatro &G, double u, int derivada = 0) {
    const double U[3][4] = {{u * u * u, u * u, u, 1}, {3 * u * u, 2 * u, 1, 0}, {6 * u, 2, 0, 0}};
    glm::dvec2 Q(0);
    for (std::size_t j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
            Q += U[derivada][i] * M[i][j] * G[j];
    return Q;
}
const double M_H[4][4] = {{2, -2, 1, 1}, {-3, 3, -2, -1}, {0, 0, 1, 0}, {1, 0, 0, 0}};
const double S = 1.0 / 6;
const double M_BS[4][4] = {
    {-S, 3 * S, -3 * S, S}, {3 * S, -6 * S, 3 * S, 0}, {-3 * S, 0, 3 * S, 0}, {S, 4 * S, S, 0}};

glm::dvec2 bezierDe(Puntos P, double u) {
    for (std::size_t n = P.size() - 1; n > 0; --n)
        for (std::size_t i = 0; i < n; ++i)
            P[i] = (1 - u) * P[i] + u * P[i + 1];
    return P[0];
}
/// f(u), de 0 a 1, en píxeles.
Puntos muestras(const std::function<glm::dvec2(double)> &f, int n = 400) {
    Puntos p;
    for (int i = 0; i <= n; ++i)
        p.push_back(f(double(i) / n));
    return p;
}
Puntos planos(const std::vector<glm::vec3> &P) {
    Puntos p;
    for (const glm::vec3 &v : P)
        p.push_back(glm::dvec2(v));
    return p;
}

struct Talla {
    int ancho, alto;
};
const Talla TALLAS[] = {{480, 360}, {640, 360}, {480, 640}};

Imagen imagenDe(const std::string &programa, const std::string &guion, const Talla &t) {
    const Ejecucion e = ejecuta("ch11_curvas/" + programa, guion, t.ancho, t.alto);
    EXPECT_EQ(e.estado, 0) << e.errores;
    return e.imagen;
}
/// Coger en un punto del lienzo y soltar en otro, con el ratón. Al punto en que acaba va el que se coge.
std::string arrastra(const Lienzo &l, const glm::dvec2 &desde, glm::dvec2 &hasta) {
    const auto raton = [&](const glm::dvec2 &p) {
        return std::to_string(static_cast<int>(p.x)) + " " +
               std::to_string(l.alto - 1 - static_cast<int>(p.y));
    };
    hasta = glm::floor(hasta) + 0.5; // el centro de un píxel
    return "boton IZQUIERDO abajo " + raton(desde) + "; arrastra " + raton(hasta) +
           "; boton IZQUIERDO arriba " + raton(hasta);
}
/// De píxeles a las unidades de paralelaVentana(semialto).
glm::dvec2 enUnidades(const Lienzo &l, const glm::dvec2 &p, double semialto = 1,
                      const glm::dvec2 &centro = {0, 0}) {
    return centro +
           (p - l.paralela(centro, semialto, centro)) / (0.5 * oraculo::altoUtil(l.ancho, l.alto) / semialto);
}

// ---- bezier ----

/// El casco convexo, por la cadena monótona.
Puntos casco(Puntos P) {
    std::sort(P.begin(), P.end(),
              [](const glm::dvec2 &a, const glm::dvec2 &b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    Puntos c;
    for (int vuelta = 0; vuelta < 2; ++vuelta) {
        const std::size_t base = c.size();
        for (const glm::dvec2 &p : P) {
            while (c.size() >= base + 2) {
                const glm::dvec2 a = c.back() - c[c.size() - 2], b = p - c.back();
                if (a.x * b.y - a.y * b.x > 0)
                    break;
                c.pop_back();
            }
            c.push_back(p);
        }
        c.pop_back();
        std::reverse(P.begin(), P.end());
    }
    return c;
}

void compruebaBezier(Lienzo l, const std::string &guion, const Puntos &P, double u, int elegido = -1) {
    SCOPED_TRACE(guion);
    const Imagen imagen = imagenDe("bezier", guion, {l.ancho, l.alto});
    const auto px = [&](const Puntos &puntos) {
        Puntos r;
        for (const auto &p : puntos)
            r.push_back(l.paralela(p));
        return r;
    };
    l.fondo(FONDO_CLARO);
    if (const Puntos c = casco(P); c.size() > 2)
        l.poligono(px(c), glm::mix(FONDO_CLARO, AZUL, 0.1f));
    std::vector<Puntos> niveles = {P};
    while (niveles.back().size() > 1) {
        Puntos siguiente;
        for (std::size_t i = 0; i + 1 < niveles.back().size(); ++i)
            siguiente.push_back((1 - u) * niveles.back()[i] + u * niveles.back()[i + 1]);
        niveles.push_back(siguiente);
    }
    const glm::vec3 color[] = {GRIS, VERDE, NARANJA, ROJO};
    for (std::size_t k = 0; k < 3; ++k)
        l.linea(px(niveles[k]), color[k], 0.8 * GROSOR);
    l.linea(px(muestras([&](double t) { return bezierDe(P, t); })), AZUL, 1.7 * GROSOR);
    for (std::size_t k = 1; k < 4; ++k)
        for (const auto &p : px(niveles[k]))
            l.punto(p, color[k], (k == 3 ? 5 : 2.5) * GROSOR);
    for (const auto &p : px(P))
        l.punto(p, OSCURO, 4 * GROSOR);
    for (std::size_t i = 0; i < 4; ++i)
        l.rotulo(imagen, "P" + std::to_string(i + 1), l.paralela(P[i]),
                 static_cast<int>(i) == elegido ? ROJO : OSCURO, i % 3 == 0 ? Lado::DEBAJO : Lado::ENCIMA);
    l.rotulo(imagen, "Q(u)", l.paralela(0.84 * niveles[3][0] + 0.08 * (P[0] + P[3])), ROJO, Lado::CENTRO);
    l.compara(imagen);
}

TEST(Bezier, CurvaCascoYDeCasteljau) {
    const Puntos P = planos(PUNTOS_BEZIER);
    for (const Talla &t : TALLAS)
        compruebaBezier({t.ancho, t.alto}, "", P, 0.4);
    const Lienzo l(480, 360);
    compruebaBezier(l, "tecla u; tecla u; tecla u", P, 0.55);
    compruebaBezier(l, "tecla U", P, 0.35);
    compruebaBezier({480, 640}, "espera 0; tamano 480 640", P, 0.4);
}

TEST(Bezier, PuntosArrastradosYConElTeclado) {
    for (const Talla &t : {TALLAS[0], TALLAS[2]}) {
        const Lienzo l(t.ancho, t.alto);
        Puntos P = planos(PUNTOS_BEZIER);
        glm::dvec2 hasta = l.paralela({-0.3, 0.75});
        const std::string guion = arrastra(l, l.paralela(P[1]) + glm::dvec2(4, -3), hasta);
        P[1] = enUnidades(l, hasta);
        compruebaBezier(l, guion, P, 0.4, 1);
    }
    const Lienzo l(480, 360);
    Puntos P = planos(PUNTOS_BEZIER);
    const double paso = 0.1; // en coordenadas normalizadas
    P[0] += glm::dvec2(2 * paso * 4 / 3, paso);
    compruebaBezier(l, "tecla n; especial DERECHA; especial DERECHA; especial ARRIBA", P, 0.4, 0);
    P = planos(PUNTOS_BEZIER);
    P[3] += glm::dvec2(-paso * 4 / 3, -2 * paso);
    compruebaBezier(l,
                    "tecla n; tecla n; tecla n; tecla n; especial IZQUIERDA; especial ABAJO; especial ABAJO",
                    P, 0.4, 3);
    // pulsar lejos de todos los puntos no mueve ninguno
    glm::dvec2 hasta = l.paralela({0.5, 0.5});
    compruebaBezier(l, arrastra(l, l.paralela({0.3, 0}), hasta), planos(PUNTOS_BEZIER), 0.4);
}

// Los cuatro puntos en el mismo sitio, y los extremos de u: nada se rompe.
TEST(Bezier, PuntosCoincidentes) {
    const Lienzo l(480, 360);
    const Puntos P = planos(PUNTOS_BEZIER);
    glm::dvec2 hasta = l.paralela(P[0]);
    compruebaBezier(l, arrastra(l, l.paralela(P[1]), hasta), {P[0], enUnidades(l, hasta), P[2], P[3]}, 0.4,
                    1);
    std::string guion;
    for (int i = 1; i < 4; ++i) {
        glm::dvec2 sitio = l.paralela({0, 0});
        guion += arrastra(l, l.paralela(P[static_cast<std::size_t>(i)]), sitio) + "; ";
    }
    glm::dvec2 sitio = l.paralela({0, 0});
    const Imagen imagen = imagenDe("bezier", guion + arrastra(l, l.paralela(P[0]), sitio), {480, 360});
    int pintados = 0;
    for (int y = 0; y < 360; ++y)
        for (int x = 0; x < 480; ++x) {
            const bool fondo = esColor(imagen, x, y, FONDO_CLARO);
            pintados += !fondo;
            EXPECT_TRUE(fondo || (std::abs(x - 240) < 60 && std::abs(y - 180) < 30));
        }
    EXPECT_GT(pintados, 20);
}

// ---- hermite ----

struct EscenaHermite {
    Puntos p = planos(PUNTOS_HERMITE);
    double k = K_HERMITE;
    bool segundo = false, transforma = false;
    int elegido = -1;
};

void compruebaHermite(Lienzo l, const std::string &guion, const EscenaHermite &e) {
    SCOPED_TRACE(guion);
    const Imagen imagen = imagenDe("hermite", guion, {l.ancho, l.alto});
    const auto px = [&](const glm::dvec2 &p) {
        return e.segundo ? l.paralela(p, 1.38, {0.46, 0.12}) : l.paralela(p);
    };
    struct Nombre {
        std::string texto;
        int punto;
    };
    const auto tramo = [&](const Cuatro &G, const glm::vec3 &color, const std::vector<Nombre> &nombres,
                           const glm::vec3 &color1, const glm::vec3 &color4) {
        l.linea(muestras([&](double u) { return px(enBase(M_H, G, u)); }), color, 1.7 * GROSOR);
        l.flecha(px(G[0]), px(G[0] + G[2]), color1);
        l.flecha(px(G[1]), px(G[1] + G[3]), color4);
        l.punto(px(G[0]), OSCURO, 4 * GROSOR);
        l.punto(px(G[1]), OSCURO, 4 * GROSOR);
        const glm::dvec2 sitios[] = {G[0], G[1] + glm::dvec2(0, G[3].y < 0 ? 0.05 : -0.05), G[0] + G[2],
                                     G[1] + G[3]};
        for (std::size_t i = 0; i < nombres.size(); ++i)
            if (!nombres[i].texto.empty())
                l.rotulo(imagen, nombres[i].texto, px(sitios[i]),
                         nombres[i].punto == e.elegido ? ROJO : OSCURO,
                         i == 0 ? Lado::DEBAJO : Lado::DERECHA);
    };
    const std::vector<Nombre> nombres = {{"P1", 0}, {"P4", 1}, {"R1", 2}, {"R4", 3}};
    const Cuatro G = {e.p[0], e.p[1], e.p[2] - e.p[0], e.p[3] - e.p[1]};
    l.fondo(FONDO_CLARO);
    if (e.transforma) {
        tramo(G, GRIS, {}, GRIS, GRIS);
        const auto girado = [](const glm::dvec2 &v) {
            const double c = std::cos(double(T_GIRO)), s = std::sin(double(T_GIRO));
            const glm::dvec2 w = v * glm::dvec2(T_ESCALADO);
            return glm::dvec2(c * w.x - s * w.y, s * w.x + c * w.y);
        };
        const glm::dvec2 d(T_TRASLACION);
        tramo({girado(G[0]) + d, girado(G[1]) + d, girado(G[2]), girado(G[3])}, AZUL, nombres, VERDE,
              NARANJA);
        for (int i = 0; i <= 16; ++i)
            l.punto(px(girado(enBase(M_H, G, i / 16.0)) + d), ROJO, 3 * GROSOR);
    } else
        tramo(G, AZUL, nombres, VERDE, NARANJA);
    if (e.segundo)
        tramo({G[1], e.p[4], e.k * G[3], e.p[5] - e.p[4]}, MORADO,
              {{"", 9}, {"P4'", 4}, {"k·R4", 9}, {"R4'", 5}}, VERDE, NARANJA);
    l.compara(imagen);
}

EscenaHermite conSegundo() {
    EscenaHermite e;
    e.segundo = true;
    for (const glm::vec3 &p : SEGUNDO_HERMITE)
        e.p.push_back(glm::dvec2(p));
    return e;
}

TEST(Hermite, CurvaTangentesYTransformada) {
    for (const Talla &t : TALLAS) {
        compruebaHermite({t.ancho, t.alto}, "", {});
        compruebaHermite({t.ancho, t.alto}, "tecla g", conSegundo());
        EscenaHermite e;
        e.transforma = true;
        compruebaHermite({t.ancho, t.alto}, "tecla t", e);
    }
    const Lienzo l(480, 360);
    compruebaHermite(l, "tecla g; tecla g", {});
    compruebaHermite(l, "tecla t; tecla t", {});
    compruebaHermite(l, "tecla t; tecla g", conSegundo());
    EscenaHermite e = conSegundo();
    e.k *= 1.25 * 1.25;
    compruebaHermite(l, "tecla g; tecla +; tecla +", e);
    e.k = 0.5 / 1.25;
    compruebaHermite(l, "tecla g; tecla -", e);
}

TEST(Hermite, ArrastrarPuntosYPuntas) {
    for (const Talla &t : {TALLAS[0], TALLAS[1]}) {
        const Lienzo l(t.ancho, t.alto);
        EscenaHermite e; // el punto se lleva su flecha
        glm::dvec2 hasta = l.paralela({-0.6, -0.4});
        const std::string mueveP1 = arrastra(l, l.paralela(e.p[0]) + glm::dvec2(-3, 2), hasta);
        e.p[2] += enUnidades(l, hasta) - e.p[0];
        e.p[0] = enUnidades(l, hasta);
        e.elegido = 0;
        compruebaHermite(l, mueveP1, e);
        // y la punta va sola
        hasta = l.paralela({0.9, -0.1});
        const std::string mueveR4 = arrastra(l, l.paralela(e.p[3]), hasta);
        e.p[3] = enUnidades(l, hasta);
        e.elegido = 3;
        compruebaHermite(l, mueveP1 + "; " + mueveR4, e);
    }
    const Lienzo l(480, 360);
    EscenaHermite e = conSegundo();
    const auto px = [&](const glm::dvec2 &p) { return l.paralela(p, 1.38, {0.46, 0.12}); };
    glm::dvec2 hasta = px({1.5, 0.1});
    const std::string mueveP4 = arrastra(l, px(e.p[4]), hasta);
    const glm::dvec2 nuevo = enUnidades(l, hasta, 1.38, {0.46, 0.12});
    e.p[5] += nuevo - e.p[4];
    e.p[4] = nuevo;
    e.elegido = 4;
    compruebaHermite(l, "tecla g; " + mueveP4, e);
    EscenaHermite teclado;
    teclado.p[1] += glm::dvec2(-0.2 * 4 / 3, 0.2);
    teclado.p[3] += glm::dvec2(-0.2 * 4 / 3, 0.2);
    teclado.elegido = 1;
    compruebaHermite(
        l, "tecla n; tecla n; especial IZQUIERDA; especial ARRIBA; especial IZQUIERDA; especial ARRIBA",
        teclado);
}

// Los puntos del segundo tramo no se eligen ni se cogen cuando no se ven.
TEST(Hermite, LoQueNoSeVeNoSeCoge) {
    const Lienzo l(720, 360); // aquí P4' cae dentro de la ventana
    glm::dvec2 hasta = l.paralela({0.2, 0.8});
    compruebaHermite(l, arrastra(l, l.paralela(glm::dvec2(SEGUNDO_HERMITE[0])), hasta), {});
    EscenaHermite e;
    e.elegido = 0;
    compruebaHermite({480, 360}, "tecla n; tecla n; tecla n; tecla n; tecla n", e);
    compruebaHermite({480, 360}, "tecla n; tecla g", conSegundo()); // al cambiar no queda ninguno elegido
    compruebaHermite({480, 360},
                     "tecla g; tecla n; tecla n; tecla n; tecla n; tecla n; tecla g; especial ARRIBA", {});
}

// Tangente nula: la curva llega a su extremo, y nada es NaN.
TEST(Hermite, TangenteNula) {
    const Lienzo l(480, 360);
    EscenaHermite e;
    glm::dvec2 hasta = l.paralela(e.p[0]);
    const Imagen imagen = imagenDe("hermite", arrastra(l, l.paralela(e.p[2]), hasta), {480, 360});
    const glm::dvec2 punta = enUnidades(l, hasta) - e.p[0];
    const Cuatro G = {e.p[0], e.p[1], punta, e.p[3] - e.p[1]};
    int azules = 0;
    for (int i = 20; i <= 90; ++i) {
        const glm::dvec2 q = l.paralela(enBase(M_H, G, i / 100.0));
        azules += esColor(imagen, static_cast<int>(q.x), static_cast<int>(q.y), AZUL);
    }
    EXPECT_EQ(azules, 71);
}

// ---- bspline ----

struct EscenaBSpline {
    Puntos P = planos(PUNTOS_BSPLINE);
    bool cerrada = false, peine = false;
    int elegido = -1;
};

void compruebaBSpline(Lienzo l, const std::string &guion, const EscenaBSpline &e) {
    SCOPED_TRACE(guion);
    const Imagen imagen = imagenDe("bspline", guion, {l.ancho, l.alto});
    const Puntos iniciales = planos(PUNTOS_BSPLINE);
    const int n = 9, tramos = e.cerrada ? 9 : 6;
    const auto geometria = [](const Puntos &P, int i) {
        Cuatro G;
        for (int k = 0; k < 4; ++k)
            G[static_cast<std::size_t>(k)] = P[static_cast<std::size_t>((i + k) % 9)];
        return G;
    };
    Puntos px;
    for (const auto &p : e.P)
        px.push_back(l.paralela(p));
    l.fondo(FONDO_CLARO);
    l.linea(px, glm::mix(GRIS, BLANCO, 0.4f), 0.6 * GROSOR, e.cerrada);
    for (int i = 0; i < tramos; ++i)
        l.linea(muestras([&](double u) { return l.paralela(enBase(M_BS, geometria(iniciales, i), u)); }, 100),
                GRIS, GROSOR);
    for (int i = 0; e.peine && i < tramos; ++i) {
        const Cuatro G = geometria(e.P, i);
        // la curvatura, con signo: (x'y'' − y'x'')/|Q'|³, y la normal a la izquierda
        const auto punta = [&](double u) {
            const glm::dvec2 d = enBase(M_BS, G, u, 1), dd = enBase(M_BS, G, u, 2);
            const double v = glm::length(d), k = (d.x * dd.y - d.y * dd.x) / (v * v * v);
            return l.paralela(enBase(M_BS, G, u) - double(LARGO_PUAS) * k * glm::dvec2(-d.y, d.x) / v);
        };
        Puntos puntas;
        for (int k = 0; k <= 20; ++k) {
            puntas.push_back(punta(k / 20.0));
            l.linea({l.paralela(enBase(M_BS, G, k / 20.0)), puntas.back()}, VERDE, 0.4 * GROSOR, false, true);
        }
        l.linea(puntas, VERDE, 0.8 * GROSOR);
    }
    for (int i = 0; i < tramos; ++i) {
        bool usa = false;
        for (int k = 0; k < 4; ++k)
            usa = usa || (i + k) % n == e.elegido;
        l.linea(muestras([&](double u) { return l.paralela(enBase(M_BS, geometria(e.P, i), u)); }, 100),
                usa ? ROJO : AZUL, 1.7 * GROSOR);
    }
    for (int i = 0; i < tramos; ++i) // los nudos: (P0 + 4·P1 + P2)/6
        for (int j = i; j < i + 2; ++j) {
            const Cuatro G = geometria(e.P, j);
            l.punto(l.paralela((G[0] + 4.0 * G[1] + G[2]) / 6.0), NARANJA, 3 * GROSOR);
        }
    for (const auto &p : px)
        l.punto(p, OSCURO, 4 * GROSOR);
    const Lado lados[] = {Lado::IZQUIERDA, Lado::ENCIMA, Lado::DEBAJO, Lado::ENCIMA, Lado::ENCIMA,
                          Lado::DERECHA,   Lado::DEBAJO, Lado::ENCIMA, Lado::DEBAJO};
    for (int i = 0; i < n; ++i)
        l.rotulo(imagen, "P" + std::to_string(i), px[static_cast<std::size_t>(i)],
                 i == e.elegido ? ROJO : OSCURO, lados[i]);
    l.compara(imagen);
}

TEST(BSpline, AbiertaCerradaYPeine) {
    for (const Talla &t : TALLAS) {
        EscenaBSpline e;
        compruebaBSpline({t.ancho, t.alto}, "", e);
        e.cerrada = true;
        compruebaBSpline({t.ancho, t.alto}, "tecla c", e);
    }
    EscenaBSpline e;
    e.peine = true;
    compruebaBSpline({640, 480}, "tecla k", e);
    e.cerrada = true;
    compruebaBSpline({640, 480}, "tecla c; tecla k", e);
    compruebaBSpline({480, 360}, "tecla c; tecla c; tecla k; tecla k", {});
    compruebaBSpline({480, 640}, "espera 0; tamano 480 640", {});
}

TEST(BSpline, ControlLocal) {
    const Lienzo l(480, 360);
    for (const int cual : {0, 4, 7}) {
        EscenaBSpline e;
        e.cerrada = true;
        e.elegido = cual;
        glm::dvec2 hasta = l.paralela(e.P[static_cast<std::size_t>(cual)] * 0.6);
        const std::string guion =
            "tecla c; " + arrastra(l, l.paralela(e.P[static_cast<std::size_t>(cual)]), hasta);
        e.P[static_cast<std::size_t>(cual)] = enUnidades(l, hasta);
        compruebaBSpline(l, guion, e);
    }
    EscenaBSpline abierta;
    abierta.elegido = 1;
    abierta.P[1].y -= 0.2;
    compruebaBSpline(l, "tecla n; tecla n; especial ABAJO; especial ABAJO", abierta);
}

// ---- bezier_n ----

void compruebaBezierN(Lienzo l, const std::string &guion, std::size_t n) {
    SCOPED_TRACE(std::to_string(n) + " puntos: " + guion);
    const Imagen imagen = imagenDe("bezier_n", guion, {l.ancho, l.alto});
    const auto colorDe = [&](std::size_t i) {
        const float t = static_cast<float>(i) / static_cast<float>(n - 1);
        return t < 0.5f ? AZUL + 2 * t * (NARANJA - AZUL) : NARANJA + (2 * t - 1) * (ROJO - NARANJA);
    };
    const int raya = std::max(static_cast<int>(oraculo::altoUtil(l.ancho, l.alto) / 180), 1),
              segunda = (l.alto + raya) / 2;
    l.fondo(GRIS);
    l.panel = {0, segunda, l.ancho, l.alto - segunda};
    l.fondo(FONDO_CLARO);
    const Puntos P = planos(puntosZigzag(n));
    const auto arriba = [&](const glm::dvec2 &p) { return l.normalizado(1.8 * p.x - 0.9, 0.9 * p.y); };
    Puntos px;
    for (const auto &p : P)
        px.push_back(arriba(p));
    l.linea(px, GRIS, 0.5 * GROSOR);
    l.linea(muestras([&](double u) { return arriba(bezierDe(P, u)); }), AZUL, 1.7 * GROSOR);
    for (std::size_t i = 0; i < n; ++i)
        l.punto(px[i], colorDe(i), 3 * GROSOR);
    l.rotulo(imagen, "P0", px.front(), OSCURO, Lado::DEBAJO);
    l.rotulo(imagen, "P" + std::to_string(n - 1), px.back(), OSCURO, Lado::ENCIMA);

    l.panel = {0, 0, l.ancho, segunda - raya};
    l.fondo(FONDO_CLARO);
    const auto abajo = [&](const glm::dvec2 &p) { return l.normalizado(1.8 * p.x - 0.9, 1.4 * p.y - 0.6); };
    l.linea({abajo({0, 1}), abajo({0, 0}), abajo({1, 0})}, OSCURO, 0.6 * GROSOR);
    for (std::size_t k = 0; k < n; ++k) {
        // ecuación 11.20, con el binomio por logaritmos
        const double m = double(n - 1), K = double(k),
                     lnC = std::lgamma(m + 1) - std::lgamma(K + 1) - std::lgamma(m - K + 1);
        const auto b = [&](double u) {
            return u == 0   ? double(k == 0)
                   : u == 1 ? double(k == n - 1)
                            : std::exp(lnC + K * std::log(u) + (m - K) * std::log1p(-u));
        };
        l.linea(muestras([&](double u) { return abajo({u, b(u)}); }, 800), colorDe(k), 0.8 * GROSOR);
    }
    l.rotulo(imagen, "0", abajo({0, 0}), OSCURO, Lado::DEBAJO);
    l.rotulo(imagen, "u", abajo({0.5, 0}), OSCURO, Lado::DEBAJO);
    l.rotulo(imagen, "1", abajo({1, 0}), OSCURO, Lado::DEBAJO);
    l.rotulo(imagen, "1", abajo({0, 1}), OSCURO, Lado::IZQUIERDA);
    l.compara(imagen);
}

TEST(BezierN, CurvaYPolinomiosDeBernstein) {
    const Lienzo l(480, 360);
    for (const Talla &t : TALLAS)
        compruebaBezierN({t.ancho, t.alto}, "", 4);
    compruebaBezierN(l, "tecla 2", 10);
    compruebaBezierN(l, "tecla 3", 40);
    compruebaBezierN(l, "tecla 4", 61);
    compruebaBezierN(l, "tecla 2; tecla 1", 4);
}

TEST(BezierN, UnPuntoMasOMenos) {
    const Lienzo l(480, 360);
    compruebaBezierN(l, "tecla +; tecla +; tecla +", 7);
    compruebaBezierN(l, "tecla -; tecla -; tecla -; tecla -", 2); // ni menos de dos
    compruebaBezierN(l, "tecla 4; tecla +; tecla +", 61);         // ni más de 61
    compruebaBezierN(l, "tecla 4; tecla -", 60);
}

// ---- continuidad ----

void dibujaContinuidad(Lienzo &l, const Imagen &imagen, int c, double u) {
    const char *const nombres[] = {"C0", "G1", "C1", "C2"};
    const auto px = [&](const glm::dvec2 &p) { return l.paralela(p, 1.05); };
    const auto cuatro = [](const Geometria<float> &G) {
        return Cuatro{glm::dvec2(G[0]), glm::dvec2(G[1]), glm::dvec2(G[2]), glm::dvec2(G[3])};
    };
    const Cuatro tramo[2] = {cuatro(PRIMER_TRAMO), cuatro(segundoTramo(static_cast<Continuidad>(c)))};
    l.fondo(FONDO_CLARO);
    l.linea({px({-1.1, -0.38}), px({-1.1, -0.95}), px({1.1, -0.95})}, OSCURO, 0.6 * GROSOR);
    l.linea({px({1.1 * (u - 1), -0.95}), px({1.1 * (u - 1), -0.4})}, GRIS, 0.6 * GROSOR, false, true);
    for (const int d : {2, 1}) {
        const double maximo = d == 2 ? double(ACELERACION_MAXIMA) : double(RAPIDEZ_MAXIMA);
        const auto altura = [&](double t) { // de 0 a 2; en la unión, la del primero
            const bool segundo = t > 1;
            return glm::dvec2(1.1 * (t - 1),
                              -0.95 +
                                  0.5 * glm::length(enBase(M_H, tramo[segundo], t - segundo, d)) / maximo);
        };
        const glm::vec3 color = d == 2 ? ROJO : VERDE;
        const double despues = 1 + 1e-12;
        l.linea(muestras([&](double t) { return px(altura(t)); }), color, GROSOR);
        l.linea(muestras([&](double t) { return px(altura(std::max(1 + t, despues))); }), color, GROSOR);
        if (c == C0 || (c == G1) || (c == C1 && d == 2)) { // donde salta
            l.punto(px(altura(1)), color, 3 * GROSOR);
            l.punto(px(altura(despues)), color, 3 * GROSOR);
        }
    }
    for (int i = 0; i < 2; ++i)
        l.linea(muestras([&](double t) { return px(enBase(M_H, tramo[i], t)); }), i ? MORADO : AZUL,
                1.7 * GROSOR);
    l.punto(px(tramo[0][1]), OSCURO, 3 * GROSOR);
    const int i = u >= 1;
    const glm::dvec2 Q = enBase(M_H, tramo[i], u - i), v = enBase(M_H, tramo[i], u - i, 1),
                     F = glm::normalize(v), L(-F.y, F.x);
    l.flecha(px(Q), px(Q + double(VELOCIDAD) * v), VERDE);
    l.poligono({px(Q + 0.10 * F), px(Q - 0.08 * F + 0.07 * L), px(Q - 0.08 * F - 0.07 * L)}, NARANJA);
    l.rotulo(imagen, nombres[c], px({-1.1, 0.85}), OSCURO, Lado::CENTRO, 1.3 * TALLA_ROTULO);
    l.rotulo(imagen, "|Q'|", px({-0.88, -0.25}), VERDE, Lado::CENTRO);
    l.rotulo(imagen, "|Q''|", px({-0.18, -0.25}), ROJO, Lado::CENTRO);
}

void compruebaContinuidad(const Talla &t, const std::string &guion, int elegido, double milisegundos) {
    SCOPED_TRACE(guion);
    const Imagen imagen = imagenDe("continuidad", guion, t);
    Lienzo l(t.ancho, t.alto);
    const double u = 2 * std::fmod(milisegundos, 4000) / 4000;
    l.fondo(GRIS);
    if (elegido >= 0)
        dibujaContinuidad(l, imagen, elegido, u);
    for (int c = 0; elegido < 0 && c < 4; ++c) { // dos por fila, la primera arriba
        const int raya = std::max(static_cast<int>(oraculo::altoUtil(t.ancho, t.alto) / 180), 1),
                  x = (t.ancho + raya) / 2, y = (t.alto + raya) / 2;
        l.panel = {c % 2 ? x : 0, c < 2 ? y : 0, c % 2 ? t.ancho - x : x - raya,
                   c < 2 ? t.alto - y : y - raya};
        dibujaContinuidad(l, imagen, c, u);
    }
    l.compara(imagen);
}

TEST(ContinuidadVista, LasCuatroYCadaUna) {
    compruebaContinuidad({640, 480}, "", -1, 1900);
    for (int c = 0; c < 4; ++c)
        compruebaContinuidad({480, 360}, "tecla " + std::to_string(c + 1), c, 1900);
    compruebaContinuidad({640, 360}, "tecla 2", 1, 1900);
    compruebaContinuidad({480, 640}, "tecla 3", 2, 1900);
    compruebaContinuidad({480, 360}, "tecla v; tecla 4; tecla v; tecla v", 3, 1900);
}

// Se dibuja cada 16 ms: lo que se ve es de la última vez.
TEST(ContinuidadVista, ElCocheSigueAlRelojYParaConEspacio) {
    const Talla t = {480, 360};
    compruebaContinuidad(t, "tecla 1; tecla t; espera 112", 0, 2012); // pasada la unión mira ya adonde va
    compruebaContinuidad(t, "tecla 4; tecla Espacio; espera 300; espera 17; espera 783", 3, 1900 + 1088);
    compruebaContinuidad(t, "tecla 4; tecla t; espera 300; tecla Espacio; espera 5000", 3, 2200); // parado
    compruebaContinuidad(
        t, "tecla 4; tecla t; espera 300; tecla Espacio; espera 5000; tecla Espacio; espera 208", 3, 2408);
    compruebaContinuidad(t, "tecla 3; tecla t; espera 8000; espera 1104", 2, 3004); // dos vueltas
    compruebaContinuidad(t, "tecla 2; espera 900", 1, 1900); // si no anda, está quieto
}

// ---- solenoide ----

const oraculo::Vec3 KA{0.22, 0.09, 0.04}, KD{0.72, 0.32, 0.16}, KS{0.60, 0.45, 0.35};

/// El tubo de la hélice exacta: bolas de su grueso, muy juntas. Lo que corta un rayo.
struct CorteTubo {
    double t = 1e9, angulo = 0;
    oraculo::Vec3 punto, normal;
};
oraculo::Vec3 helice(int vueltas, double a) {
    const double largo = double(LARGO_SOLENOIDE), radio = double(RADIO_SOLENOIDE);
    return {largo * a / (2 * M_PI * vueltas) - largo / 2, radio * std::cos(a), radio * std::sin(a)};
}

void compruebaSolenoide(const std::string &guion, int vueltas, bool segmentos, const Talla &t,
                        double azimut = 0.45, double elevacion = 0.38) {
    SCOPED_TRACE(guion);
    const Imagen imagen = imagenDe("solenoide", guion, t);
    const oraculo::Camara camara =
        oraculo::perspectiva(oraculo::orbita(azimut, elevacion, 10.4), 0.45, 1, 100);
    const double r = double(GRUESO_TUBO), fin = 2 * M_PI * vueltas;
    const int n = vueltas * 120;
    struct Bola {
        oraculo::Vec3 centro, ventana;
        double radio; // en píxeles
    };
    std::vector<Bola> bolas;
    for (int i = 0; i <= n; ++i) {
        const oraculo::Vec3 c = helice(vueltas, fin * i / n);
        bolas.push_back({c, oraculo::proyecta(camara, t.ancho, t.alto, c),
                         r / oraculo::tallaPixel(camara, t.ancho, t.alto, c)});
    }
    const oraculo::Luz luz{oraculo::Vec3{-0.5, 0.8, 0.7}, 0};
    int fuera = 0, huecos = 0, comparados = 0, malos = 0;
    double peor = 0, suma = 0;
    const oraculo::Material cobre{KA, KD, KS, 40},
        acero{{0.22, 0.25, 0.30}, {0.50, 0.58, 0.66}, {0.5, 0.5, 0.5}, 40};
    std::vector<CorteTubo> cortes;
    for (int y = 0; y < t.alto; ++y)
        for (int x = 0; x < t.ancho; ++x) {
            const oraculo::Rayo rayo = oraculo::rayo(camara, t.ancho, t.alto, x + 0.5, y + 0.5);
            CorteTubo corte;
            double cerca = 1e9; // a la bola más cercana, en píxeles
            for (int i = 0; i <= n; ++i) {
                const Bola &b = bolas[static_cast<std::size_t>(i)];
                const double lejos = std::hypot(x + 0.5 - b.ventana.x, y + 0.5 - b.ventana.y) - b.radio;
                cerca = std::min(cerca, lejos);
                if (lejos > 2)
                    continue;
                const oraculo::Vec3 oc = rayo.origen - b.centro;
                const double h = oraculo::escalar(oc, rayo.direccion),
                             d = h * h - oraculo::escalar(oc, oc) + r * r;
                if (d > 0 && -h - std::sqrt(d) < corte.t) {
                    corte.t = -h - std::sqrt(d);
                    corte.angulo = fin * i / n;
                    corte.punto = rayo.origen + corte.t * rayo.direccion;
                }
            }
            // entre bola y bola, el punto de la hélice más cercano
            for (double paso = fin / n; corte.t < 1e8 && paso > 1e-7; paso /= 2)
                for (const double a : {corte.angulo - paso, corte.angulo + paso})
                    if (oraculo::longitud(corte.punto - helice(vueltas, a)) <
                        oraculo::longitud(corte.punto - helice(vueltas, corte.angulo)))
                        corte.angulo = std::clamp(a, 0.0, fin); // en las puntas, una esfera
            corte.normal = oraculo::unitario(corte.punto - helice(vueltas, corte.angulo));
            cortes.push_back(corte);
            const bool fondo = esColor(imagen, x, y, FONDO_OSCURO);
            fuera += cerca > 1 && !fondo;
            huecos += cerca < -1 && fondo;
        }
    for (int y = 1; y < t.alto - 1; ++y)
        for (int x = 1; x < t.ancho - 1; ++x) {
            const CorteTubo &corte = cortes[static_cast<std::size_t>(y * t.ancho + x)];
            // lejos de las siluetas: lo de alrededor está a la misma distancia y no se ve de canto
            bool interior = corte.t < 1e8 &&
                            oraculo::escalar(corte.normal, oraculo::unitario(camara.ojo - corte.punto)) > 0.5;
            for (int k = 0; k < 9; ++k)
                interior =
                    interior &&
                    std::fabs(cortes[static_cast<std::size_t>((y + k / 3 - 1) * t.ancho + x + k % 3 - 1)].t -
                              corte.t) < 0.2;
            const double cuarto = corte.angulo / (M_PI / 2), enSegmento = cuarto - std::floor(cuarto);
            const bool punta = corte.angulo <= 0 || corte.angulo >= fin;
            if (!interior || (!punta && (enSegmento < 0.05 || enSegmento > 0.95)))
                continue;
            const bool gris = segmentos && !punta && static_cast<int>(cuarto) % 2 == 1;
            const oraculo::Vec3 color =
                oraculo::phong(gris ? acero : cobre, {1, 1, 1}, {luz}, corte.punto, corte.normal,
                               oraculo::unitario(camara.ojo - corte.punto));
            const Pixel p = pixel(imagen, x, y);
            const double d = std::max({std::fabs(255 * std::min(color.x, 1.0) - p.r),
                                       std::fabs(255 * std::min(color.y, 1.0) - p.g),
                                       std::fabs(255 * std::min(color.z, 1.0) - p.b)});
            ++comparados;
            suma += d;
            malos += d > 12;
            peor = std::max(peor, d);
        }
    std::printf("solenoide: %d píxeles, error medio %.2f, máximo %.1f, %d de más de 12\n", comparados,
                suma / comparados, peor, malos);
    apuntaDiferencia(peor, -1, 1);
    EXPECT_EQ(fuera, 0);
    EXPECT_EQ(huecos, 0);
    EXPECT_GT(comparados, t.ancho * t.alto / 40);
    EXPECT_EQ(malos, 0);
    EXPECT_LT(suma / comparados, 0.8);
}

TEST(SolenoideVista, ContraLaHeliceTrazada) {
    compruebaSolenoide("", 7, false, {160, 120});
    compruebaSolenoide("tecla +; tecla +; tecla -", 8, false, {160, 120});
    compruebaSolenoide("tecla -; tecla -; tecla -; tecla s", 4, true, {160, 120});
    compruebaSolenoide("tecla s; tecla s; tecla -; tecla -; tecla -; tecla -; tecla -; tecla -", 2, false,
                       {160, 90});
}

// ---- El editor: el más cercano en la pantalla ----

TEST(Editor, MasCercanoYLlevado) {
    const glm::mat4 ver = glm::perspective(0.9f, 1.5f, 0.5f, 50.0f) *
                          glm::lookAt(glm::vec3(1, 2, 6), glm::vec3(0), glm::vec3(0, 1, 0));
    const std::vector<glm::vec3> P = {{0, 0, 0}, {1, 1, 0}, {-1, 0.5f, 2}, {0, 0, 40}, {0.02f, 0, 0}};
    const glm::vec2 porUnidad(1.5f, 1);
    const auto enPantalla = [&](const glm::vec3 &p) {
        const glm::vec4 q = ver * glm::vec4(p, 1);
        return glm::vec2(q) / q.w;
    };
    for (const int i : {0, 1, 2, 4}) // el 3 está detrás de la cámara y no se coge nunca
        EXPECT_EQ(masCercano(P, ver, enPantalla(P[static_cast<std::size_t>(i)]), porUnidad, 0.1f), i);
    EXPECT_EQ(masCercano(P, ver, enPantalla(P[3]), porUnidad, 1e-3f), -1);
    EXPECT_EQ(masCercano(P, ver, {0.9f, -0.9f}, porUnidad, 0.1f), -1);
    // se mide en la pantalla, no en las coordenadas normalizadas: en X una unidad es 1.5 veces más larga
    const glm::vec2 c = enPantalla(P[1]);
    EXPECT_EQ(masCercano(P, ver, c + glm::vec2(0.08f, 0), porUnidad, 0.1f), -1);
    EXPECT_EQ(masCercano(P, ver, c + glm::vec2(0, 0.08f), porUnidad, 0.1f), 1);
    for (const glm::vec3 &p : {P[0], P[1], P[2]}) {
        const glm::vec2 sitio(0.3f, -0.4f);
        const glm::vec3 q = llevado(p, ver, sitio);
        EXPECT_LT(glm::distance(enPantalla(q), sitio), 1e-5f);
        const glm::vec4 antes = ver * glm::vec4(p, 1), despues = ver * glm::vec4(q, 1);
        EXPECT_NEAR(antes.w, despues.w, 1e-4f); // a la misma profundidad
    }
}

} // namespace
