#version 140
#include "ch05_iluminacion/phong.glsl"

uniform Material material;
uniform vec3 La; // luz ambiente
uniform Luz luz;

in vec3 ecPosicion, normal;
out vec4 colorFragmento;

void main() {
    colorFragmento = vec4(phong(material, La, luz, ecPosicion, normal), 1.0);
}
