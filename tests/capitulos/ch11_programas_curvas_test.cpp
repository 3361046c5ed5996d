// Los programas de curvas del capítulo 11: las curvas que trazan, con las fórmulas del libro en doble precisión; y el
// solenoide, trazado. Lo demás que pintan está en sus .encima.
#include "ch11_curvas/continuidad.h"
#include "ch11_curvas/editor.h"
#include "ch11_curvas/escenas_curvas.h"
#include "ch11_curvas/solenoide.h"
#include "ch11_referencia.h"
#include "guiones.h"
#include "pintado.h"
#include "plana.h"
#include "tabla.h"

namespace {

using G4 = Geometria<double>;
using Puntos = std::vector<glm::dvec2>;
using Curva = std::function<glm::dvec2(double)>;

const glm::ivec2 NORMAL{480, 360}, ANCHA{640, 360}, ALTA{480, 640};

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
Curva curvaDe(Base base, const G4 &G, int derivada = 0) {
    return [=](double u) { return glm::dvec2(curvaRef(base, G, u, derivada)); };
}

/// Las unidades de una vista: un punto suyo está en el píxel origen + escala·punto.
struct Plano {
    glm::dvec2 origen, escala;

    glm::dvec2 operator()(const glm::dvec2 &p) const {
        return origen + escala * p;
    }
};
/// Las de paralelaVentana(semialto), centrada en un punto.
Plano paralela(const Vista &v, double semialto = 1, const glm::dvec2 &centro = {0, 0}) {
    const glm::dvec2 talla(v.escena.ancho, v.escena.alto),
        escala(0.5 * oraculo::altoUtil(v.escena.ancho, v.escena.alto) / semialto);
    return {0.5 * talla - escala * centro, escala};
}
/// Las que, por m y más d, son coordenadas normalizadas del panel.
Plano enPanel(const Hueco &h, const glm::dvec2 &m, const glm::dvec2 &d) {
    const glm::dvec2 medio(0.5 * h.ancho, 0.5 * h.alto);
    return {glm::dvec2(h.x, h.y) + medio * (d + 1.0), medio * m};
}

/// Comprueba que las polilíneas de ese color son cuerdas de esas curvas, con u de 0 a 1: van por ellas de punta a
/// punta, sin volver atrás y sin separarse más de esos píxeles. Un float de 1000 se redondea a 6e-5: 0.01 sobra.
void compruebaCurvas(const Encima &encima, const glm::vec3 &color, const Plano &en,
                     const std::vector<Curva> &curvas, double tolerancia = 0.1) {
    const Encima cuerdas = encima.trazos(color, "polilinea");
    Encima deben;
    for (const Curva &f : curvas) {
        Pintado &p = deben.emplace_back();
        p.tipo = "polilinea";
        p.color = color;
        for (int i = 0; i <= 3000; ++i)
            p.puntos.emplace_back(en(f(i / 3000.0)), 0);
        compruebaTrazo(cuerdas, Puntos(p.puntos.begin(), p.puntos.end()), color, tolerancia);
    }
    EXPECT_LE(cuerdas.largo(color), deben.largo(color) + 0.01);
    double lejos = 0;
    for (const Pintado &p : cuerdas)
        for (std::size_t i = 0; i < p.puntos.size(); ++i)
            lejos = std::max(lejos, deben.lejosDeTrazo(p.punto(i), color));
    EXPECT_LE(lejos, 0.01);
}

/// La escena es el fondo o, si hay paneles, el de cada uno y el gris de en medio.
void compruebaFondo(const Vista &v, const std::vector<std::pair<Hueco, glm::vec3>> &paneles = {}) {
    std::vector<Pieza> piezas;
    for (const auto &[h, fondo] : paneles)
        piezas.push_back(rectangulo(h, exacto(fondo)));
    compruebaPlana("el fondo", v.escena, piezas, exacto(paneles.empty() ? FONDO_CLARO : GRIS));
}

// La curva, y Q(u) como lo da de Casteljau.
TEST(Bezier, LaCurvaYQ) {
    const struct {
        std::string guion;
        double u;
        glm::dvec2 P2; // lo que se ha movido
    } casos[] = {{"", 0.4, {0, 0}},
                 {"tecla u ×20", 1, {0, 0}},
                 {"tecla U ×9; tecla n ×2; especial IZQUIERDA; especial ABAJO ×2", 0.55, {-0.4 / 3, -0.2}},
                 {"tamano 480 640; tecla U ×20", 0, {-0.4 / 3, -0.2}}};
    paraCada("bezier", casos, NORMAL.x, NORMAL.y, [](const auto &c, const Vista &v) {
        compruebaFondo(v);
        Puntos P = planos(PUNTOS_BEZIER);
        P[1] += c.P2;
        compruebaCurvas(v.encima, AZUL, paralela(v), {curvaDe(Base::BEZIER, cuatro(P))});
        while (P.size() > 1) {
            for (std::size_t i = 0; i + 1 < P.size(); ++i)
                P[i] = glm::mix(P[i], P[i + 1], c.u);
            P.pop_back();
        }
        compruebaPuntos(v.encima, {paralela(v)(P[0])}, ROJO);
    });
}

// El primer tramo o, transformado, el de las restricciones transformadas y los puntos de la curva; y el segundo, G1.
TEST(Hermite, LosTramosYLaTransformada) {
    const struct {
        std::string guion;
        double k = 0;                          // 0 si no hay segundo tramo
        bool transforma = false, nula = false; // si R1 se ha hecho nula
    } casos[] = {{""},
                 {"tecla t", 0, true},
                 {"tecla g", 0.5},
                 {"tecla + ×20; tamano 480 640", 1.5},
                 {"tecla - ×40", 0.2},
                 {"tecla t; tamano 640 360", 0, true},
                 {"tecla t; tamano 480 360; " + arrastra({67, 288}, {132, 251}) + "; " +
                      arrastra({183, 7}, {132, 251}),
                  0, false, true}};
    paraCada("hermite", casos, NORMAL.x, NORMAL.y, [](const auto &c, const Vista &v) {
        compruebaFondo(v);
        const Plano en = c.k > 0 ? paralela(v, 1.38, {0.55, 0.12}) : paralela(v);
        Puntos P = planos(PUNTOS_HERMITE);
        const Puntos S = planos(SEGUNDO_HERMITE);
        if (c.nula)
            P[0] = P[2] = (glm::dvec2(132.5, 360 - 251.5) - en.origen) / en.escala;
        Puntos G = {P[0], P[1], P[2] - P[0], P[3] - P[1]}, rojos;
        const Curva Q = curvaDe(Base::HERMITE, cuatro(G));
        if (c.transforma) {
            const double a = double(T_GIRO);
            const glm::dmat2 M = glm::dmat2(std::cos(a), std::sin(a), -std::sin(a), std::cos(a)) *
                                 glm::dmat2(double(T_ESCALADO.x), 0, 0, double(T_ESCALADO.y));
            const glm::dvec2 t(T_TRASLACION);
            for (int i = 0; i <= 16; ++i)
                rojos.push_back(en(M * Q(i / 16.0) + t));
            G = {M * G[0] + t, M * G[1] + t, M * G[2], M * G[3]};
            compruebaCurvas(v.encima, GRIS, en, {Q});
        }
        compruebaCurvas(v.encima, AZUL, en, {curvaDe(Base::HERMITE, cuatro(G))});
        compruebaPuntos(v.encima, rojos, ROJO);
        if (c.k > 0)
            compruebaCurvas(v.encima, MORADO, en,
                            {curvaDe(Base::HERMITE, cuatro({P[1], S[0], c.k * G[3], S[1] - S[0]}))});
    });
}

// Los tramos, en rojo los que dependen del punto elegido, y el peine: cada púa va por la normal y mide la curvatura.
TEST(BSpline, LosTramosYElPeine) {
    const struct {
        std::string guion;
        std::size_t tramos;
        bool peine = false;
        int elegido = -1;
    } casos[] = {{"", 6},
                 {"tecla k", 6, true},
                 {"tecla c; tamano 480 640", 9, true},
                 {"tecla k; tecla n; especial ABAJO ×2", 9, false, 0},
                 {"tecla c; tamano 480 360", 6, false, 0}};
    paraCada("bspline", casos, NORMAL.x, NORMAL.y, [](const auto &c, const Vista &v) {
        compruebaFondo(v);
        const Plano en = paralela(v);
        Puntos P = planos(PUNTOS_BSPLINE), puas;
        if (c.elegido == 0)
            P[0].y -= 0.2;
        std::vector<Curva> rojos, azules;
        for (std::size_t i = 0; i < c.tramos; ++i) {
            const bool usa = c.elegido >= 0 && (std::size_t(c.elegido) + 9 - i) % 9 < 4;
            (usa ? rojos : azules).push_back(curvaDe(Base::BSPLINE, cuatro(P, i)));
            for (int k = 0; k <= 20 && c.peine; ++k) {
                const auto derivada = [&](int n) {
                    return curvaDe(Base::BSPLINE, cuatro(P, i), n)(k / 20.0);
                };
                const glm::dvec2 Q = derivada(0), d = derivada(1), dd = derivada(2);
                const double curvatura = (d.x * dd.y - d.y * dd.x) / std::pow(glm::length(d), 3); // con signo
                const glm::dvec2 normal = glm::dvec2(-d.y, d.x) / glm::length(d);
                puas.insert(puas.end(), {en(Q), en(Q - double(LARGO_PUAS) * curvatura * normal)});
            }
        }
        compruebaCurvas(v.encima, AZUL, en, azules);
        compruebaCurvas(v.encima, ROJO, en, rojos);
        Puntos hay, poligono(P);
        poligono.resize(c.tramos == P.size() ? P.size() + 1 : P.size(), P[0]); // cerrada, vuelve a P0
        for (glm::dvec2 &punto : poligono)
            punto = en(punto);
        compruebaTrazo(v.encima, poligono, glm::mix(GRIS, BLANCO, 0.4f));
        for (const Pintado &p : v.encima.trazos(VERDE, "segmentos"))
            hay.insert(hay.end(), p.puntos.begin(), p.puntos.end());
        ASSERT_EQ(hay.size(), puas.size());
        for (std::size_t i = 0; i < hay.size(); ++i)
            EXPECT_LE(glm::distance(hay[i], puas[i]), 0.01) << i;
    });
}

// La curva y, debajo, lo que pesa cada punto: su polinomio, ecuación 11.20, con el binomio por logaritmos.
TEST(BezierN, CurvaYPolinomiosDeBernstein) {
    const struct {
        std::string guion;
        std::size_t n;
    } casos[] = {{"", 4},
                 {"tecla 2", 10},
                 {"tecla 3", 40},
                 {"tecla 1; tecla - ×7", 2},
                 {"tecla +; tamano 480 640", 3}};
    paraCada("bezier_n", casos, NORMAL.x, NORMAL.y, [](const auto &c, const Vista &v) {
        const auto panel = [&](int fila) { return hueco(0, 1, fila, 2, v.escena.ancho, v.escena.alto); };
        compruebaFondo(v, {{panel(0), FONDO_CLARO}, {panel(1), FONDO_CLARO}});
        const auto polinomio = [m = double(c.n - 1)](std::size_t i, double u) {
            const double k = double(i),
                         lnC = std::lgamma(m + 1) - std::lgamma(k + 1) - std::lgamma(m - k + 1);
            return std::exp(lnC) * std::pow(u, k) * std::pow(1 - u, m - k);
        };
        const Puntos P = planos(puntosZigzag(c.n));
        const auto curva = [&](double u) {
            glm::dvec2 Q(0);
            for (std::size_t k = 0; k < c.n; ++k)
                Q += polinomio(k, u) * P[k];
            return Q;
        };
        // 0.2 de lo que mide un píxel en el lado más largo del panel, del que una unidad es 0.85
        compruebaCurvas(v.encima.enPanel(panel(0).x, panel(0).y), AZUL,
                        enPanel(panel(0), {1.7, 0.9}, {-0.85, 0}), {curva}, 0.17);
        for (std::size_t k = 0; k < c.n; ++k) {
            const float t = 2 * float(k) / float(c.n - 1);
            compruebaCurvas(v.encima.enPanel(panel(1).x, panel(1).y),
                            t < 1 ? AZUL + t * (NARANJA - AZUL) : NARANJA + (t - 1) * (ROJO - NARANJA),
                            enPanel(panel(1), {1.7, 1.4}, {-0.85, -0.6}),
                            {[&](double u) { return glm::dvec2(u, polinomio(k, u)); }}, 0.17);
        }
    });
}

// Cada unión: los dos tramos y el coche, donde dice el reloj; y los módulos de su velocidad y de su aceleración.
TEST(ContinuidadVista, CadaUnionYSuCoche) {
    const struct {
        std::string guion;
        Continuidad union_;
        int milisegundos;
    } casos[] = {{"tecla 1", C0, 1900},
                 {"tecla 2", G1, 1900},
                 {"tecla 3; tamano 480 640", C1, 1900},
                 {"tecla 4; tamano 640 360", C2, 1900},
                 {"tecla 1; tecla t; espera 112; tamano 480 360", C0, 2012},
                 {"tecla 3; espera 2296", C1, 300}}; // otra vuelta; se dibuja cada 16 ms desde que empieza
    paraCada("continuidad", casos, NORMAL.x, NORMAL.y, [](const auto &c, const Vista &v) {
        const auto celda = [&](int columna, int fila) {
            return hueco(columna, 2, fila, 2, v.escena.ancho, v.escena.alto);
        };
        const auto panel = [&](const Hueco &h) { return v.encima.enPanel(h.x, h.y); };
        const Hueco plano = celda(0, 0), grafica[] = {celda(0, 1), celda(1, 1)};
        compruebaFondo(v, {{plano, FONDO_CLARO},
                           {celda(1, 0), CIELO},
                           {grafica[0], FONDO_CLARO},
                           {grafica[1], FONDO_CLARO}});
        Curva tramo[3][2]; // y sus derivadas
        for (int d = 0; d < 3; ++d)
            for (const bool segundo : {false, true}) {
                const Geometria<float> G = segundo ? segundoTramo(c.union_) : PRIMER_TRAMO;
                tramo[d][segundo] = curvaDe(Base::HERMITE, cuatro({G[0], G[1], G[2], G[3]}), d);
            }
        const double u = c.milisegundos % 4000 / 2000.0, aspecto = double(plano.ancho) / plano.alto,
                     y = std::max(0.7, 1.3 / aspecto);
        const glm::dvec2 Q = tramo[0][u >= 1](u - (u >= 1)), velocidad = tramo[1][u >= 1](u - (u >= 1)),
                         F = glm::normalize(velocidad), m(1 / (y * aspecto), 1 / y);
        const Plano en = enPanel(plano, m, -glm::dvec2(0, 0.22) * m);
        // 0.4/alto de tolerancia, en una vista de dos semialtos: en píxeles
        for (const bool segundo : {false, true})
            compruebaCurvas(panel(plano), segundo ? MORADO : AZUL, en, {tramo[0][segundo]}, 0.2 / y);
        const Pintado flecha = panel(plano).trazos(VERDE, "flecha").at(0),
                      coche = panel(plano).trazos(NARANJA, "poligono").at(0);
        EXPECT_LE(glm::distance(flecha.punto(0), en(Q)), 0.01);
        EXPECT_LE(glm::distance(flecha.punto(1), en(Q + double(VELOCIDAD) * velocidad)), 0.01);
        EXPECT_LE(glm::distance(coche.punto(0), en(Q + 0.10 * F)), 0.01);
        for (const int d : {1, 2}) { // de 48 cuerdas: |Q''| hace un pico donde casi se anula
            const Plano alto =
                enPanel(grafica[d - 1], {0.78, 1.45 / double(d == 1 ? RAPIDEZ_MAXIMA : ACELERACION_MAXIMA)},
                        {-0.86, -0.75});
            compruebaCurvas(panel(grafica[d - 1]), d == 1 ? VERDE : ROJO, alto,
                            {[&](double t) { return glm::dvec2(t, glm::length(tramo[d][0](t))); },
                             [&](double t) { return glm::dvec2(1 + t, glm::length(tramo[d][1](t))); }},
                            0.6);
        }
    });
}

// En cualquier imagen de estos programas, los píxeles son los de su lista sobre su escena; también con los cuatro
// puntos en el mismo sitio.
TEST(Pintado, LaListaSobreLaEscena) {
    std::string juntos;
    for (const glm::ivec2 &p : {glm::ivec2(114, 65), {355, 43}, {427, 277}, {60, 299}})
        juntos += arrastra(p, {240, 179}) + "; ";
    const struct {
        std::string programa, guion;
        glm::ivec2 ventana;
    } casos[] = {{"bezier", "tecla n ×2; especial IZQUIERDA; especial ABAJO ×2; tecla u ×2", ANCHA},
                 {"bezier", juntos, NORMAL},
                 {"bezier_n", "tecla 3", {960, 720}},
                 {"bspline", "tecla c; tecla k", {640, 480}},
                 {"bspline", "tecla c; tecla n ×8; especial ARRIBA ×4", NORMAL},
                 {"continuidad", "espera 0; tecla 4; tecla t; espera 1100", ALTA},
                 {"hermite", "tecla t", ALTA},
                 {"hermite", arrastra({110, 50}, {64, 291}), NORMAL}, // una flecha corta es toda punta
                 {"superficie_bezier", "tecla n ×6; especial ABAJO ×7", NORMAL}};
    for (const auto &c : casos)
        compruebaPintado(c.programa, c.guion, c.ventana);
}

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

} // namespace
