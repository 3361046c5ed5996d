// La textura de ruido que leen los vértices del listado 12.1 y las partículas de §12.3. Sin OpenGL.
#pragma once
#include "ch08_texturas_avanzadas/ruido.h"
#include "imagen.h"

const int LADO_RUIDO = 64, CELDAS_RUIDO = 4; // por lado; una celda de ruido mide 16 texeles

/// Tres ruidos distintos, uno por canal, de 0 a 255. Su periodo es el de la textura, que repetida no tiene costura.
inline Imagen imagenRuido() {
    Imagen imagen{LADO_RUIDO, LADO_RUIDO, {}};
    for (int y = 0; y < LADO_RUIDO; ++y)
        for (int x = 0; x < LADO_RUIDO; ++x)
            for (int canal = 0; canal < 3; ++canal) {
                const glm::vec2 p = (glm::vec2(x, y) + 0.5f) * (float(CELDAS_RUIDO) / LADO_RUIDO);
                const float valor = ruido(glm::vec3(p, float(canal) + 0.5f), {CELDAS_RUIDO, CELDAS_RUIDO, 0});
                imagen.rgb.push_back(enOchoBits(0.5f + 0.5f * valor));
            }
    return imagen;
}
