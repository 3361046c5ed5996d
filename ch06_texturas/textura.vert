#version 140

uniform mat4 matriz; // proyección · vista · modelo

in vec3 posicion;
in vec2 coordTextura;
out vec2 nuevaCoordTextura;

void main() {
    nuevaCoordTextura = coordTextura;
    gl_Position = matriz * vec4(posicion, 1.0);
}
