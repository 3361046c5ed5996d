#version 140

in vec3 nuevoColor;
out vec4 colorFragmento;

void main() {
    // Error a propósito: a un vec4 no se le puede asignar un vec3.
    colorFragmento = nuevoColor;
}
