#version 140

in vec3 posicion;
in vec3 color;
out vec4 nuevoColor;

void main() {
    nuevoColor = vec4(color, 1.0);
    gl_Position = vec4(posicion, 1.0);
}
