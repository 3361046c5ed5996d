#version 140

in vec3 posicion;
in vec3 color;
out vec3 nuevoColor;

void main() {
    nuevoColor = color;
    gl_Position = vec4(posicion, 1.0);
}
