#version 140
#include "ch05_iluminacion/phong.glsl"

uniform Material material;
uniform vec3 La; // luz ambiente
uniform Luz luz;

in vec3 ecPosicion, normal;
out vec4 colorFragmento;

void main() {
    // L5.3: el color del fragmento: phong, con lo que llega interpolado
    colorFragmento = vec4(phong(material, La, luz, ecPosicion, normal), 1.0);
    // de partida: colorFragmento = vec4(material.Ka * La, 1.0);
    // fin de L5.3
}
