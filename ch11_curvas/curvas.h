// Curvas cúbicas de Hermite, Bézier y B-Spline y curvas de Bézier de cualquier grado (capítulo 11): puntos, derivadas y
// segmentos que hacen falta. Para cualquier tipo real: float, double o de cuádruple precisión. Sin OpenGL.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

enum class Base { HERMITE, BEZIER, BSPLINE };

template<typename T>
using Punto = glm::vec<3, T>;
template<typename T>
using Pesos = std::array<T, 4>;
/// El vector de geometría: P1, P4, R1, R4 en Hermite (ecuación 11.5) y cuatro puntos de control en las otras dos.
template<typename T>
using Geometria = std::array<Punto<T>, 4>;

/// Cuántos elementos del vector de geometría son puntos, y no tangentes: sus pesos suman 1, y los de sus derivadas, 0.
inline std::size_t puntosDe(Base base) {
    return base == Base::HERMITE ? 2 : 4;
}

// ---- Las matrices base, como en el libro ----

/// U (ecuación 11.3). Con él, Q(u) = U·M·G (ecuación 11.4) se escribe igual con las matrices que siguen y enFilas(G).
inline glm::vec4 potencias(float u) {
    return {u * u * u, u * u, u, 1};
}
/// El vector de geometría, un elemento en cada fila.
inline glm::mat3x4 enFilas(const std::array<glm::vec3, 4> &G) {
    return glm::transpose(glm::mat4x3(G[0], G[1], G[2], G[3]));
}
/// glm::mat4 se escribe por columnas; transpuesta, se lee como en el libro.
// clang-format off
const glm::mat4 M_H = glm::transpose(glm::mat4( // ecuación 11.10
     2, -2,  1,  1,
    -3,  3, -2, -1,
     0,  0,  1,  0,
     1,  0,  0,  0));
const glm::mat4 M_HB = glm::transpose(glm::mat4( // ecuación 11.14: G_H = M_HB·G_B
     1,  0,  0,  0,
     0,  0,  0,  1,
    -3,  3,  0,  0,
     0,  0, -3,  3));
const glm::mat4 M_B = M_H * M_HB; // ecuación 11.17
const glm::mat4 M_BS = glm::transpose(glm::mat4( // ecuación 11.26
    -1,  3, -3,  1,
     3, -6,  3,  0,
    -3,  0,  3,  0,
     1,  4,  1,  0)) / 6.0f;
// clang-format on

// ---- Curvas cúbicas ----

/// U·M (ecuaciones 11.11, 11.18 y 11.27), factorizado para que no se resten números casi iguales; o su primera o
/// segunda derivada.
template<typename T>
Pesos<T> pesos(Base base, const T &u, int derivada = 0) {
    const T c = T(1) - u, uu = u * u;
    const T cc = c * c;
    switch (base) {
    case Base::HERMITE:
        switch (derivada) {
        case 0: return {cc * (T(1) + T(2) * u), uu * (T(1) + T(2) * c), u * cc, -(uu * c)};
        case 1: return {T(-6) * u * c, T(6) * u * c, c * (c - T(2) * u), u * (u - T(2) * c)};
        default: return {T(6) * (u - c), T(6) * (c - u), T(2) * u - T(4) * c, T(4) * u - T(2) * c};
        }
    case Base::BEZIER:
        switch (derivada) {
        case 0: return {cc * c, T(3) * (cc * u), T(3) * (uu * c), uu * u};
        case 1: return {T(-3) * cc, T(3) * c * (c - T(2) * u), T(3) * u * (T(2) * c - u), T(3) * uu};
        default: return {T(6) * c, T(6) * u - T(12) * c, T(6) * c - T(12) * u, T(6) * u};
        }
    default:
        switch (derivada) {
        case 0:
            return {cc * c / T(6), (T(1) + T(3) * c * (T(1) + u * c)) / T(6),
                    (T(1) + T(3) * u * (T(1) + u * c)) / T(6), uu * u / T(6)};
        case 1: return {-cc / T(2), u * (T(3) * u - T(4)) / T(2), c * (T(4) - T(3) * c) / T(2), uu / T(2)};
        default: return {c, T(3) * u - T(2), T(3) * c - T(2), u};
        }
    }
}

/// Q(u) = UMG (ecuación 11.4) o una derivada suya. Como los pesos de una derivada suman cero, restar antes un punto no
/// la cambia, y un origen lejano no se come sus cifras.
template<typename T>
Punto<T> cubica(Base base, const Geometria<T> &G, const T &u, int derivada = 0) {
    const Pesos<T> w = pesos(base, u, derivada);
    Punto<T> suma(T(0));
    for (std::size_t i = 0; i < 4; ++i)
        suma += w[i] * (derivada > 0 && i < puntosDe(base) ? G[i] - G[0] : G[i]);
    return suma;
}

/// El vector de curvatura, de las dos primeras derivadas: hacia el centro de la circunferencia que más se parece a la
/// curva y de largo 1/radio. Donde la curva se para no hay tal circunferencia, y vale 0.
template<typename T>
Punto<T> curvatura(const Punto<T> &primera, const Punto<T> &segunda) {
    const auto escalar = [](const Punto<T> &a, const Punto<T> &b) {
        return a.x * b.x + a.y * b.y + a.z * b.z; // glm::dot no admite la cuádruple precisión
    };
    const T v2 = escalar(primera, primera);
    return v2 > T(0) ? (segunda - escalar(primera, segunda) / v2 * primera) / v2 : Punto<T>(T(0));
}

/// Los puntos de control de Bézier de la misma curva: la inversa de la ecuación 11.14, y M_B⁻¹·M_BS.
template<typename T>
Geometria<T> aBezier(Base base, const Geometria<T> &G) {
    const T tercio = T(1) / T(3), sexto = T(1) / T(6);
    switch (base) {
    case Base::HERMITE: return {G[0], G[0] + tercio * G[2], G[1] - tercio * G[3], G[1]};
    case Base::BSPLINE:
        return {sexto * (G[0] + T(4) * G[1] + G[2]), tercio * (T(2) * G[1] + G[2]),
                tercio * (G[1] + T(2) * G[2]), sexto * (G[1] + T(4) * G[2] + G[3])};
    default: return G;
    }
}

// ---- Curvas B-Spline de muchos puntos ----

/// Los tramos de una B-Spline de n puntos de control. Cerrarla es repetir los tres primeros.
inline std::size_t tramosBSpline(std::size_t n, bool cerrada) {
    // E11.7: cuántos son, abierta y cerrada
    if (n < 4) // con menos de cuatro puntos no hay ninguno
        return 0;
    return cerrada ? n : n - 3;
    // de partida: return n < 4 || cerrada ? 0 : 1;
    // fin de E11.7
}

/// El vector de geometría (ecuación 11.23) del tramo, contado desde 0.
template<typename T>
Geometria<T> geometriaBSpline(const std::vector<Punto<T>> &puntos, std::size_t tramo) {
    Geometria<T> G;
    for (std::size_t k = 0; k < 4; ++k) {
        // E11.7: el punto de control k de ese tramo; en el último de una cerrada, tras el último punto va el primero
        G[k] = puntos[(tramo + k) % puntos.size()];
        // de partida: G[k] = puntos[tramo];
        // fin de E11.7
    }
    return G;
}

// ---- Curvas de Bézier de cualquier grado ----

/// La construcción de de Casteljau: cada nivel parte en u los lados del anterior; el último es el punto de la curva.
/// Solo promedia, así que no pierde cifras por alto que sea el grado.
template<typename T>
std::vector<std::vector<Punto<T>>> casteljau(const std::vector<Punto<T>> &puntos, const T &u) {
    std::vector<std::vector<Punto<T>>> niveles = {puntos};
    while (niveles.back().size() > 1) {
        const std::vector<Punto<T>> &previo = niveles.back();
        std::vector<Punto<T>> nivel;
        for (std::size_t i = 0; i + 1 < previo.size(); ++i)
            nivel.push_back((T(1) - u) * previo[i] + u * previo[i + 1]);
        niveles.push_back(nivel);
    }
    return niveles;
}

/// Q(u) de la ecuación 11.22, con de Casteljau.
template<typename T>
Punto<T> bezier(const std::vector<Punto<T>> &puntos, const T &u) {
    return casteljau(puntos, u).back()[0];
}

/// Los polinomios de Bernstein b_{0,n} … b_{n,n} (ecuación 11.20) sin factoriales, que a grado 60 no caben en un
/// entero: b_{k,n} = (1 − u)·b_{k,n−1} + u·b_{k−1,n−1}. O una derivada suya: b'_{k,n} = n·(b_{k−1,n−1} − b_{k,n−1}).
template<typename T>
std::vector<T> bernstein(std::size_t n, const T &u, int derivada = 0) {
    if (derivada > 0) {
        std::vector<T> d(n + 1, T(0));
        const std::vector<T> b = n > 0 ? bernstein(n - 1, u, derivada - 1) : std::vector<T>();
        for (std::size_t k = 0; k < b.size(); ++k) {
            d[k] -= T(double(n)) * b[k];
            d[k + 1] += T(double(n)) * b[k];
        }
        return d;
    }
    std::vector<T> b = {T(1)};
    for (std::size_t grado = 1; grado <= n; ++grado) {
        b.push_back(u * b.back());
        for (std::size_t k = grado - 1; k > 0; --k)
            b[k] = (T(1) - u) * b[k] + u * b[k - 1];
        b[0] = (T(1) - u) * b[0];
    }
    return b;
}

// ---- Teselación ----

const int MITADES_MAXIMAS = 12;
const int SEGMENTOS_MAXIMOS = 1 << MITADES_MAXIMAS;

/// Segmentos iguales en u que no se separan de la curva más de `tolerancia`, si su segunda derivada no pasa de `M`: la
/// cuerda de un intervalo h se separa como mucho M·h²/8.
inline int segmentosDerivada(double M, double tolerancia) {
    return int(std::clamp(std::ceil(std::sqrt(M / (8 * tolerancia))), 1.0, double(SEGMENTOS_MAXIMOS)));
}

/// La cota de Wang: la segunda derivada no pasa de n·(n − 1) por la mayor segunda diferencia de los puntos de control.
template<typename T>
int segmentosWang(const std::vector<Punto<T>> &puntos, double tolerancia) {
    const double n = double(puntos.size()) - 1;
    double mayor = 0;
    for (std::size_t i = 0; i + 2 < puntos.size(); ++i)
        mayor = std::max(mayor, glm::length(glm::dvec3(puntos[i] - puntos[i + 1]) -
                                            glm::dvec3(puntos[i + 1] - puntos[i + 2])));
    return segmentosDerivada(n * (n - 1) * mayor, tolerancia);
}

/// Parte la curva por la mitad, y cada mitad, mientras la cota de Wang diga que no basta una cuerda: así hay más
/// segmentos donde más se curva. Los 1190 iguales que pide un zigzag de grado 60 se quedan en 70.
template<typename T>
void parteBezier(const std::vector<Punto<T>> &puntos, double tolerancia, int veces,
                 std::vector<glm::vec3> &linea) {
    if (veces == 0 || segmentosWang(puntos, tolerancia) == 1) {
        linea.push_back(glm::vec3(puntos.back()));
        return;
    }
    std::vector<Punto<T>> primera = {puntos[0]}, segunda = puntos;
    for (std::size_t n = puntos.size() - 1; n > 0; --n) {
        for (std::size_t i = 0; i < n; ++i)
            segunda[i] = T(0.5) * (segunda[i] + segunda[i + 1]);
        primera.push_back(segunda[0]);
    }
    parteBezier(primera, tolerancia, veces - 1, linea);
    parteBezier(segunda, tolerancia, veces - 1, linea);
}

template<typename T>
std::vector<glm::vec3> polilineaBezier(const std::vector<Punto<T>> &puntos, double tolerancia) {
    std::vector<glm::vec3> linea = {glm::vec3(puntos.front())};
    parteBezier(puntos, tolerancia, MITADES_MAXIMAS, linea);
    return linea;
}

/// La misma cota para una cúbica: su segunda derivada es lineal y la mayor está en un extremo.
template<typename T>
int segmentosCubica(Base base, const Geometria<T> &G, double tolerancia) {
    return segmentosDerivada(std::max(glm::length(glm::dvec3(cubica(base, G, T(0), 2))),
                                      glm::length(glm::dvec3(cubica(base, G, T(1), 2)))),
                             tolerancia);
}

/// Los puntos de una curva, Q(u) para u de 0 a 1, en n segmentos.
template<typename Curva>
std::vector<glm::vec3> polilinea(const Curva &Q, int n) {
    std::vector<glm::vec3> puntos;
    for (int i = 0; i <= n; ++i)
        puntos.push_back(Q(float(i) / float(n)));
    return puntos;
}

inline std::vector<glm::vec3> polilineaCubica(Base base, const Geometria<float> &G, double tolerancia) {
    return polilinea([&](float u) { return cubica(base, G, u); }, segmentosCubica(base, G, tolerancia));
}
