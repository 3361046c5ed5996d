#version 140

in vec4 nuevoColor;
out vec4 colorFragmento;

void main() {
    colorFragmento = nuevoColor;
}
