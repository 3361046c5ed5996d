// Un sólido de un color con su transformación y la luz fija: objeto.vert y objeto.frag, los shaders de casi todos los
// programas de los capítulos 3 y 4.
#pragma once
#include "buferes.h"
#include "shader.h"
#include "transformaciones.h"

inline GLuint creaProgramaObjeto() {
    return creaPrograma("ch03_transformaciones/objeto.vert", "ch03_transformaciones/objeto.frag");
}

/// Dibuja el sólido con ese programa, que está en uso y tiene ya `camara` y `proyeccion`.
inline void dibujaObjeto(GLuint programa, const Buferes &solido, const glm::mat4 &M, const glm::vec3 &color) {
    envia(programa, "M", M);
    envia(programa, "N", matrizNormal(M));
    envia(programa, "colorObjeto", color);
    dibujaMalla(solido);
}
