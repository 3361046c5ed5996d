#version 140

in vec3 posicion; // en coordenadas normalizadas del dispositivo
in vec2 coordTextura;

out vec2 enAtlas;

void main() {
    enAtlas = coordTextura;
    gl_Position = vec4(posicion, 1.0);
}
