#version 140

uniform vec3 colorTrazo;

out vec4 colorFragmento;

void main() {
    colorFragmento = vec4(colorTrazo, 1.0);
}
