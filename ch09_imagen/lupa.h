// Ver aumentados los píxeles de una escena que está en una textura: la lupa de antialiasing.
#pragma once
#include "imagen_en_ventana.h"
#include "recuadro.h"
#include "shader.h"
#include "trazo.h"

struct Lupa {
    GLuint programa; // de lupa.vert e imagen.frag
    int lado;        // de la textura enlazada, en texeles
};

/// El primero de los píxeles de ese centro, que gira con la escena; de 0 a 1.
inline glm::vec2 primerPixel(const Lupa &lupa, const glm::vec2 &centro, const glm::vec2 &pixeles,
                             double giro) {
    const float lado = float(lupa.lado), c = float(std::cos(giro)), s = float(std::sin(giro));
    return glm::floor((glm::mat2(c, s, -s, c) * (centro - 0.5f) + 0.5f) * lado - pixeles / 2.0f + 0.001f) /
           lado;
}

/// En ese rectángulo, con un marco, los píxeles de la escena que hay a partir de `primero`, de 0 a 1.
inline void dibujaPixeles(const Lupa &lupa, const glm::vec2 &primero, const glm::ivec2 &pixeles,
                          const Recuadro &r, const glm::vec3 &marco) {
    abreRecuadro({r.x - 2, r.y - 2, r.ancho + 4, r.alto + 4});
    ponFondo(marco);
    glClear(GL_COLOR_BUFFER_BIT);
    abreRecuadro(r);
    glUseProgram(lupa.programa);
    envia(lupa.programa, "imagen", 0);
    envia(lupa.programa, "primero", primero);
    envia(lupa.programa, "tramo", glm::vec2(pixeles) / float(lupa.lado));
    dibujaRectangulo();
}

/// Un marco alrededor de esos píxeles, en el panel en que se acaba de dibujar la escena entera.
inline void senalaPixeles(const Lupa &lupa, const glm::vec2 &primero, const glm::ivec2 &pixeles,
                          const glm::vec3 &color) {
    const glm::vec2 a = 2.0f * primero - 1.0f;
    const glm::vec2 b = a + 2.0f * glm::vec2(pixeles) / float(lupa.lado);
    trazaPolilinea({{a, 0}, {b.x, a.y, 0}, {b, 0}, {a.x, b.y, 0}}, glm::mat4(1), color, 3, true);
}
