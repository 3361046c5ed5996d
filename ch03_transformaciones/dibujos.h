// Lo que comparten los dibujos del capítulo 3: los ejes rotulados, esferas de líneas, el objeto
// original y la leyenda de una transformación hecha paso a paso. `transformacion` es proyeccion * camara * M, como en
// trazo.h.
#pragma once
#include "colores.h"
#include "pasos.h"
#include "rotulo.h"
#include "transformaciones.h"
#include "trazo.h"
#include <GL/glew.h>
#include <algorithm>
#include <glm/gtc/constants.hpp>

/// Flechas del origen a cada uno de esos largos, y más allá su letra. Se llama después de dibujar los sólidos, que
/// taparían las letras.
inline void trazaEjes(const glm::vec3 &largos, const glm::mat4 &transformacion) {
    const char *const LETRAS[] = {"X", "Y", "Z"};
    const float separacion = 0.12f * std::min({largos.x, largos.y, largos.z});
    for (int eje = 0; eje < 3; ++eje) {
        glm::vec3 punta(0), letra(0);
        punta[eje] = largos[eje];
        letra[eje] = largos[eje] + separacion;
        trazaFlecha(glm::vec3(0), punta, transformacion, COLOR_EJE[eje], 1.5f * GROSOR);
        rotulaPunto(LETRAS[eje], letra, transformacion, COLOR_EJE[eje], Lado::CENTRO);
    }
}

/// La esfera de radio 1: sus tres circunferencias perpendiculares a los ejes.
inline void trazaEsfera(const glm::mat4 &transformacion, const glm::vec3 &color) {
    const float recto = glm::half_pi<float>();
    for (const glm::mat4 &giro : {glm::mat4(1), giroX(recto), giroY(recto)})
        trazaPolilinea(circunferencia(1), transformacion * giro, color, 0.7f * GROSOR, true);
}

/// Las aristas del objeto sin transformar, que se ven, tenues, también a través del transformado.
inline void trazaOriginal(const std::vector<glm::vec3> &aristas, const glm::mat4 &transformacion) {
    glDisable(GL_DEPTH_TEST);
    trazaSegmentos(aristas, transformacion, glm::mix(GRIS, FONDO_CLARO, 0.55f), 0.4f * GROSOR);
    glEnable(GL_DEPTH_TEST);
    trazaSegmentos(aristas, transformacion, GRIS, 0.7f * GROSOR);
}

/// Los pasos, uno por línea, oscuros los aplicados, y al final, en `lugar`, su producto.
inline void rotulaPasos(const std::vector<Paso> &pasos, std::size_t aplicados, glm::vec2 lugar) {
    rotula(producto(pasos, aplicados), lugar, OSCURO, Lado::DERECHA);
    for (std::size_t i = pasos.size(); i-- > 0;) {
        lugar.y += 0.07f;
        rotula(std::to_string(i + 1) + " " + pasos[i].nombre, lugar,
               i < aplicados ? OSCURO : glm::mix(GRIS, OSCURO, 0.3f), Lado::DERECHA);
    }
}
