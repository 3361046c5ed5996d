// Lo que se traza del volumen de la vista en volumen_vista: aristas, planos y parámetros, cada uno en el lado o el
// plano que decide (figuras 4.3 y 4.4).
#pragma once
#include "rotulo.h"
#include "texto.h"
#include "trazo.h"
#include "volumen.h"
#include <string>
#include <vector>

const glm::dvec3 OJO_VOLUMEN(0, 2.5, 6.5); // de la cámara del volumen

inline std::string conValor(const char *nombre, double valor) {
    return formatea("%s %.3g", nombre, valor);
}

inline std::string describeVolumen(const Volumen &v) {
    return conValor("cerca", v.cerca) + conValor(", lejos", v.lejos) +
           (v.enPerspectiva ? formatea(", θ %.0f°", glm::degrees(v.theta))
                            : conValor(", alto", 2 * v.semialto())) +
           conValor(", ancho/alto", v.aspecto);
}

/// θ, del plano de abajo al de arriba, junto al ojo.
inline void trazaTheta(double theta, const glm::mat4 &aRecortado) {
    const double RADIO = 1.4;
    std::vector<glm::vec3> arco;
    for (int i = 0; i <= 12; ++i) {
        const double angulo = theta * (i / 12.0 - 0.5);
        arco.push_back(OJO_VOLUMEN + RADIO * glm::dvec3(0, std::sin(angulo), -std::cos(angulo)));
    }
    trazaSegmentos({arco.front(), glm::vec3(OJO_VOLUMEN), glm::vec3(OJO_VOLUMEN), arco.back()}, aRecortado,
                   OSCURO, 3);
    trazaPolilinea(arco, aRecortado, OSCURO, 6);
    rotulaPunto("θ", arco.front(), aRecortado, OSCURO, Lado::DEBAJO);
}

/// `e`: las esquinas, en coordenadas del mundo.
inline void trazaVolumen(const Volumen &v, const std::array<glm::vec3, 8> &e, const glm::mat4 &aRecortado) {
    const auto base = e.begin();
    for (int k = 0; k < 4; ++k) {
        trazaSegmentos({e[k], e[k + 4]}, aRecortado, OSCURO, 5);
        if (v.enPerspectiva)
            trazaSegmentos({glm::vec3(OJO_VOLUMEN), e[k]}, aRecortado, GRIS, 3);
    }
    trazaPolilinea({base, base + 4}, aRecortado, NARANJA, 8, true);
    trazaPolilinea({base + 4, base + 8}, aRecortado, AZUL, 8, true);
    // Fuera del volumen: el rótulo va junto al medio de dos esquinas, o a una, algo más arriba o más abajo.
    const auto rotulaLado = [&](const std::string &texto, std::size_t a, std::size_t b, float sube, Lado lado,
                                const glm::vec3 &color) {
        rotulaPunto(texto, 0.5f * (e[a] + e[b]) + glm::vec3(0, sube, 0), aRecortado, color, lado, 0.033f);
    };
    rotulaLado(conValor("cerca", v.cerca), 3, 3, 0, Lado::IZQUIERDA, NARANJA);
    rotulaLado(conValor("lejos", v.lejos), 7, 7, 0, Lado::ENCIMA, AZUL);
    if (v.enPerspectiva) {
        trazaTheta(v.theta, aRecortado);
        rotulaLado("ancho", 6, 7, 0.3f, Lado::DERECHA, OSCURO);
        rotulaLado("alto", 5, 6, 0, Lado::DERECHA, OSCURO);
    } else {
        rotulaLado("izquierda", 0, 3, 0, Lado::IZQUIERDA, OSCURO);
        rotulaLado("derecha", 5, 6, 0, Lado::DERECHA, OSCURO);
        rotulaLado("abajo", 0, 1, -0.3f, Lado::IZQUIERDA, OSCURO);
        rotulaLado("arriba", 3, 7, 0.3f, Lado::IZQUIERDA, OSCURO);
    }
}
