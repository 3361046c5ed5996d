// Un punto de una curva de Bézier de grado 30, en float.
#include "bezier_exacta.h"
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

template<class T>
static glm::vec3 conFactoriales(const Puntos &p, float u) {
    const std::size_t n = p.size() - 1;
    glm::vec3 q(0);
    for (std::size_t k = 0; k <= n; ++k)
        q += combinaciones<T>(n, k) * std::pow(u, float(k)) * std::pow(1 - u, float(n - k)) * p[k];
    return q;
}

static glm::vec3 conBernstein(const Puntos &p, float u) {
    const std::vector<float> b = bernstein(p.size() - 1, u);
    glm::vec3 q(0);
    for (std::size_t k = 0; k < p.size(); ++k)
        q += b[k] * p[k];
    return q;
}

// De Casteljau sin guardar los niveles.
static glm::vec3 casteljauEnUnVector(Puntos p, float u) {
    for (std::size_t n = p.size() - 1; n > 0; --n)
        for (std::size_t i = 0; i < n; ++i)
            p[i] = (1 - u) * p[i] + u * p[i + 1];
    return p[0];
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

    const std::size_t n = m.elige<std::size_t>(33, 257);
    const auto variante = [&](const char *nombre, const auto &Q, const char *nota = "") {
        double error = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const float u = float(i) / float(n - 1);
            const double e = separacion(Q(u), bezierExacta(p, Cuadruple(u)));
            error = std::isfinite(e) ? std::max(error, e) : INFINITO;
            if (error == INFINITO)
                break;
        }
        m.variante(
            nombre, error, double(n),
            [&] {
                for (std::size_t i = 0; i < n; ++i)
                    usa(Q(float(i) / float(n - 1)));
            },
            nota);
    };
    variante(
        "factoriales en int", [&](float u) { return conFactoriales<std::uint32_t>(p, u); },
        "13! ya no cabe en 32 bits");
    variante(
        "factoriales en float", [&](float u) { return conFactoriales<float>(p, u); },
        "35! ya no cabe en un float");
    variante(
        "potencias con Horner", [&](float u) { return horner(a, u); },
        "los coeficientes llegan a 10¹² y se anulan entre sí");
    variante("Bernstein por recurrencia", [&](float u) { return conBernstein(p, u); });
    variante(
        "de Casteljau con sus niveles", [&](float u) { return bezier(p, u); },
        "guarda la construcción, para dibujarla");
    variante("de Casteljau en un vector", [&](float u) { return casteljauEnUnVector(p, u); });
    variante(
        "Volk y Schumaker", [&](float u) { return volkSchumaker(cp, u); },
        "lineal en el grado; C(n, k)·P se hacen una vez");
}

static const Apunta APUNTA({2, "bezier_n", "Un punto de una curva de Bézier de grado 30", "ns por punto",
                            "píxeles, frente a cuádruple precisión", "de Casteljau con sus niveles",
                            "bezier_n enseña la construcción, y por eso guarda los niveles; sin dibujarla "
                            "bastaría un vector. La base "
                            "de potencias y los factoriales enteros dan una curva que no es.",
                            mideBezierN});
