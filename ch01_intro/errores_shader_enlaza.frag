#version 140

// Error a propósito: compila, pero el vertex shader da esta variable como vec3.
in vec4 nuevoColor;
out vec4 colorFragmento;

void main() {
    colorFragmento = nuevoColor;
}
