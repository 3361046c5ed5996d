#version 140

uniform vec4 color;

out vec4 colorFragmento;

void main() {
    colorFragmento = color;
}
