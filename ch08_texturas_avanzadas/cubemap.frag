#version 140
#include "ch08_texturas_avanzadas/esferico.glsl"

const vec3 METAL = vec3(0.97, 0.91, 0.80); // lo que refleja de cada color

uniform samplerCube mapa;
uniform sampler2D mapaEsferico;
uniform bool porVertice, conEsferico;

in vec3 haciaPunto, normal, reflexion;
out vec4 colorFragmento;

void main() {
    // L8.1: la dirección reflejada: la del vértice si porVertice; si no, la de este fragmento
    vec3 R = porVertice ? reflexion : reflect(haciaPunto, normalize(normal));
    // de partida: vec3 R = normal;
    // fin de L8.1
    vec3 entorno = conEsferico ? texture(mapaEsferico, enEsfera(R)).rgb : texture(mapa, R).rgb;
    colorFragmento = vec4(METAL * entorno, 1.0);
}
