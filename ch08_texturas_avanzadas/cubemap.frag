#version 140

const vec3 METAL = vec3(0.97, 0.91, 0.80); // lo que refleja de cada color

uniform samplerCube mapa;
uniform bool porVertice;

in vec3 haciaPunto, normal, reflexion;
out vec4 colorFragmento;

void main() {
    vec3 R = porVertice ? reflexion : reflect(haciaPunto, normalize(normal));
    colorFragmento = vec4(METAL * texture(mapa, R).rgb, 1.0);
}
