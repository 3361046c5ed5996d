#version 140

uniform mat4 M, camara, proyeccion;
uniform vec2 repeticiones;

in vec3 posicion;
in vec2 coordTextura;
out vec2 coordMaterial, coordPared;

void main() {
    coordPared = coordTextura;
    coordMaterial = repeticiones * coordTextura;
    gl_Position = proyeccion * camara * M * vec4(posicion, 1.0);
}
