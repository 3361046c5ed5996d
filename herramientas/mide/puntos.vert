#version 140

in vec3 posicion;

void main() {
    gl_Position = vec4(0.2 * posicion.x, 0.4 * posicion.y - 0.8, 0.0, 1.0);
}
