// Las redes de control de superficie_bezier: la del principio, de cualquier grado, y la del trozo que se une a otro
// (§11.7). Sin OpenGL.
#pragma once
#include "superficies.h"

/// Con los grados repartidos entre u y v. Los 16 puntos de la figura 11.2 o, con otros grados, puntos de su red.
inline RedBezier<float> redInicial(int grados) {
    static const float ALTURAS[4][4] = {{0.1f, 0.8f, 0.5f, -0.1f},
                                        {0.5f, 1.5f, 0.3f, -0.3f},
                                        {-0.2f, -0.2f, -1.3f, 0.2f},
                                        {-0.5f, 0.2f, 0.3f, 0.7f}};
    RedBezier<float> red = {std::size_t(grados + 1) / 2, std::size_t(grados) / 2, {}};
    for (std::size_t i = 0; i <= red.n; ++i)
        for (std::size_t j = 0; j <= red.m; ++j) {
            const float x = 3 * float(i) / float(red.n), z = 3 * float(j) / float(red.m);
            const int a = std::min(int(x), 2), b = std::min(int(z), 2);
            const auto altura = [&](int fila) {
                return glm::mix(ALTURAS[fila][b], ALTURAS[fila][b + 1], z - float(b));
            };
            red.P.push_back({x - 1.5f, glm::mix(altura(a), altura(a + 1), x - float(a)), 1.5f - z});
        }
    return red;
}

enum class Union { C0, G1, DESIGUAL };
const float PROPORCION_G1 = 0.8f,
            DESIGUALES[] = {0.15f, 2.2f}; // la de las columnas pares y la de las impares

/// El trozo que empieza en el borde u = 1 del otro. Es su reflejo al otro lado, con los puntos del borde en común, y
/// con eso basta para C0. Para lo demás, los puntos de después del borde se alinean con los del borde y los de antes:
/// es G1 si todos guardan la misma proporción. Si no la guardan (DESIGUAL) no lo es, aunque el libro diga que basta.
inline RedBezier<float> trozoUnido(const RedBezier<float> &A, Union tipo) {
    RedBezier<float> B = A;
    for (std::size_t i = 0; i <= A.n; ++i)
        for (std::size_t j = 0; j <= A.m; ++j) {
            const glm::vec3 borde = A.en(A.n, j);
            const glm::vec3 d = A.en(A.n - i, j) - borde;
            const float k = tipo == Union::G1 ? PROPORCION_G1 : DESIGUALES[j % 2];
            const bool reflejo = i != 1 || tipo == Union::C0;
            B.P[i * (A.m + 1) + j] = borde + (reflejo ? glm::vec3(-d.x, d.y, d.z) : -k * d);
        }
    return B;
}
