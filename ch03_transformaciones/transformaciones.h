// Las matrices del capítulo 3, escritas como las da el libro (ecuaciones 3.2 a 3.10) salvo donde se equivoca
// (docs/erratas.md). Sin OpenGL: las usan los programas y las comprueban las pruebas. Ángulos en radianes;
// glm::mat4 guarda columnas, así que aquí cada línea es una columna.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

/// Traslación, ecuación 3.2 (el libro imprime 0 en la diagonal, donde va 1).
inline glm::mat4 traslacion(const glm::vec3 &t) {
    return {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {t, 1}};
}

/// Escalado, ecuación 3.5.
inline glm::mat4 escalado(const glm::vec3 &s) {
    return {{s.x, 0, 0, 0}, {0, s.y, 0, 0}, {0, 0, s.z, 0}, {0, 0, 0, 1}};
}
inline glm::mat4 escalado(float s) {
    return escalado(glm::vec3(s));
}

/// Giro alrededor de X, ecuación 3.6.
inline glm::mat4 giroX(float phi) {
    const float c = std::cos(phi), s = std::sin(phi);
    return {{1, 0, 0, 0}, {0, c, s, 0}, {0, -s, c, 0}, {0, 0, 0, 1}};
}

/// Giro alrededor de Y, ecuación 3.7.
inline glm::mat4 giroY(float phi) {
    const float c = std::cos(phi), s = std::sin(phi);
    return {{c, 0, -s, 0}, {0, 1, 0, 0}, {s, 0, c, 0}, {0, 0, 0, 1}};
}

/// Giro alrededor de Z, ecuación 3.8.
inline glm::mat4 giroZ(float phi) {
    const float c = std::cos(phi), s = std::sin(phi);
    return {{c, s, 0, 0}, {-s, c, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
}

/// Vector unitario en la dirección de v, o `siNulo` si v es cero. Se divide antes por la mayor componente:
/// el cuadrado de 1e-23 es cero en float y el de 1e20 infinito. En float o en double.
template<typename T>
glm::vec<3, T> unitario(const glm::vec<3, T> &v, const glm::vec<3, T> &siNulo = glm::vec<3, T>(1, 0, 0)) {
    const T mayor = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    return mayor > 0 ? glm::normalize(v / mayor) : siNulo;
}

/// Cambio de base que lleva d (unitario) al eje X, ecuación 3.9. La regla del libro para e: anular la
/// componente menor de d en valor absoluto, intercambiar las otras dos, negar una y normalizar.
inline glm::mat3 cambioDeBase(const glm::vec3 &d) {
    const glm::vec3 a = glm::abs(d);
    int menor = a.y <= a.z ? 1 : 2;
    if (a.x <= a.y && a.x <= a.z)
        menor = 0;
    const int i = (menor + 1) % 3, j = (menor + 2) % 3;
    glm::vec3 e(0);
    e[i] = -d[j];
    e[j] = d[i];
    e = glm::normalize(e);
    const glm::vec3 f = glm::cross(d, e);
    return glm::transpose(glm::mat3(d, e, f)); // d, e y f son las filas
}

/// Giro de phi alrededor de un eje que pasa por el origen, ecuación 3.10: Rᵀ·Rx(phi)·R. El eje no tiene
/// que ser unitario; si es nulo no hay giro. Se calcula como I + Rᵀ·(Rx(phi) − I)·R, que es lo mismo: así lo
/// que sale de un ángulo pequeño no se pierde en el redondeo de RᵀR, que solo es casi I.
inline glm::mat4 giroEje(const glm::vec3 &eje, float phi) {
    if (eje == glm::vec3(0))
        return glm::mat4(1);
    const glm::mat3 R = cambioDeBase(unitario(eje));
    const float s = std::sin(phi), mitad = std::sin(phi / 2);
    const float c1 = -2 * mitad * mitad; // c1 = cos(phi) − 1
    const glm::mat3 giroMenosI({0, 0, 0}, {0, c1, s}, {0, -s, c1});
    return glm::mat4(glm::mat3(1) + glm::transpose(R) * giroMenosI * R);
}

/// Matriz de transformación de la normal (§3.3): la matriz de cofactores (en el libro, la traspuesta de la adjunta),
/// que existe aunque M no tenga inversa. El libro calla que con det(M) < 0 apunta hacia dentro: se multiplica por el
/// signo del determinante. Solo importa su dirección, y se devuelve con la mayor componente igual a 1. En doble
/// precisión, ni el producto de tres componentes float se sale de rango, ni la resta de dos pierde cifras.
inline glm::mat3 matrizNormal(const glm::mat4 &M) {
    const glm::dmat3 m(M);
    const glm::dmat3 cofactores(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    double mayor = 0;
    for (int i = 0; i < 3; ++i)
        mayor = std::max(
            {mayor, std::fabs(cofactores[i].x), std::fabs(cofactores[i].y), std::fabs(cofactores[i].z)});
    if (mayor == 0) // aplastado en una recta o en un punto: ninguna cara tiene normal
        return glm::mat3(0);
    return glm::mat3(cofactores / (glm::dot(m[0], cofactores[0]) < 0 ? -mayor : mayor));
}
