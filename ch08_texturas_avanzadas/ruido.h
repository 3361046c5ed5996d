// Ruido de gradiente (Perlin) en tres dimensiones: ruido.glsl dice qué es, y aquí están las mismas funciones en C++, en
// float o en double. Sin OpenGL.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace detalle_ruido {

/// Del centro de un cubo al de cada una de sus doce aristas: los tres signos y el eje nulo (cada uno sale dos veces).
template<class T>
const auto GRADIENTES = [] {
    std::array<glm::vec<3, T>, 24> g;
    for (unsigned i = 0; i < 24; ++i) {
        g[i] = {i & 1 ? -1 : 1, i & 2 ? -1 : 1, i & 4 ? -1 : 1};
        g[i][int(i / 8)] = 0;
    }
    return g;
}();

/// i módulo n, de 0 a n − 1 aunque i sea negativo; i si no hay periodo.
inline int resto(int i, int n) {
    if (n == 0 || unsigned(i) < unsigned(n)) // sin dividir, que es lo que más tarda
        return i;
    return i >= 0 ? i % n : n - 1 - ~i % n;
}

/// La celda en que está p: dónde, de 0 a 1, y lo que cada eje aporta al hash de sus nodos de un lado y del otro.
template<class T>
struct Celda {
    glm::vec<3, T> f;
    glm::uvec3 lado[2];

    Celda(const glm::vec<3, T> &p, const glm::ivec3 &periodo) {
        const std::uint32_t PRIMO[3] = {0x8da6b343u, 0xd8163841u, 0xcb1ab31fu};
        for (int k = 0; k < 3; ++k) {
            const T x = glm::clamp(p[k], T(-1073741824), T(1073741824));
            int suelo = int(x); // sin std::floor, que en muchos procesadores es una llamada
            suelo -= x < T(suelo);
            f[k] = x - T(suelo);
            const int primero = resto(suelo, periodo[k]);
            lado[0][k] = std::uint32_t(primero) * PRIMO[k];
            lado[1][k] = primero + 1 == periodo[k] ? 0 : lado[0][k] + PRIMO[k];
        }
    }
    /// El gradiente del nodo de esa esquina: cada coordenada, 0 o 1.
    const glm::vec<3, T> &gradiente(int x, int y, int z) const {
        std::uint32_t h = lado[x].x ^ lado[y].y ^ lado[z].z;
        h = (h ^ (h >> 15)) * 0x2c1b3c6du;
        h = (h ^ (h >> 12)) * 0x297a2d39u;
        h ^= h >> 15;
        return GRADIENTES<T>[8 * (((h >> 16) * 3u) >> 16) + (h & 7u)];
    }
};

template<class T>
glm::vec<3, T> quintica(const glm::vec<3, T> &f) {
    return f * f * f * (f * (f * T(6) - T(15)) + T(10));
}

} // namespace detalle_ruido

/// Gradiente (x, y, z) y valor (w) del ruido en p.
template<class T>
glm::vec<4, T> ruidoConGradiente(const glm::vec<3, T> &p, const glm::ivec3 &periodo = glm::ivec3(0)) {
    using vec3 = glm::vec<3, T>;
    const detalle_ruido::Celda<T> celda(p, periodo);
    const vec3 f = celda.f;
    const vec3 u = detalle_ruido::quintica(f), du = T(30) * f * f * (f - T(1)) * (f - T(1));
    glm::vec<4, T> suma(0);
    for (int i = 0; i < 8; ++i) {
        const glm::ivec3 esquina(i & 1, (i >> 1) & 1, i >> 2);
        const vec3 e(esquina);
        const vec3 peso = glm::mix(T(1) - u, u, e), dPeso = (T(2) * e - T(1)) * du;
        const vec3 g = celda.gradiente(esquina.x, esquina.y, esquina.z);
        const T rampa = glm::dot(g, f - e), total = peso.x * peso.y * peso.z;
        const vec3 dTotal = dPeso * vec3(peso.y * peso.z, peso.x * peso.z, peso.x * peso.y);
        suma += glm::vec<4, T>(total * g + rampa * dTotal, total * rampa);
    }
    return suma;
}

/// Solo el valor: las mismas ocho rampas, mezcladas de dos en dos. Sin el gradiente tarda la tercera parte.
template<class T>
T ruido(const glm::vec<3, T> &p, const glm::ivec3 &periodo = glm::ivec3(0)) {
    const detalle_ruido::Celda<T> celda(p, periodo);
    const glm::vec<3, T> f = celda.f;
    const glm::vec<3, T> u = detalle_ruido::quintica(f);
    const auto rampa = [&](int x, int y, int z) {
        return glm::dot(celda.gradiente(x, y, z), f - glm::vec<3, T>(x, y, z));
    };
    const auto enX = [&](int y, int z) { return glm::mix(rampa(0, y, z), rampa(1, y, z), u.x); };
    return glm::mix(glm::mix(enX(0, 0), enX(1, 0), u.y), glm::mix(enX(0, 1), enX(1, 1), u.y), u.z);
}

/// Los nodos de cada octava de una turbulencia se corren: si no, en los enteros todas valdrían 0.
template<class T>
glm::vec<3, T> enOctava(const glm::vec<3, T> &p, int octava) {
    return p * T(1 << octava) + glm::vec<3, T>(T(5.375), T(3.625), T(7.75)) * T(octava);
}

/// Suma de `octavas` ruidos, cada uno del doble de frecuencia y la mitad de amplitud que el anterior.
template<class T>
glm::vec<4, T> turbulenciaConGradiente(const glm::vec<3, T> &p, int octavas,
                                       const glm::ivec3 &periodo = glm::ivec3(0)) {
    glm::vec<4, T> suma(0);
    for (int i = 0; i < octavas; ++i) {
        const glm::vec<4, T> r = ruidoConGradiente(enOctava(p, i), periodo << i);
        suma += glm::vec<4, T>(glm::vec<3, T>(r), r.w / T(1 << i));
    }
    return suma;
}

template<class T>
T turbulencia(const glm::vec<3, T> &p, int octavas, const glm::ivec3 &periodo = glm::ivec3(0)) {
    T suma = 0;
    for (int i = 0; i < octavas; ++i)
        suma += ruido(enOctava(p, i), periodo << i) / T(1 << i);
    return suma;
}
