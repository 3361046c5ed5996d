// Los programas de curvas del capítulo 11: todo lo que pintan, pincelada a pincelada, con las fórmulas del libro en
// doble precisión; también después de arrastrar, de las teclas y de cambiar de tamaño. Y el solenoide, trazado.
#include "ch11_curvas/continuidad.h"
#include "ch11_curvas/editor.h"
#include "ch11_curvas/escenas_curvas.h"
#include "ch11_curvas/solenoide.h"
#include "ch11_lista.h"
#include "ch11_referencia.h"
#include "pintado.h"
#include <glm/gtc/matrix_transform.hpp>

namespace {

using G4 = Geometria<double>;
using Pasos = std::vector<Paso<Lista>>;

const glm::ivec2 NORMAL{480, 360}, ANCHA{640, 360}, ALTA{480, 640};
const glm::dvec2 PASO{0.4 / 3, 0.1}; // de una flecha del teclado, en las unidades de paralelaVentana(1)

Puntos planos(const std::vector<glm::vec3> &P) {
    return Puntos(P.begin(), P.end());
}
G4 cuatro(const Puntos &P, std::size_t desde = 0) {
    G4 G;
    for (std::size_t k = 0; k < 4; ++k)
        G[k] = {P[(desde + k) % P.size()], 0};
    return G;
}
/// Q(u), o una derivada, sin su z.
auto curvaDe(Base base, const G4 &G, int derivada = 0) {
    return [=](double u) { return glm::dvec2(curvaRef(base, G, u, derivada)); };
}

/// Lo que se ve de un programa de puntos que se arrastran.
struct ConPuntos {
    Puntos P;
    int elegido = -1;
    void mueve(std::size_t i, const glm::dvec2 &d) {
        P[i] += d;
    }
    glm::vec3 colorNombre(std::size_t i) const {
        return int(i) == elegido ? ROJO : OSCURO;
    }
};
/// Lo que se hace con él, y lo que debe verse tras cada cosa.
template<typename Vista>
struct Sesion {
    Vista v;
    glm::ivec2 ventana = NORMAL;
    Pasos pasos;
    void paso(const std::string &guion) {
        pasos.push_back({guion, v.lista(ventana)});
    }
    void lleva(std::size_t i, const glm::dvec2 &adonde) {
        const Lista l = v.lista(ventana);
        const glm::ivec2 desde = l.raton(v.P[i]) + glm::ivec2(4, -3), hasta = l.raton(adonde);
        v.mueve(i, l.punto(hasta) - v.P[i]);
        v.elegido = int(i);
        paso(arrastra(desde, hasta));
    }
    void flechas(std::size_t i, const glm::dvec2 &cuantas, const std::string &guion) {
        v.mueve(i, cuantas * PASO);
        v.elegido = int(i);
        paso(guion);
    }
};

// ---- bezier ----

struct Bezier : ConPuntos {
    double u;
    explicit Bezier(double elU = 0.4) : ConPuntos{planos(PUNTOS_BEZIER)}, u(elU) {
    }
    Lista lista(const glm::ivec2 &ventana = NORMAL) const {
        Lista l(ventana);
        l.paralela(1);
        // el casco: cada punto suyo está en un triángulo de tres de ellos
        for (int falta = 0; falta < 4; ++falta) {
            Puntos tres = P;
            tres.erase(tres.begin() + falta);
            l.trazo("poligono", tres, glm::mix(FONDO_CLARO, AZUL, 0.1f));
        }
        std::vector<Puntos> niveles = {P, {}, {}, {}};
        for (std::size_t k = 1; k < 4; ++k)
            for (std::size_t i = 0; i + k < 4; ++i)
                niveles[k].push_back(glm::mix(niveles[k - 1][i], niveles[k - 1][i + 1], u));
        const glm::vec3 color[] = {GRIS, VERDE, NARANJA, ROJO};
        for (std::size_t k = 0; k < 3; ++k)
            l.trazo("polilinea", niveles[k], color[k], 0.8 * GROSOR);
        l.curva(curvaDe(Base::BEZIER, cuatro(P)), AZUL, 1.7 * GROSOR, 0.1);
        for (std::size_t k = 1; k < 4; ++k)
            l.trazo("puntos", niveles[k], color[k], (k == 3 ? 5 : 2.5) * GROSOR);
        l.trazo("puntos", P, OSCURO, 4 * GROSOR);
        for (std::size_t i = 0; i < 4; ++i)
            l.rotulo("P" + std::to_string(i + 1), P[i], colorNombre(i),
                     i % 3 == 0 ? Lado::DEBAJO : Lado::ENCIMA);
        const glm::dvec2 Q = niveles[3][0], dentro = 0.25 * (P[0] + P[1] + P[2] + P[3]) - Q;
        l.rotulo("Q(u)", Q + 0.2 * dentro / std::max(glm::length(dentro), 0.01), ROJO, Lado::CENTRO);
        l.rotulo("M_B =\n| -1  3 -3  1 |\n|  3 -6  3  0 |\n| -3  3  0  0 |\n|  1  0  0  0 |", {0.05, -0.28},
                 OSCURO, Lado::CENTRO, 0.034);
        char pesos[80]; // ecuación 11.18
        std::snprintf(pesos, sizeof pesos, "UM_B = %.2f %.2f %.2f %.2f", std::pow(1 - u, 3),
                      3 * u * std::pow(1 - u, 2), 3 * u * u * (1 - u), u * u * u);
        l.rotulo(pesos, {0.05, -0.79}, OSCURO, Lado::CENTRO, 0.034);
        return l;
    }
};

TEST(Bezier, CurvaCascoYDeCasteljau) {
    compruebaPasos<Lista>("bezier", {{"", Bezier().lista()},
                                     {"tecla u ×3", Bezier(0.55).lista()},
                                     {"tecla U ×4", Bezier(0.35).lista()},
                                     {"tecla u ×20", Bezier(1).lista()},
                                     {"tecla U ×20", Bezier(0).lista()},
                                     {"tamano 640 360", Bezier(0).lista(ANCHA)},
                                     {"tamano 480 640; tecla u", Bezier(0.05).lista(ALTA)}});
}

TEST(Bezier, PuntosArrastradosYConElTeclado) {
    for (const glm::ivec2 &ventana : {NORMAL, ALTA}) {
        Sesion<Bezier> s{Bezier(), ventana, {}};
        const Lista l = s.v.lista(ventana);
        const auto nadie = [&](const glm::dvec2 &desde, const std::string &boton) {
            s.paso(arrastra(l.raton(desde), l.raton({0.5, 0.5}), boton));
        };
        s.paso("especial ARRIBA");    // ninguno está elegido
        nadie({0.3, 0}, "IZQUIERDO"); // lejos de todos
        nadie(s.v.P[0], "DERECHO");
        nadie(s.v.P[0] + glm::dvec2(0.11, 0), "IZQUIERDO"); // el alcance, una décima, también en horizontal
        s.lleva(1, {-0.3, 0.75});
        nadie({0.3, 0}, "IZQUIERDO"); // y el de antes está suelto
        s.flechas(3, {-1, -2}, "tecla n ×2; especial IZQUIERDA; especial ABAJO ×2");
        s.flechas(0, {2, 1}, "tecla n; especial DERECHA ×2; especial ARRIBA; especial INICIO");
        s.v.P[0].y = 0.95 * ventana.y / oraculo::altoUtil(ventana.x, ventana.y); // hasta cerca del borde
        s.paso("especial ARRIBA ×40");
        compruebaPasos("bezier", s.pasos);
    }
}

/// Los cuatro puntos de bezier, llevados al mismo sitio.
Sesion<Bezier> juntos() {
    Sesion<Bezier> s;
    for (const std::size_t i : {1, 2, 3, 0})
        s.lleva(i, {0, 0});
    return s;
}

// Dos puntos en el mismo sitio, y los cuatro: nada se rompe.
TEST(Bezier, PuntosCoincidentes) {
    Sesion<Bezier> dos;
    dos.lleva(1, dos.v.P[0]);
    compruebaPasos("bezier", dos.pasos);
    compruebaPasos("bezier", juntos().pasos);
}

// ---- hermite ----

struct Hermite : ConPuntos {
    double k;
    bool transforma = false;
    /// Con el segundo tramo, si k no es 0.
    explicit Hermite(double elK = 0) : ConPuntos{planos(PUNTOS_HERMITE)}, k(elK) {
        for (std::size_t i = 0; k > 0 && i < 2; ++i)
            P.push_back(planos(SEGUNDO_HERMITE)[i]);
    }
    static Hermite transformada() {
        Hermite h;
        h.transforma = true;
        return h;
    }
    void mueve(std::size_t i, const glm::dvec2 &d) {
        P[i] += d;
        if (i < 2 || i == 4) // se lleva su flecha
            P[i == 4 ? 5 : i + 2] += d;
    }
    Lista lista(const glm::ivec2 &ventana = NORMAL) const {
        Lista l(ventana);
        l.paralela(k > 0 ? 1.38 : 1, k > 0 ? glm::dvec2(0.55, 0.12) : glm::dvec2(0));
        const auto tramo = [&](const Puntos &G, const glm::vec3 &color,
                               const std::vector<std::string> &nombres,
                               const std::array<std::size_t, 4> &puntos, const glm::vec3 &color1 = VERDE,
                               const glm::vec3 &color4 = NARANJA) {
            l.curva(curvaDe(Base::HERMITE, cuatro(G)), color, 1.7 * GROSOR, 0.1);
            l.trazo("flecha", {G[0], G[0] + G[2]}, color1);
            l.trazo("flecha", {G[1], G[1] + G[3]}, color4);
            l.trazo("puntos", {G[0], G[1]}, OSCURO, 4 * GROSOR);
            const Puntos sitios = {G[0], G[1] + glm::dvec2(0, G[3].y < 0 ? 0.05 : -0.05), G[0] + G[2],
                                   G[1] + G[3]};
            for (std::size_t i = 0; i < nombres.size(); ++i)
                if (!nombres[i].empty())
                    l.rotulo(nombres[i], sitios[i], colorNombre(puntos[i]),
                             i == 0 ? Lado::DEBAJO : Lado::DERECHA);
        };
        Puntos G = {P[0], P[1], P[2] - P[0], P[3] - P[1]}, transformados;
        if (transforma) {
            tramo(G, GRIS, {}, {}, GRIS, GRIS);
            const glm::dvec2 giro(std::cos(double(T_GIRO)), std::sin(double(T_GIRO)));
            const auto T = [&](const glm::dvec2 &p, double w) {
                const glm::dvec2 q = p * glm::dvec2(T_ESCALADO);
                return glm::dvec2(giro.x * q.x - giro.y * q.y, giro.y * q.x + giro.x * q.y) +
                       w * glm::dvec2(T_TRASLACION);
            };
            for (int i = 0; i <= 16; ++i)
                transformados.push_back(T(curvaDe(Base::HERMITE, cuatro(G))(i / 16.0), 1));
            G = {T(G[0], 1), T(G[1], 1), T(G[2], 0), T(G[3], 0)};
        }
        tramo(G, AZUL, {"P1", "P4", "R1", "R4"}, {0, 1, 2, 3});
        if (transforma)
            l.trazo("puntos", transformados, ROJO, 3 * GROSOR);
        if (k > 0)
            tramo({P[1], P[4], k * G[3], P[5] - P[4]}, MORADO, {"", "P4'", "k·R4", "R4'"}, {9, 4, 9, 5});
        l.rotulo("M_H =\n|  2 -2  1  1 |\n| -3  3 -2 -1 |\n|  0  0  1  0 |\n|  1  0  0  0 |", {-0.1, -0.62},
                 OSCURO, Lado::CENTRO, 0.034);
        return l;
    }
};

TEST(Hermite, CurvaTangentesYTransformada) {
    compruebaPasos<Lista>("hermite",
                          {{"", Hermite().lista()},
                           {"tecla g", Hermite(0.5).lista()},
                           {"tecla + ×2", Hermite(0.7).lista()},
                           {"tecla + ×20", Hermite(1.5).lista()},
                           {"tecla - ×40", Hermite(0.2).lista()},
                           {"tecla t", Hermite::transformada().lista()},
                           {"tecla g", Hermite(0.2).lista()},
                           {"tecla g", Hermite().lista()}}); // y no la transformada, que se ha dejado
    for (const glm::ivec2 &ventana : {ANCHA, ALTA})
        compruebaPasos<Lista>("hermite", {{"", Hermite().lista(ventana)},
                                          {"tecla g", Hermite(0.5).lista(ventana)},
                                          {"tecla t", Hermite::transformada().lista(ventana)}});
}

// Con la mayor k, la flecha k·R4 y su nombre caben en la ventana.
TEST(Hermite, ConLaMayorKNadaSeSale) {
    for (const glm::ivec2 &ventana : {NORMAL, ANCHA, ALTA}) {
        const Vista vista = vistaDe("hermite", "tecla g; tecla + ×40", ventana.x, ventana.y);
        for (const Pintado &p : vista.encima)
            for (std::size_t i = 0; i < p.puntos.size(); ++i)
                EXPECT_TRUE(glm::all(glm::greaterThan(p.punto(i), glm::dvec2(4))) &&
                            glm::all(glm::lessThan(p.punto(i), glm::dvec2(ventana) - 4.0)))
                    << p.tipo << " " << p.texto;
    }
}

TEST(Hermite, ArrastrarPuntosYPuntas) {
    for (const glm::ivec2 &ventana : {NORMAL, ANCHA})
        for (const double k : {0.0, 0.5}) {
            Sesion<Hermite> s{Hermite(k), ventana, {}};
            s.paso(k > 0 ? "tecla g" : "");
            s.lleva(0, {-0.6, -0.4});
            s.lleva(3, {0.9, -0.1});  // la punta va sola
            s.lleva(2, {-0.6, -0.4}); // aunque quede sin tangente
            if (k > 0) {
                s.lleva(4, {1.5, 0.1});
                s.lleva(5, {1.6, 0.9});
            }
            compruebaPasos("hermite", s.pasos);
        }
}

// Los puntos del segundo tramo no se eligen ni se cogen cuando no se ven, y al cambiar no queda ninguno elegido.
TEST(Hermite, LoQueNoSeVeNoSeCoge) {
    const Lista ancha = Hermite().lista({720, 360}); // aquí P4' cae dentro de la ventana
    compruebaPasos<Lista>("hermite",
                          {{arrastra(ancha.raton(Hermite(1).P[4]), ancha.raton({0.2, 0.8})), ancha}});
    Hermite primero;
    primero.elegido = 0;
    compruebaPasos<Lista>("hermite",
                          {{"tecla n ×5", primero.lista()},
                           {"tecla g", Hermite(0.5).lista()},
                           {"tecla n ×5; tecla g; especial ARRIBA", Hermite().lista()},
                           {"tecla n; tecla t; especial ARRIBA", Hermite::transformada().lista()}});
}

// ---- bspline ----

struct BSpline : ConPuntos {
    bool cerrada, peine;
    explicit BSpline(bool siCerrada = false, bool siPeine = false)
        : ConPuntos{planos(PUNTOS_BSPLINE)}, cerrada(siCerrada), peine(siPeine) {
    }
    Lista lista(const glm::ivec2 &ventana = NORMAL) const {
        Lista l(ventana);
        l.paralela(1);
        const std::size_t tramos = cerrada ? 9 : 6;
        Puntos poligono = P, nudos;
        if (cerrada)
            poligono.push_back(P[0]);
        l.trazo("polilinea", poligono, glm::mix(GRIS, BLANCO, 0.4f), 0.6 * GROSOR);
        for (std::size_t i = 0; i < tramos; ++i)
            l.curva(curvaDe(Base::BSPLINE, cuatro(planos(PUNTOS_BSPLINE), i)), GRIS, GROSOR, 0.1);
        for (std::size_t i = 0; peine && i < tramos; ++i) {
            Puntos puas, puntas;
            for (int k = 0; k <= 20; ++k) {
                const auto derivada = [&](int n) {
                    return curvaDe(Base::BSPLINE, cuatro(P, i), n)(k / 20.0);
                };
                const glm::dvec2 d = derivada(1), dd = derivada(2),
                                 normal = glm::dvec2(-d.y, d.x) / glm::length(d);
                const double curvatura = (d.x * dd.y - d.y * dd.x) / std::pow(glm::length(d), 3); // con signo
                puntas.push_back(derivada(0) - double(LARGO_PUAS) * curvatura * normal);
                puas.insert(puas.end(), {derivada(0), puntas.back()});
            }
            l.trazo("segmentos", puas, VERDE, 0.4 * GROSOR);
            l.trazo("polilinea", puntas, VERDE, 0.8 * GROSOR);
        }
        for (std::size_t i = 0; i < tramos; ++i) {
            const bool usa = elegido >= 0 && (std::size_t(elegido) + 9 - i) % 9 < 4;
            l.curva(curvaDe(Base::BSPLINE, cuatro(P, i)), usa ? ROJO : AZUL, 1.7 * GROSOR, 0.1);
            for (const std::size_t j : {i, i + 1})
                nudos.push_back((P[j % 9] + 4.0 * P[(j + 1) % 9] + P[(j + 2) % 9]) / 6.0);
        }
        l.trazo("puntos", nudos, NARANJA, 3 * GROSOR);
        l.trazo("puntos", P, OSCURO, 4 * GROSOR);
        const Lado lados[] = {Lado::IZQUIERDA, Lado::ENCIMA, Lado::DEBAJO, Lado::ENCIMA, Lado::ENCIMA,
                              Lado::DERECHA,   Lado::DEBAJO, Lado::ENCIMA, Lado::DEBAJO};
        for (std::size_t i = 0; i < 9; ++i)
            l.rotulo("P" + std::to_string(i), P[i], colorNombre(i), lados[i]);
        l.rotulo("M_BS = 1/6\n| -1  3 -3  1 |\n|  3 -6  3  0 |\n| -3  0  3  0 |\n|  1  4  1  0 |",
                 {-0.46, 0.04}, OSCURO, Lado::CENTRO, 0.9 * 0.034);
        return l;
    }
};

TEST(BSpline, AbiertaCerradaYPeine) {
    compruebaPasos<Lista>("bspline", {{"", BSpline().lista()},
                                      {"tecla c", BSpline(true).lista()},
                                      {"tecla k", BSpline(true, true).lista()},
                                      {"tamano 640 360", BSpline(true, true).lista(ANCHA)},
                                      {"tecla c", BSpline(false, true).lista(ANCHA)},
                                      {"tecla k; tamano 480 640", BSpline().lista(ALTA)},
                                      {"tecla c", BSpline(true).lista(ALTA)}});
}

TEST(BSpline, ControlLocal) {
    Sesion<BSpline> s{BSpline(true, true), NORMAL, {}};
    s.paso("tecla c; tecla k");
    for (const std::size_t i : {0, 4, 7})
        s.lleva(i, 0.6 * s.v.P[i]);
    s.v.cerrada = false;
    s.paso("tecla c");
    compruebaPasos("bspline", s.pasos);
}

// ---- bezier_n ----

Lista bezierN(std::size_t n, const glm::ivec2 &ventana = NORMAL) {
    const auto colorDe = [&](std::size_t i) {
        const float t = 2 * float(i) / float(n - 1);
        return t < 1 ? AZUL + t * (NARANJA - AZUL) : NARANJA + (t - 1) * (ROJO - NARANJA);
    };
    // ecuación 11.20, con el binomio por logaritmos
    const auto polinomio = [m = double(n - 1)](std::size_t i, double u) {
        const double k = double(i), lnC = std::lgamma(m + 1) - std::lgamma(k + 1) - std::lgamma(m - k + 1);
        return std::exp(lnC) * std::pow(u, k) * std::pow(1 - u, m - k);
    };
    const Puntos P = planos(puntosZigzag(n));
    Lista l(ventana);
    l.enPanel(hueco(0, 1, 0, 2, ventana.x, ventana.y));
    l.normalizadas({1.7, 0.9}, {-0.85, 0});
    l.trazo("polilinea", P, GRIS, 0.5 * GROSOR);
    const auto curva = [&](double u) {
        glm::dvec2 Q(0);
        for (std::size_t k = 0; k < n; ++k)
            Q += polinomio(k, u) * P[k];
        return Q;
    };
    // 0.2 de lo que mide un píxel en el lado más largo del panel, del que una unidad es 0.85
    l.curva(curva, AZUL, 1.7 * GROSOR, 0.17);
    for (std::size_t i = 0; i < n; ++i)
        l.trazo("puntos", {P[i]}, colorDe(i), 3 * GROSOR);
    l.rotulo("P0", P.front(), OSCURO, Lado::DEBAJO);
    l.rotulo("P" + std::to_string(n - 1), P.back(), OSCURO, Lado::ENCIMA);

    l.enPanel(hueco(0, 1, 1, 2, ventana.x, ventana.y));
    l.normalizadas({1.7, 1.4}, {-0.85, -0.6});
    l.trazo("polilinea", {{0, 1}, {0, 0}, {1, 0}}, OSCURO, 0.6 * GROSOR);
    for (std::size_t k = 0; k < n; ++k)
        l.curva([&](double u) { return glm::dvec2(u, polinomio(k, u)); }, colorDe(k), 0.8 * GROSOR, 0.17);
    l.rotulo("0", {0, 0}, OSCURO, Lado::DEBAJO);
    l.rotulo("u", {0.5, 0}, OSCURO, Lado::DEBAJO);
    l.rotulo("1", {1, 0}, OSCURO, Lado::DEBAJO);
    l.rotulo("1", {0, 1}, OSCURO, Lado::IZQUIERDA);
    return l;
}

TEST(BezierN, CurvaYPolinomiosDeBernstein) {
    compruebaPasos<Lista>("bezier_n", {{"", bezierN(4)},
                                       {"tecla 2", bezierN(10)},
                                       {"tecla 3", bezierN(40)},
                                       {"tecla 4", bezierN(61)},
                                       {"tecla + ×2", bezierN(61)}, // no hay más
                                       {"tecla 1; tecla + ×3", bezierN(7)},
                                       {"tecla - ×7", bezierN(2)}, // ni menos
                                       {"tecla +; tamano 640 360", bezierN(3, ANCHA)},
                                       {"tamano 480 640", bezierN(3, ALTA)}});
}

// ---- continuidad ----

const char *const NOMBRES_CONTINUIDAD[] = {"C0", "G1", "C1", "C2"};

/// Los dos tramos y, en u, por dónde va el coche: su posición o una derivada.
struct Recorrido {
    G4 tramo[2];
    double u;
    Recorrido(Continuidad c, double elU) : u(elU) {
        const Geometria<float> G[] = {PRIMER_TRAMO, segundoTramo(c)};
        for (const int i : {0, 1})
            tramo[i] = cuatro({G[i][0], G[i][1], G[i][2], G[i][3]});
    }
    auto curva(int i, int derivada = 0) const {
        return curvaDe(Base::HERMITE, tramo[i], derivada);
    }
    glm::dvec2 coche(int derivada) const {
        return curva(u >= 1, derivada)(u - (u >= 1));
    }
};

void anadePlano(Lista &l, const Hueco &h, Continuidad c, const Recorrido &r) {
    l.enPanel(h);
    const double aspecto = double(h.ancho) / h.alto, y = std::max(0.7, 1.3 / aspecto);
    const glm::dvec2 m(1 / (y * aspecto), 1 / y);
    l.normalizadas(m, -glm::dvec2(0, 0.22) * m);
    // 0.4/alto de tolerancia, en una vista de dos semialtos: en píxeles
    for (const int i : {0, 1})
        l.curva(r.curva(i), i ? MORADO : AZUL, 1.7 * GROSOR, 0.2 / y);
    l.trazo("puntos", {glm::dvec2(r.tramo[0][1])}, OSCURO, 3 * GROSOR);
    const glm::dvec2 Q = r.coche(0), F = glm::normalize(r.coche(1)), L(-F.y, F.x);
    l.trazo("flecha", {Q, Q + double(VELOCIDAD) * r.coche(1)}, VERDE);
    l.trazo("poligono", {Q + 0.10 * F, Q - 0.08 * F + 0.07 * L, Q - 0.08 * F - 0.07 * L}, NARANJA);
    l.normalizadas({2, 2}, {-1, -1});
    l.rotulo(NOMBRES_CONTINUIDAD[c], {0.12, 0.2}, OSCURO, Lado::CENTRO, 1.3 * TALLA_ROTULO);
}

void anadeGrafica(Lista &l, const Hueco &h, Continuidad c, const Recorrido &r, int d) {
    const double maxima = double(d == 1 ? RAPIDEZ_MAXIMA : ACELERACION_MAXIMA);
    const glm::vec3 color = d == 1 ? VERDE : ROJO;
    l.enPanel(h);
    l.normalizadas({0.78, 1.45 / maxima}, {-0.86, -0.75});
    l.trazo("segmentos", {{r.u, 0}, {r.u, maxima}}, GRIS, 0.6 * GROSOR);
    l.trazo("polilinea", {{0, maxima}, {0, 0}, {2, 0}}, OSCURO, 0.6 * GROSOR);
    l.trazo("puntos", {{1, 0}}, OSCURO, 3 * GROSOR);
    const auto altura = [&](int i, double t) { return glm::dvec2(i + t, glm::length(r.curva(i, d)(t))); };
    for (const int i : {0, 1}) // de 48 cuerdas: |Q''| hace un pico donde casi se anula
        l.curva([&](double t) { return altura(i, t); }, color, 1.3 * GROSOR, 0.6);
    if (c <= G1 || (c == C1 && d == 2)) // donde salta
        l.trazo("puntos", {altura(0, 1), altura(1, 0)}, color, 3 * GROSOR);
    l.rotulo(d == 1 ? "|Q'|" : "|Q''|", {0, maxima}, color, Lado::DERECHA, 0.032);
    l.rotulo("u", {2, 0}, OSCURO, Lado::DERECHA, 0.032);
}

/// La vista desde el coche: el ojo, a 0.07 del suelo, mira hacia donde va. Lo que queda a menos de 0.05 se corta.
void anadeVista(Lista &l, const Hueco &h, const Recorrido &r) {
    l.enPanel(h, CIELO);
    const glm::dvec2 Q = r.coche(0), F = glm::normalize(r.coche(1)), derecha(F.y, -F.x);
    const double cerca = 0.05, foco = 0.5 * h.alto / std::tan(0.5);
    using Punto3 = glm::dvec3; // hacia la derecha, hacia arriba y hacia delante
    const auto ver = [&](const glm::dvec2 &p, double z) {
        return Punto3(glm::dot(p - Q, derecha), z - 0.07, glm::dot(p - Q, F));
    };
    const auto px = [&](const Punto3 &p) {
        return glm::dvec2(h.x + 0.5 * h.ancho, h.y + 0.5 * h.alto) + foco * glm::dvec2(p) / p.z;
    };
    l.pixeles();
    const auto poligono = [&](const std::vector<Punto3> &P, const glm::vec3 &color) {
        Puntos vistos;
        for (const Punto3 &p : P) {
            if (p.z < cerca)
                return;
            vistos.push_back(px(p));
        }
        l.trazo("poligono", vistos, color);
    };
    for (int i = 0; i < 16; ++i) {
        const auto en = [&](double k, double alto) {
            const double a = 2 * M_PI * (i + k) / 16;
            return ver({20 * std::cos(a), 20 * std::sin(a)}, alto);
        };
        poligono({en(-0.6, 0), en(0.6, 0), en(0, 1.5 + i * 5 % 7 * 0.5)},
                 CIELO + (0.2f + 0.1f * float(i % 3)) * (AZUL - CIELO));
    }
    l.trazo(
        "poligono",
        {{h.x, h.y}, {h.x + h.ancho, h.y}, {h.x + h.ancho, h.y + 0.5 * h.alto}, {h.x, h.y + 0.5 * h.alto}},
        SUELO);
    Puntos cuadricula;
    const auto raya = [&](const glm::dvec2 &desde, const glm::dvec2 &hasta) {
        Punto3 a = ver(desde, 0), b = ver(hasta, 0);
        if (a.z < cerca && b.z < cerca)
            return;
        if (a.z < cerca)
            a += (cerca - a.z) / (b.z - a.z) * (b - a);
        if (b.z < cerca)
            b += (cerca - b.z) / (a.z - b.z) * (a - b);
        cuadricula.insert(cuadricula.end(), {px(a), px(b)});
    };
    for (int i = -8; i <= 8; ++i) {
        raya({0.25 * i, -2}, {0.25 * i, 2});
        raya({-2, 0.25 * i}, {2, 0.25 * i});
    }
    l.trazo("segmentos", cuadricula, SUELO + 0.45f * (BLANCO - SUELO), 0.5 * GROSOR);
    for (int tramo : {1, 0})
        for (int i = 47; i >= 0; --i) {
            const auto borde = [&](int k, double lado) {
                const glm::dvec2 T = glm::normalize(r.curva(tramo, 1)(k / 48.0));
                return ver(r.curva(tramo)(k / 48.0) + lado * 0.05 * glm::dvec2(-T.y, T.x), 0);
            };
            const glm::vec3 color = tramo ? MORADO : AZUL;
            poligono({borde(i, -1), borde(i, 1), borde(i + 1, 1), borde(i + 1, -1)},
                     color + (i % 4 < 2 ? 0.0f : 0.2f) * (BLANCO - color));
        }
    l.normalizadas({2, 2}, {-1, -1});
    l.rotulo("desde el coche", {0.5, 0.9}, OSCURO, Lado::CENTRO, 0.032);
}

/// Una unión, a los milisegundos que lleva andados el coche, y las cuatro, una en cada fila.
Lista una(Continuidad c, int milisegundos = 1900, const glm::ivec2 &ventana = NORMAL) {
    Lista l(ventana);
    const Recorrido r(c, milisegundos % 4000 / 2000.0);
    const auto celda = [&](int columna, int fila) {
        return hueco(columna, 2, fila, 2, ventana.x, ventana.y);
    };
    anadePlano(l, celda(0, 0), c, r);
    anadeVista(l, celda(1, 0), r);
    for (const int d : {1, 2})
        anadeGrafica(l, celda(d - 1, 1), c, r, d);
    return l;
}
Lista lasCuatro(const glm::ivec2 &ventana = NORMAL) {
    Lista l(ventana);
    for (const Continuidad c : {C0, G1, C1, C2}) {
        const Recorrido r(c, 0.95);
        const auto celda = [&](int columna) { return hueco(columna, 3, c, 4, ventana.x, ventana.y); };
        anadePlano(l, celda(0), c, r);
        for (const int d : {1, 2})
            anadeGrafica(l, celda(d), c, r, d);
    }
    return l;
}

TEST(ContinuidadVista, LasCuatroYCadaUna) {
    compruebaPasos<Lista>("continuidad", {{"", lasCuatro()},
                                          {"tecla 1", una(C0)},
                                          {"tecla 2", una(G1)},
                                          {"tecla 3", una(C1)},
                                          {"tecla 4", una(C2)},
                                          {"tecla v", lasCuatro()},
                                          {"tecla v; tamano 640 360", una(C2, 1900, ANCHA)},
                                          {"tamano 480 640", una(C2, 1900, ALTA)},
                                          {"tecla v; tamano 360 900", lasCuatro({360, 900})},
                                          {"tamano 640 480", lasCuatro({640, 480})}});
}

// Se dibuja cada 16 ms desde que empieza el programa: lo que se ve es de la última vez.
TEST(ContinuidadVista, ElCocheSigueAlReloj) {
    // pasada la unión mira ya adonde va; y da más de una vuelta
    compruebaPasos<Lista>("continuidad", {{"tecla 1; tecla t; espera 112", una(C0, 2012)},
                                          {"tecla 3; espera 8000; espera 999", una(C1, 3004)}});
}

// ---- Lo que se ve ----

// En cualquier imagen de estos programas, los píxeles son los de su lista sobre su escena.
TEST(Pintado, LaListaSobreLaEscena) {
    std::string junta;
    for (const auto &paso : juntos().pasos)
        junta += paso.guion + "; ";
    const struct {
        std::string programa, guion;
        glm::ivec2 ventana;
    } casos[] = {{"bezier", "tecla n ×2; especial IZQUIERDA; especial ABAJO ×2; tecla u ×2", ANCHA},
                 {"bezier", junta, NORMAL},
                 {"bezier_n", "", ALTA},
                 {"bezier_n", "tecla 2", NORMAL},
                 {"bezier_n", "tecla 3", {960, 720}},
                 {"bspline", "tecla c", ALTA},
                 {"bspline", "tecla c; tecla k", {640, 480}},
                 {"bspline", "tecla c; tecla n ×8; especial ARRIBA ×4", NORMAL},
                 {"continuidad", "", {640, 480}},
                 {"continuidad", "espera 0; tecla 1; tecla t; espera 1100", NORMAL},
                 {"continuidad", "espera 0; tecla 4; tecla t; espera 1100", ALTA},
                 {"hermite", "tecla g", NORMAL},
                 {"hermite", "tecla t", ALTA},
                 {"superficie_bezier", "tecla n ×6; especial ABAJO ×7", NORMAL}};
    for (const auto &c : casos)
        compruebaPintado(c.programa, c.guion, c.ventana);
}

// ---- solenoide ----

// El tubo que ch11_curvas.Solenoide compara con la hélice, con dos esferas en las puntas.
TEST(SolenoideVista, ContraLaHeliceTrazada) {
    const oraculo::Material cobre{{0.22, 0.09, 0.04}, {0.72, 0.32, 0.16}, {0.60, 0.45, 0.35}, 40},
        acero{{0.22, 0.25, 0.30}, {0.50, 0.58, 0.66}, {0.5, 0.5, 0.5}, 40};
    const struct {
        std::string guion;
        int vueltas;
        bool segmentos;
        double azimut, elevacion;
        glm::ivec2 ventana;
    } casos[] = {{"", 7, false, 0.45, 0.38, NORMAL},
                 {"tecla + ×2; tecla -", 8, false, 0.45, 0.38, {160, 120}},
                 {"tecla - ×3; tecla s", 4, true, 0.45, 0.38, {320, 240}},
                 {"tecla s ×2; tecla - ×6; tecla +", 3, false, 0.45, 0.38, {160, 90}},
                 {"tecla + ×20; " + arrastra({20, 20}, {60, 50}), 16, false, 0.05, 0.68, {240, 320}}};
    for (const auto &c : casos) {
        const Vista vista = vistaDe("solenoide", c.guion, c.ventana.x, c.ventana.y);
        EXPECT_TRUE(vista.encima.empty());
        oraculo::Escena escena;
        for (const int resto : {0, 1})
            escena.push_back(enElMundo({}, tuboSolenoide(c.vueltas, resto)));
        for (const double x : {-2.6, 2.6})
            escena.push_back(enElMundo(oraculo::traslada({x, 1.25, 0}) * oraculo::escala(0.13), esfera(24)));
        const auto color = [&](const oraculo::Impacto &i) {
            return !i ? exacto(FONDO_OSCURO)
                      : oraculo::phong(c.segmentos && i.objeto == 1 ? acero : cobre, {1, 1, 1},
                                       {direccional({-0.5, 0.8, 0.7})}, i.punto, i.normal,
                                       oraculo::haciaOjo(i));
        };
        const auto camara = oraculo::perspectiva(oraculo::orbita(c.azimut, c.elevacion, 10.4), 0.45, 1, 100);
        // en el brillo, elevado a 40, se notan los redondeos de la normal
        comprueba("solenoide, «" + c.guion + "»", oraculo::compara(vista.escena, escena, camara, color),
                  {0.51, 500, 0.012});
    }
}

// ---- El editor ----

// De dos que casi coinciden, el más cercano; y el que está detrás de la cámara, en el mismo sitio de la pantalla, no se
// coge nunca.
TEST(Editor, ElMasCercanoDeLosQueSeVen) {
    const glm::mat4 ver = glm::perspective(0.9f, 1.5f, 0.5f, 50.0f);
    const std::vector<glm::vec3> P = {{1, 1, -6}, {1.02f, 1, -6}}, detras = {{-1, -1, 6}};
    for (const int i : {0, 1}) {
        const glm::vec4 q = ver * glm::vec4(P[std::size_t(i)], 1);
        EXPECT_EQ(masCercano(P, ver, glm::vec2(q) / q.w, {1.5f, 1}, 0.1f), i);
        EXPECT_EQ(masCercano(detras, ver, glm::vec2(q) / q.w, {1.5f, 1}, 0.1f), -1);
    }
}

} // namespace
