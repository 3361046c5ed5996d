// Casos difíciles de las curvas (capítulo 11), contra la doble precisión extendida.
#include "ch11_curvas/curvas.h"
#include "cota.h"
#include <limits>

namespace {

/// C(n, k) sin factoriales, que 21! ya no cabe: hasta C(60, 30) es exacto en 64 bits.
Largo combinatorio(int n, int k) {
    Largo c = 1;
    for (int i = 1; i <= k; ++i)
        c = c * (n - k + i) / i;
    return c;
}

/// El mayor error relativo de los n + 1 polinomios, en redondeos de T.
template<typename T>
double errorDeBernstein(int n, double redondeo) {
    return peorDe({0.125, 0.25, 0.5, 0.6875, 0.9375}, [=](double u) { // exactos en float
        const std::vector<T> b = bernstein(n, T(u));
        return peorHasta(n + 1, [&](int k) {
            const Largo exacto = combinatorio(n, k) * std::pow(Largo(u), k) * std::pow(1 - Largo(u), n - k);
            const bool subnormal =
                exacto <= Largo(std::numeric_limits<T>::min()); // no tiene todas las cifras
            return subnormal ? 0 : std::fabs(b[k] / exacto - 1) / redondeo;
        });
    });
}

/// n + 1 puntos cualesquiera, entre −4 y 4, exactos en float.
std::vector<Punto<float>> puntos(int n) {
    std::vector<Punto<float>> p;
    for (int i = 0; i <= n; ++i)
        p.push_back(glm::vec3(i * 37 % 33 - 16, i * 53 % 33 - 16, i * 29 % 33 - 16) / 4.0f);
    return p;
}
double lejos(const Punto<float> &a, const Punto<float> &b) {
    return glm::distance(glm::dvec3(a), glm::dvec3(b));
}
const Cotas GRADO_N([] {
    // n niveles de 1 − u, un producto y una suma de números positivos: no más de 3 redondeos por nivel, que no se
    // cancelan
    const auto porNivel = [](int n) { return 3 * n; };
    const std::vector<Con<int>> grados = {10, 20, 40, 60};
    acotaCada<int>("BezierN", "bernstein_float_grado_*", grados, porNivel, "u relativos",
                   [](int n) { return errorDeBernstein<float>(n, U_FLOAT); });
    acotaCada<int>("BezierN", "bernstein_doble_grado_*", grados, porNivel, "u relativos",
                   [](int n) { return errorDeBernstein<double>(n, U_DOBLE); });
});

// --- cúbicas ---

const Geometria<float> G = {Punto<float>{-3, 1, 0.5f}, {0.5f, 2.5f, -1}, {2, -2, 1}, {4, 1.5f, 2}};
const Punto<float> CERO(0);

/// Lo que cambia la curva, además de moverse, si se mueven sus puntos.
double corre(Base base, float salto, int derivada) {
    Geometria<float> corrida = G;
    for (std::size_t i = 0; i < puntosDe(base); ++i)
        corrida[i] += Punto<float>(salto);
    const Punto<float> mueve(derivada ? 0 : salto);
    return peorDe({0.0f, 0.25f, 0.5f, 1.0f}, [&](float u) {
        return lejos(cubica(base, corrida, u, derivada), cubica(base, G, u, derivada) + mueve);
    });
}

const Cotas CUBICAS([] {
    const std::vector<Con<Base>> bases = {
        {"hermite", Base::HERMITE}, {"bezier", Base::BEZIER}, {"bspline", Base::BSPLINE}};
    // los cuatro, el mismo punto (o sin tangentes): la curva es ese punto, y no se mueve
    acotaCada<Base>("Cubica", "*_puntos_coincidentes", bases, 4 * 4 * U_FLOAT, "unidades", [](Base base) {
        const Punto<float> P(1.5f, -2.25f, 3), otro = base == Base::HERMITE ? CERO : P;
        const Geometria<float> g = {P, P, otro, otro};
        return peorDe({0.0f, 0.3f, 0.7f, 1.0f}, [&](float u) {
            return mayor(lejos(cubica(base, g, u), P), lejos(cubica(base, g, u, 1), CERO));
        });
    });
    // puntos a 1e8: en float, de 8 en 8. Los puntos se redondean; las derivadas, no, si el salto es exacto: los puntos
    // son múltiplos de 1/4, y con 2²⁰ se suman sin redondear
    acotaCada<Base>("Cubica", "*_puntos_a_1e8", bases, 4 * 8.0 * std::sqrt(3.0), "unidades",
                    [](Base base) { return corre(base, 1e8f, 0); });
    for (const int derivada : {1, 2})
        acotaCada<Base>("Cubica", "*_derivada_" + std::to_string(derivada) + "_de_puntos_a_2a20", bases, 0,
                        "unidades", [=](Base base) { return corre(base, 1048576, derivada); });
    // C2 en los nudos: u = 1 de un tramo y u = 0 del siguiente
    acotaCada<int>("Cubica", "bspline_nudo_derivada_*", {0, 1, 2}, 64 * U_FLOAT, "unidades",
                   [](int derivada) {
                       const std::vector<Punto<float>> P = puntos(9);
                       return peorHasta(int(tramosBSpline(P.size(), false)) - 1, [&](int t) {
                           return lejos(cubica(Base::BSPLINE, geometriaBSpline(P, t), 1.0f, derivada),
                                        cubica(Base::BSPLINE, geometriaBSpline(P, t + 1), 0.0f, derivada));
                       });
                   });
});

} // namespace
