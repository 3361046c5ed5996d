#version 140

out vec4 colorFragmento;

void main() {
    colorFragmento = vec4(1.0);
}
