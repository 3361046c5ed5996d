#version 140
#include "ch05_iluminacion/phong.glsl"

uniform Material material;
uniform vec3 La, P, N;
uniform Luz luz;

out vec4 colorFragmento;

void main() {
    colorFragmento = vec4(phong(material, La, luz, P, N), 1.0);
}
