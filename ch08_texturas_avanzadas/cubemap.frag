#version 140

const vec3 METAL = vec3(0.97, 0.91, 0.80); // lo que refleja de cada color

uniform samplerCube mapa;
uniform bool porVertice;

in vec3 haciaPunto, normal, reflexion;
out vec4 colorFragmento;

void main() {
    // L8.1: la dirección reflejada: la del vértice si porVertice; si no, la de este fragmento
    vec3 R = porVertice ? reflexion : reflect(haciaPunto, normalize(normal));
    // de partida: vec3 R = normal;
    // fin de L8.1
    colorFragmento = vec4(METAL * texture(mapa, R).rgb, 1.0);
}
