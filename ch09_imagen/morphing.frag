#version 140

uniform float t;
uniform sampler2D imagenA, imagenB;

in vec2 coordenadaA, coordenadaB;
out vec4 colorFragmento;

void main() {
    colorFragmento = mix(texture(imagenA, coordenadaA), texture(imagenB, coordenadaB), t);
}
