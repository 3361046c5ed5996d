// El ruido de ruido.glsl según su definición, en doble y sin compartir nada con ruido.h: mezclas lineales encadenadas.
#pragma once
#include "prueba.h"

namespace definicion {

inline double quintica(double t) {
    return t * t * t * (6 * t * t - 15 * t + 10);
}
inline long long modulo(long long i, long long n) {
    return n ? ((i % n) + n) % n : i;
}
inline double rampa(const long long nodo[3], const double d[3], const glm::ivec3 &periodo) {
    std::uint64_t h = 0;
    const std::uint64_t primos[3] = {0x8da6b343, 0xd8163841, 0xcb1ab31f}, M = 0xffffffff;
    for (int k = 0; k < 3; ++k)
        h ^= (std::uint64_t(modulo(nodo[k], periodo[k])) & M) * primos[k] & M;
    h = (h ^ h >> 15) * 0x2c1b3c6d & M;
    h = (h ^ h >> 12) * 0x297a2d39 & M;
    h = h ^ h >> 15;
    const auto sinEje = (h >> 16) * 3 / 65536;
    double suma = 0;
    for (std::uint64_t k = 0; k < 3; ++k)
        if (k != sinEje)
            suma += (h >> k & 1 ? -1 : 1) * d[k];
    return suma;
}
inline double ruido(const glm::dvec3 &p, const glm::ivec3 &periodo = glm::ivec3(0)) {
    const glm::dvec3 base = glm::floor(p), f = p - base;
    const auto enNodo = [&](int x, int y, int z) {
        const long long nodo[3] = {(long long)(base.x) + x, (long long)(base.y) + y, (long long)(base.z) + z};
        const double d[3] = {f.x - x, f.y - y, f.z - z};
        return rampa(nodo, d, periodo);
    };
    const auto mezcla = [](double a, double b, double t) { return a + (b - a) * quintica(t); };
    const auto enZ = [&](int x, int y) { return mezcla(enNodo(x, y, 0), enNodo(x, y, 1), f.z); };
    return mezcla(mezcla(enZ(0, 0), enZ(0, 1), f.y), mezcla(enZ(1, 0), enZ(1, 1), f.y), f.x);
}
inline double turbulencia(const glm::dvec3 &p, int octavas, const glm::ivec3 &periodo = glm::ivec3(0)) {
    double suma = 0;
    for (int i = 0; i < octavas; ++i) {
        const int f = 1 << i;
        suma += ruido(p * double(f) + double(i) * glm::dvec3(5.375, 3.625, 7.75), periodo * f) / f;
    }
    return suma;
}

/// La textura de textura3d: 64³ bytes, con turbulencia de tres octavas en 4×4×4 celdas.
inline std::vector<unsigned char> textura3d() {
    std::vector<unsigned char> texels;
    for (int i = 0; i < 64 * 64 * 64; ++i) {
        const glm::dvec3 texel(i % 64 + 0.5, i / 64 % 64 + 0.5, i / 4096 + 0.5);
        const double valor = 0.5 + 0.5 * turbulencia(texel / 16.0, 3, glm::ivec3(4));
        texels.push_back(static_cast<unsigned char>(std::lround(255 * std::clamp(valor, 0.0, 1.0))));
    }
    return texels;
}
/// Una textura de n³ bytes leída como GL_LINEAR y GL_REPEAT; (x, y, z), de 0 a 1 una vez la textura. De 0 a 1.
template<class Punto>
double trilineal(const std::vector<unsigned char> &texels, const Punto &p) {
    const long long n = std::llround(std::cbrt(texels.size()));
    double suma = 0;
    for (int i = 0; i < 8; ++i) {
        double peso = 1;
        long long indice = 0;
        for (int k = 2; k >= 0; --k) {
            const double u = double(n) * p[k] - 0.5, suelo = std::floor(u), f = u - suelo;
            const int e = i >> k & 1;
            peso *= e ? f : 1 - f;
            indice = n * indice + modulo((long long)(suelo) + e, n);
        }
        suma += peso * texels[std::size_t(indice)] / 255;
    }
    return suma;
}

} // namespace definicion
