#version 140

flat in vec3 nuevoColor;
out vec4 colorFragmento;

void main() {
    colorFragmento = vec4(nuevoColor, 1.0);
}
