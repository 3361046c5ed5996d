#version 140

in vec4 posicion;

void main() {
    gl_Position = posicion;
}
