#version 140

#include "common/luz_fija.glsl"

// El color depende de qué lado de la cara se ve, y eso lo decide el sentido en que giran sus vértices ya en la
// ventana: un escalado de determinante negativo lo invierte.
uniform vec3 colorFuera, colorDentro;

in vec3 normal;
out vec4 colorFragmento;

void main() {
    colorFragmento = vec4((gl_FrontFacing ? colorFuera : colorDentro) * luzFija(normal), 1.0);
}
