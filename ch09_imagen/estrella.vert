#version 140

in vec3 posicion; // en coordenadas normalizadas del dispositivo

void main() {
    gl_Position = vec4(posicion, 1.0);
}
