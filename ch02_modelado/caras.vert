#version 140

uniform mat4 camara, proyeccion; // capítulo 4

in vec3 posicion;
out vec3 punto;

void main() {
    punto = posicion;
    gl_Position = proyeccion * camara * vec4(posicion, 1.0);
}
