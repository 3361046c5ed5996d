#version 140
#include "ch05_iluminacion/phong.glsl"

const int LUCES = 3;

uniform Material material;
uniform vec3 La; // luz ambiente
uniform Luz luces[LUCES];

in vec3 ecPosicion, normal;
out vec4 colorFragmento;

// Ecuación 5.7: la luz ambiente se cuenta una vez; las demás se suman.
void main() {
    vec3 color = material.Ka * La;
    for (int i = 0; i < LUCES; ++i)
        color += reflejada(material, luces[i], ecPosicion, normal);
    colorFragmento = vec4(color, 1.0);
}
