// Los ejes de coordenadas, con sus nombres y los colores de siempre.
#pragma once
#include "colores.h"
#include "rotulo.h"
#include "trazo.h"

/// Los semiejes positivos, desde el origen, de los largos dados.
inline void trazaEjes(const glm::mat4 &transformacion, const glm::vec3 &largos, float grosor = GROSOR) {
    const char *const nombres[] = {"X", "Y", "Z"};
    for (int eje = 0; eje < 3; ++eje) {
        glm::vec3 fin(0);
        fin[eje] = largos[eje];
        trazaFlecha(glm::vec3(0), fin, transformacion, COLOR_EJE[eje], grosor);
        rotulaPunto(nombres[eje], fin, transformacion, COLOR_EJE[eje],
                    eje == 1 ? Lado::ENCIMA : Lado::DEBAJO);
    }
}
