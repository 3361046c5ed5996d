// Un punto de una curva de Bézier de grado 30, en float.
#include "ch11_curvas/curvas.h"
#include "mide.h"
#include <cstdint>

using namespace mide;

using Puntos = std::vector<glm::vec3>;

static const std::size_t GRADO = 30;

// Coeficientes binomiales con los factoriales de la ecuación 11.20, en el tipo que se pida.
template<class T>
static float combinaciones(std::size_t n, std::size_t k) {
    const auto factorial = [](std::size_t x) {
        T f = 1;
        for (std::size_t i = 2; i <= x; ++i)
            f = T(f * T(i));
        return f;
    };
    const T abajo = T(factorial(k) * factorial(n - k));
    return abajo == 0 ? NAN : float(factorial(n) / abajo);
}

static glm::vec3 conFactoriales(const Puntos &p, float u) {
    const std::size_t n = p.size() - 1;
    glm::vec3 q(0);
    for (std::size_t k = 0; k <= n; ++k)
        q +=
            combinaciones<std::uint32_t>(n, k) * std::pow(u, float(k)) * std::pow(1 - u, float(n - k)) * p[k];
    return q;
}

static glm::vec3 conBernstein(const Puntos &p, float u) {
    const std::vector<float> b = bernstein(p.size() - 1, u);
    glm::vec3 q(0);
    for (std::size_t k = 0; k < p.size(); ++k)
        q += b[k] * p[k];
    return q;
}

// Volk y Schumaker: con C(n, k)·P_k ya hechos, Horner en u/(1 − u) si u ≤ ½ y en su inverso si no.
static glm::vec3 volkSchumaker(const Puntos &cp, float u) {
    const std::size_t n = cp.size() - 1;
    const bool alReves = u > 0.5f;
    const float c = alReves ? u : 1 - u, r = (1 - c) / c;
    glm::vec3 q(0);
    for (std::size_t k = 0; k <= n; ++k)
        q = q * r + cp[alReves ? k : n - k];
    float potencia = 1;
    for (std::size_t k = 0; k < n; ++k)
        potencia *= c;
    return potencia * q;
}

static glm::vec3 horner(const Puntos &a, float u) {
    glm::vec3 q(0);
    for (std::size_t k = a.size(); k-- > 0;)
        q = q * u + a[k];
    return q;
}

static void mideBezierN(Medidor &m) {
    Puntos p, cp, a(GRADO + 1, glm::vec3(0));
    for (std::size_t k = 0; k <= GRADO; ++k) {
        const float t = float(k) / GRADO;
        p.push_back({1920 * t, 540 + 400 * std::sin(9 * t), 300 * std::cos(7 * t)});
        cp.push_back(combinaciones<double>(GRADO, k) * p[k]);
    }
    for (std::size_t j = 0; j <= GRADO; ++j) // a_j = C(n, j)·Σ (−1)^(i+j)·C(j, i)·P_i
        for (std::size_t i = 0; i <= j; ++i)
            a[j] += ((i + j) % 2 ? -1.0f : 1.0f) * combinaciones<double>(GRADO, j) *
                    combinaciones<double>(j, i) * p[i];
    const std::vector<Punto<long double>> exacta(p.begin(), p.end());
    const std::size_t n = m.elige<std::size_t>(33, 257);
    const auto variante = [&](const char *nombre, const char *nota, const auto &Q) {
        double error = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const float u = float(i) / float(n - 1);
            const auto lejos = glm::length(Punto<long double>(Q(u)) - bezier<long double>(exacta, u));
            error = std::isfinite(lejos) ? std::max(error, double(lejos)) : INFINITO;
        }
        m.variante(nombre, nota, error, double(n), [&] {
            for (std::size_t i = 0; i < n; ++i)
                usa(Q(float(i) / float(n - 1)));
        });
    };
    variante("factoriales en int", "13! ya no cabe en 32 bits",
             [&](float u) { return conFactoriales(p, u); });
    variante("potencias con Horner", "los coeficientes llegan a 10¹² y se anulan entre sí",
             [&](float u) { return horner(a, u); });
    variante("Bernstein por recurrencia", "", [&](float u) { return conBernstein(p, u); });
    variante("de Casteljau con sus niveles", "guarda la construcción, para dibujarla",
             [&](float u) { return bezier(p, u); });
    variante("Volk y Schumaker", "lineal en el grado; C(n, k)·P se hacen una vez",
             [&](float u) { return volkSchumaker(cp, u); });
}

static const Apunta
    APUNTA({2, "bezier_n", "Un punto de una curva de Bézier de grado 30", "ns por punto",
            "píxeles, frente a doble extendida", "de Casteljau con sus niveles",
            "bezier_n enseña la construcción, y por eso guarda los niveles. La base de potencias y los "
            "factoriales enteros dan una curva que no es.",
            mideBezierN});
