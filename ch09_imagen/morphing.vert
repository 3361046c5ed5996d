#version 140

uniform float t;

in vec3 posicion;     // del punto en la imagen A, de (0, 0) a (1, 1)
in vec2 coordTextura; // del mismo punto en la B

out vec2 coordenadaA, coordenadaB;

void main() {
    coordenadaA = posicion.xy;
    coordenadaB = coordTextura;
    gl_Position = vec4(2.0 * mix(coordenadaA, coordenadaB, t) - 1.0, 0.0, 1.0);
}
