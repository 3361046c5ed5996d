#version 140
#include "ch08_texturas_avanzadas/esferico.glsl"

uniform samplerCube mapa;
uniform sampler2D mapaEsferico;
uniform bool conEsferico, desplegado; // desplegado, el esférico: la textura tal cual

in vec3 hacia;
out vec4 colorFragmento;

void main() {
    if (conEsferico)
        colorFragmento = texture(mapaEsferico, desplegado ? 0.5 + 0.5 * hacia.xy : enEsfera(hacia));
    else
        colorFragmento = texture(mapa, hacia);
}
