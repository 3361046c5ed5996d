#version 140

uniform mat4 camara; // proyección por vista

in vec4 posicion; // homogénea: con w = 0, un punto del infinito

void main() {
    gl_Position = camara * posicion;
}
