#version 140
#include "ch09_imagen/filtro.glsl"

uniform sampler2D imagen, filtro;
uniform samplerCube mapa;
uniform int cual;
uniform vec3 a;

out vec4 colorFragmento;

void main() {
    if (cual == 0) colorFragmento = texelFetch(imagen, ivec2(a.xy), 0);
    else if (cual == 1) colorFragmento = texture(imagen, a.xy);
    else if (cual == 2) colorFragmento = texture(mapa, a);
    else colorFragmento = vec4(convoluciona(imagen, a.xy, filtro), 1.0);
}
