#version 140

uniform mat4 camaraModelo, proyeccion;

in vec3 posicion;

void main() {
    gl_Position = proyeccion * (camaraModelo * vec4(posicion, 1.0));
}
