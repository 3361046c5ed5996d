#version 140

uniform mat4 M, vista;

in vec3 posicion;

void main() {
    gl_Position = vista * M * vec4(posicion, 1.0);
}
