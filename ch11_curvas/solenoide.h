// La hélice del solenoide en segmentos de Hermite, y el tubo que la sigue. Sin OpenGL.
#pragma once
#include "curvas.h"
#include "malla.h"
#include <glm/gtc/constants.hpp>

const float RADIO_SOLENOIDE = 1.25f, LARGO_SOLENOIDE = 5.2f, GRUESO_TUBO = 0.13f;
const int SEGMENTOS_VUELTA = 4, TROZOS_SEGMENTO = 16,
          LADOS_TUBO = 20; // a medio píxel de las suyas en 1080 líneas

/// El segmento que recorre, de la hélice de eje X, el cuarto de vuelta i: los ángulos de i·π/2 a (i + 1)·π/2. Sus
/// tangentes tienen la dirección de las de la hélice y el largo con que también el punto medio cae en ella: 4·tan(π/8)
/// por el radio, y no π/2, que es su derivada y se quedaría un 1.5 % dentro.
inline Geometria<float> segmentoSolenoide(int vueltas, int i) {
    const float paso = glm::two_pi<float>() / SEGMENTOS_VUELTA;
    const float largo = 4 * std::tan(paso / 4), avance = LARGO_SOLENOIDE / float(SEGMENTOS_VUELTA * vueltas);
    const auto punto = [&](int k) {
        const float a = paso * float(k);
        return glm::vec3(avance * float(k) - LARGO_SOLENOIDE / 2, RADIO_SOLENOIDE * std::cos(a),
                         RADIO_SOLENOIDE * std::sin(a));
    };
    const auto tangente = [&](int k) {
        const float a = paso * float(k);
        return largo *
               glm::vec3(avance / paso, -RADIO_SOLENOIDE * std::sin(a), RADIO_SOLENOIDE * std::cos(a));
    };
    return {punto(i), punto(i + 1), tangente(i), tangente(i + 1)};
}

/// Un anillo de vértices alrededor de cada punto de la curva, perpendicular a su tangente, y los triángulos de un
/// segmento de cada dos: los pares o los impares.
inline Malla tuboSolenoide(int vueltas, int resto) {
    Malla malla;
    const int anillos = SEGMENTOS_VUELTA * vueltas * TROZOS_SEGMENTO;
    for (int k = 0; k <= anillos; ++k) {
        const int i = std::min(k / TROZOS_SEGMENTO, SEGMENTOS_VUELTA * vueltas - 1);
        const Geometria<float> G = segmentoSolenoide(vueltas, i);
        const float u = float(k - i * TROZOS_SEGMENTO) / TROZOS_SEGMENTO;
        const glm::vec3 centro = cubica(Base::HERMITE, G, u),
                        tangente = glm::normalize(cubica(Base::HERMITE, G, u, 1));
        // la hélice nunca va a lo largo de su eje, así que el eje X orienta el anillo
        const glm::vec3 lado = glm::normalize(glm::cross(tangente, glm::vec3(1, 0, 0)));
        const glm::vec3 otro = glm::cross(tangente, lado);
        for (int j = 0; j <= LADOS_TUBO; ++j) {
            const float a = glm::two_pi<float>() * float(j) / LADOS_TUBO;
            const glm::vec3 normal = std::cos(a) * lado + std::sin(a) * otro;
            malla.vertices.push_back({centro + GRUESO_TUBO * normal, normal, {0, 0}});
            if (k == anillos || j == LADOS_TUBO || i % 2 != resto)
                continue;
            const unsigned p = k * (LADOS_TUBO + 1) + j;
            const unsigned q = p + LADOS_TUBO + 1;
            malla.indices.insert(malla.indices.end(), {p, p + 1, q + 1, p, q + 1, q});
        }
    }
    return malla;
}
