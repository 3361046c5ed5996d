// Casos difíciles de las curvas y superficies (capítulo 11), contra la doble precisión extendida.
#include "caso.h"
#include "ch11_curvas/superficies.h"

namespace {

using Largo = long double; // 64 bits de mantisa

Largo factorial(int n) {
    return n < 2 ? 1 : n * factorial(n - 1);
}
/// C(n, k) sin factoriales: hasta C(60, 30) es exacto en 64 bits.
Largo combinatorio(int n, int k) {
    Largo c = 1;
    for (int i = 1; i <= k; ++i)
        c = c * (n - k + i) / i;
    return c;
}
Largo bernsteinExacto(int n, int k, Largo u) {
    return combinatorio(n, k) * std::pow(u, k) * std::pow(1 - u, n - k);
}

/// El mayor error relativo de los n + 1 polinomios, en redondeos de T.
template<typename T>
double errorDeBernstein(int n, double redondeo) {
    double peor = 0;
    for (const double u : {0.125, 0.25, 0.5, 0.6875, 0.9375}) { // exactos en float
        const std::vector<T> b = bernstein(static_cast<std::size_t>(n), static_cast<T>(u));
        for (int k = 0; k <= n; ++k) {
            const Largo exacto = bernsteinExacto(n, k, u);
            if (exacto > Largo(std::numeric_limits<T>::min())) // los subnormales no tienen todas las cifras
                peor =
                    mayor(std::fabs(static_cast<double>(Largo(b[static_cast<std::size_t>(k)]) / exacto - 1)) /
                              redondeo,
                          peor);
        }
    }
    return peor;
}

/// n + 1 puntos cualesquiera, entre −4 y 4, exactos en float.
template<typename T>
std::vector<Punto<T>> puntos(int n) {
    std::vector<Punto<T>> p;
    for (int i = 0; i <= n; ++i)
        p.push_back({T(i * 37 % 33 - 16) / 4, T(i * 53 % 33 - 16) / 4, T(i * 29 % 33 - 16) / 4});
    return p;
}
template<typename T>
double lejos(const Punto<T> &a, const Punto<T> &b) {
    return static_cast<double>(glm::length(glm::vec<3, Largo>(a) - glm::vec<3, Largo>(b)));
}
/// La curva de grado n en u, contra la suma de la ecuación 11.22 en precisión extendida.
double errorDeCasteljau(int n) {
    double peor = 0;
    for (const double u : {0.125, 0.5, 0.9375}) {
        const std::vector<Punto<float>> P = puntos<float>(n);
        Punto<Largo> exacto(0);
        for (int k = 0; k <= n; ++k)
            exacto += bernsteinExacto(n, k, u) * Punto<Largo>(P[static_cast<std::size_t>(k)]);
        peor = mayor(lejos<Largo>(Punto<Largo>(bezier(P, static_cast<float>(u))), exacto), peor);
    }
    return peor;
}

const Casos GRADO_N([] {
    for (const int n : {10, 20, 40, 60}) {
        const std::string grado = "grado_" + std::to_string(n);
        // n niveles de 1 − u, un producto y una suma de números positivos: no más de 3 redondeos por nivel, que no se cancelan
        caso("BezierN", "bernstein_float_" + grado, 3 * n, "u relativos",
             [=] { return errorDeBernstein<float>(n, U_FLOAT); });
        caso("BezierN", "bernstein_doble_" + grado, 3 * n, "u relativos",
             [=] { return errorDeBernstein<double>(n, U_DOBLE); });
        caso("BezierN", "suma_1_" + grado, 3 * n, "u", [=] {
            double peor = 0;
            for (const float u : {0.0f, 0.1f, 0.3f, 0.7f, 0.99f, 1.0f}) {
                Largo suma = 0;
                for (const float b : bernstein(static_cast<std::size_t>(n), u))
                    suma += Largo(b);
                peor = mayor(std::fabs(static_cast<double>(suma - 1)) / U_FLOAT, peor);
            }
            return peor;
        });
        caso("BezierN", "casteljau_float_" + grado, 7 * 3 * n * U_FLOAT, "unidades",
             [=] { return errorDeCasteljau(n); });
        caso("BezierN", "extremos_exactos_" + grado, 0, "unidades", [=] {
            const std::vector<Punto<float>> P = puntos<float>(n);
            return mayor(lejos(bezier(P, 0.0f), P.front()), lejos(bezier(P, 1.0f), P.back()));
        });
        caso("BezierN", "extremos_de_bernstein_" + grado, 0, "diferencia", [=] {
            const std::vector<double> a = bernstein(static_cast<std::size_t>(n), 0.0),
                                      b = bernstein(static_cast<std::size_t>(n), 1.0);
            double resto = 0;
            for (std::size_t k = 0; k < a.size(); ++k)
                resto += std::fabs(a[k] - (k == 0)) + std::fabs(b[k] - (k + 1 == b.size()));
            return resto;
        });
    }
    // por qué bernstein no usa factoriales: dónde deja de caber cada uno
    const struct {
        const char *nombre;
        Largo cabe, valor;
    } desbordes[] = {{"factorial_13_en_int32", 2147483647.0L, factorial(13)},
                     {"factorial_21_en_int64", 9223372036854775807.0L, factorial(21)},
                     {"factorial_35_en_float", 3.4028235e38L, factorial(35)},
                     {"combinatorio_67_33_en_int64", 9223372036854775807.0L, combinatorio(67, 33)}};
    for (const auto &d : desbordes)
        caso("BezierN", std::string("no_cabe_") + d.nombre, 1, "lo mayor / valor",
             [=] { return static_cast<double>(d.cabe / d.valor); });
});

// --- cúbicas ---

const Geometria<float> G = {Punto<float>{-3, 1, 0.5f}, {0.5f, 2.5f, -1}, {2, -2, 1}, {4, 1.5f, 2}};
const std::pair<const char *, Base> BASES[] = {
    {"hermite", Base::HERMITE}, {"bezier", Base::BEZIER}, {"bspline", Base::BSPLINE}};

double corre(const Geometria<float> &geometria, Base base, float salto, int derivada) {
    Geometria<float> corrida = geometria;
    for (std::size_t i = 0; i < puntosDe(base); ++i)
        corrida[i] += Punto<float>(salto);
    double peor = 0;
    for (const float u : {0.0f, 0.25f, 0.5f, 1.0f}) {
        const Punto<float> mueve = derivada ? Punto<float>(0) : Punto<float>(salto);
        peor = mayor(lejos(cubica(base, corrida, u, derivada), cubica(base, geometria, u, derivada) + mueve),
                     peor);
    }
    return peor;
}

const Casos CUBICAS([] {
    for (const auto &[nombre, base] : BASES) {
        const std::string n = nombre;
        caso("Cubica", n + "_en_u_0", base == Base::BSPLINE ? 8 * U_FLOAT : 0, "unidades", [=, base = base] {
            const Punto<float> esperado = base == Base::BSPLINE ? (G[0] + 4.0f * G[1] + G[2]) / 6.0f : G[0];
            return lejos(cubica(base, G, 0.0f), esperado);
        });
        caso("Cubica", n + "_en_u_1", base == Base::BSPLINE ? 8 * U_FLOAT : 0, "unidades", [=, base = base] {
            const Punto<float> esperado = base == Base::HERMITE  ? G[1]
                                          : base == Base::BEZIER ? G[3]
                                                                 : (G[1] + 4.0f * G[2] + G[3]) / 6.0f;
            return lejos(cubica(base, G, 1.0f), esperado);
        });
        // los cuatro, el mismo punto (o sin tangentes): la curva es ese punto, y no se mueve
        caso("Cubica", n + "_puntos_coincidentes", 4 * 4 * U_FLOAT, "unidades", [=, base = base] {
            const Punto<float> P(1.5f, -2.25f, 3), cero(0);
            const Geometria<float> g =
                base == Base::HERMITE ? Geometria<float>{P, P, cero, cero} : Geometria<float>{P, P, P, P};
            double peor = 0;
            for (const float u : {0.0f, 0.3f, 0.7f, 1.0f})
                peor = mayor(mayor(lejos(cubica(base, g, u), P), lejos(cubica(base, g, u, 1), cero)), peor);
            return peor;
        });
        // puntos a 1e8: en float, de 8 en 8. Los puntos se redondean; las derivadas, no, si el salto es exacto (2²⁷)
        caso("Cubica", n + "_puntos_a_1e8", 4 * 8.0 * std::sqrt(3.0), "unidades",
             [=, base = base] { return corre(G, base, 1e8f, 0); });
        for (const int derivada : {1, 2})
            caso("Cubica", n + "_derivada_" + std::to_string(derivada) + "_de_puntos_a_2a20", 0, "unidades",
                 [=, base = base] {
                     return corre(G, base, 1048576,
                                  derivada); // los puntos son múltiplos de 1/4: se suman exactos
                 });
    }
    caso("Cubica", "hermite_tangentes_nulas", 0, "velocidad en los extremos", [] {
        const Geometria<float> g = {G[0], G[1], Punto<float>(0), Punto<float>(0)};
        return mayor(lejos(cubica(Base::HERMITE, g, 0.0f, 1), Punto<float>(0)),
                     lejos(cubica(Base::HERMITE, g, 1.0f, 1), Punto<float>(0)));
    });
    caso("Cubica", "curvatura_donde_se_para", 0, "curvatura", [] {
        const Geometria<float> g = {G[0], G[1], Punto<float>(0), Punto<float>(0)};
        return lejos(curvatura(cubica(Base::HERMITE, g, 0.0f, 1), cubica(Base::HERMITE, g, 0.0f, 2)),
                     Punto<float>(0));
    });
    for (int derivada = 0; derivada <= 2;
         ++derivada) // C2 en los nudos: u = 1 de un tramo y u = 0 del siguiente
        caso("Cubica", "bspline_nudo_derivada_" + std::to_string(derivada), 64 * U_FLOAT, "unidades", [=] {
            const std::vector<Punto<float>> P = puntos<float>(9);
            double peor = 0;
            for (std::size_t t = 0; t + 1 < tramosBSpline(P.size(), false); ++t)
                peor = mayor(lejos(cubica(Base::BSPLINE, geometriaBSpline(P, t), 1.0f, derivada),
                                   cubica(Base::BSPLINE, geometriaBSpline(P, t + 1), 0.0f, derivada)),
                             peor);
            return peor;
        });
});

// --- superficies ---

/// Un trozo de Bézier ondulado.
Geometria2<float> trozo() {
    Geometria2<float> g;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            g[i][j] = {static_cast<float>(i), static_cast<float>(j), static_cast<float>(i * j % 3)};
    return g;
}
/// Lo que a la normal le falta para ser unitaria, en todo el trozo.
double normalTorcida(const Geometria2<float> &g) {
    double peor = 0;
    for (int i = 0; i <= 16; ++i)
        for (int j = 0; j <= 16; ++j) {
            const Punto<float> n =
                normalSuperficie(Base::BEZIER, g, static_cast<float>(i) / 16, static_cast<float>(j) / 16);
            peor = mayor(std::fabs(glm::length(glm::dvec3(n)) - 1), peor);
        }
    return peor;
}

const Casos SUPERFICIES([] {
    caso("Superficie", "normal_de_un_trozo", 8 * U_FLOAT, "|n| − 1", [] { return normalTorcida(trozo()); });
    for (int lado = 0; lado < 4; ++lado) // u = 0, u = 1, v = 0, v = 1
        caso("Superficie", "borde_colapsado_" + std::to_string(lado), 8 * U_FLOAT, "|n| − 1", [=] {
            Geometria2<float> g = trozo();
            for (std::size_t k = 0; k < 4; ++k) {
                Punto<float> &p = lado == 0 ? g[0][k] : lado == 1 ? g[3][k] : lado == 2 ? g[k][0] : g[k][3];
                p = {1.5f, 1.5f, 2};
            }
            return normalTorcida(g);
        });
    caso("Superficie", "un_solo_punto", 8 * U_FLOAT, "|n| − 1", [] {
        Geometria2<float> g;
        for (Geometria<float> &fila : g)
            fila.fill(Punto<float>(1, 2, 3));
        return normalTorcida(g);
    });
    caso("Superficie", "una_recta", 8 * U_FLOAT, "|n| − 1", [] {
        Geometria2<float> g;
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j)
                g[i][j] = Punto<float>(static_cast<float>(i + j));
        return normalTorcida(g);
    });
    for (const float talla : {1e-15f, 1e15f})
        caso("Superficie", "de_talla_" + enNombre(static_cast<double>(talla)), 8 * U_FLOAT, "|n| − 1", [=] {
            Geometria2<float> g = trozo();
            for (Geometria<float> &fila : g)
                for (Punto<float> &p : fila)
                    p *= talla;
            return normalTorcida(g);
        });
    caso("Superficie", "corrida_2a20_normal", 0, "diferencia", [] {
        Geometria2<float> g = trozo(), corrida = g;
        for (Geometria<float> &fila : corrida)
            for (Punto<float> &p : fila)
                p += Punto<float>(1048576);
        double peor = 0;
        for (const float u : {0.0f, 0.25f, 0.5f, 1.0f})
            peor = mayor(lejos(normalSuperficie(Base::BEZIER, corrida, u, 0.75f),
                               normalSuperficie(Base::BEZIER, g, u, 0.75f)),
                         peor);
        return peor;
    });
});

} // namespace
