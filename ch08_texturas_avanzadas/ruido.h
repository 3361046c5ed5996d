// Ruido de gradiente (Perlin) en tres dimensiones: ruido.glsl dice qué es, y aquí están las mismas funciones en C++, en
// float o en double. Sin OpenGL.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>

namespace detalle_ruido {

/// Gradiente del nodo (x, y, z) de la rejilla: del centro de un cubo al de una de sus doce aristas.
template<class T>
glm::vec<3, T> gradiente(const glm::uvec3 &nodo) {
    std::uint32_t h = (nodo.x * 0x8da6b343u) ^ (nodo.y * 0xd8163841u) ^ (nodo.z * 0xcb1ab31fu);
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    h ^= h >> 15;
    glm::vec<3, T> g = T(1) - T(2) * glm::vec<3, T>(h & 1u, (h >> 1) & 1u, (h >> 2) & 1u);
    g[static_cast<int>(((h >> 16) * 3u) >> 16)] = 0;
    return g;
}

/// i módulo n, de 0 a n − 1 aunque i sea negativo; i si no hay periodo.
inline int resto(int i, int n) {
    return n == 0 ? i : i >= 0 ? i % n : n - 1 - ~i % n;
}
inline glm::ivec3 resto(const glm::ivec3 &i, const glm::ivec3 &n) {
    return {resto(i.x, n.x), resto(i.y, n.y), resto(i.z, n.z)};
}

} // namespace detalle_ruido

/// Gradiente (x, y, z) y valor (w) del ruido en p.
template<class T>
glm::vec<4, T> ruidoConGradiente(const glm::vec<3, T> &p, const glm::ivec3 &periodo = glm::ivec3(0)) {
    using vec3 = glm::vec<3, T>;
    const vec3 base = glm::floor(p), f = p - base;
    const glm::ivec3 celda(glm::clamp(base, vec3(T(-1073741824)), vec3(T(1073741824))));
    const glm::ivec3 primero = detalle_ruido::resto(celda, periodo),
                     ultimo = detalle_ruido::resto(celda + 1, periodo);
    const vec3 u = f * f * f * (f * (f * T(6) - T(15)) + T(10)), du = T(30) * f * f * (f - T(1)) * (f - T(1));
    glm::vec<4, T> suma(0);
    for (int i = 0; i < 8; ++i) {
        const glm::ivec3 esquina(i & 1, (i >> 1) & 1, i >> 2);
        const vec3 e(esquina), peso = glm::mix(T(1) - u, u, e), dPeso = (T(2) * e - T(1)) * du;
        const vec3 g = detalle_ruido::gradiente<T>(primero + esquina * (ultimo - primero));
        const T rampa = glm::dot(g, f - e), total = peso.x * peso.y * peso.z;
        const vec3 dTotal = dPeso * vec3(peso.y * peso.z, peso.x * peso.z, peso.x * peso.y);
        suma += glm::vec<4, T>(total * g + rampa * dTotal, total * rampa);
    }
    return suma;
}

template<class T>
T ruido(const glm::vec<3, T> &p, const glm::ivec3 &periodo = glm::ivec3(0)) {
    return ruidoConGradiente(p, periodo).w;
}

/// Suma de `octavas` ruidos, cada uno del doble de frecuencia y la mitad de amplitud que el anterior.
template<class T>
glm::vec<4, T> turbulenciaConGradiente(const glm::vec<3, T> &p, int octavas,
                                       const glm::ivec3 &periodo = glm::ivec3(0)) {
    glm::vec<4, T> suma(0);
    T frecuencia = 1;
    for (int i = 0; i < octavas; ++i, frecuencia *= 2) {
        const glm::vec<3, T> corrido = glm::vec<3, T>(T(5.375), T(3.625), T(7.75)) * T(i);
        const glm::vec<4, T> r = ruidoConGradiente(p * frecuencia + corrido, periodo << i);
        suma += glm::vec<4, T>(glm::vec<3, T>(r), r.w / frecuencia);
    }
    return suma;
}

template<class T>
T turbulencia(const glm::vec<3, T> &p, int octavas, const glm::ivec3 &periodo = glm::ivec3(0)) {
    return turbulenciaConGradiente(p, octavas, periodo).w;
}
