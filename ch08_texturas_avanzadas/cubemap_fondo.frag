#version 140

uniform samplerCube mapa;

in vec3 hacia;
out vec4 colorFragmento;

void main() {
    colorFragmento = texture(mapa, hacia);
}
