#version 140
#include "ch05_iluminacion/phong.glsl"

uniform vec3 La;
uniform Luz luz;

in vec3 ecPosicion, normal;
in float altura;
out vec4 colorFragmento;

// El color, según la altura: mar, playa, prado, roca y nieve.
void main() {
    vec3 color = mix(vec3(0.16, 0.42, 0.66), vec3(0.88, 0.79, 0.55), smoothstep(0.004, 0.012, altura));
    color = mix(color, vec3(0.34, 0.55, 0.20), smoothstep(0.04, 0.09, altura));
    color = mix(color, vec3(0.47, 0.42, 0.38), smoothstep(0.30, 0.48, altura));
    color = mix(color, vec3(0.97, 0.98, 1.00), smoothstep(0.56, 0.68, altura));
    Material material = Material(0.35 * color, 0.85 * color, vec3(0.06), 15.0);
    colorFragmento = vec4(phong(material, La, luz, ecPosicion, normal), 1.0);
}
