#version 140

uniform mat4 M, camara, proyeccion;

in vec3 posicion;
in vec2 coordTextura;
out vec2 nuevaCoordTextura;

void main() {
    nuevaCoordTextura = coordTextura;
    gl_Position = proyeccion * camara * M * vec4(posicion, 1.0);
}
