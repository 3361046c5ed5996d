#version 140

in vec3 posicion;     // donde la malla lleva el punto
in vec2 coordTextura; // donde estaba en la imagen

out vec2 coordenadaTextura;

void main() {
    coordenadaTextura = coordTextura;
    gl_Position = vec4(2.0 * posicion.xy - 1.0, 0.0, 1.0);
}
