#version 140

uniform float alfa;
uniform sampler2D imagenA, imagenB;

in vec2 coordenadaTextura;
out vec4 colorFragmento;

// Listado 9.2.
void main() {
    vec4 colorA = texture(imagenA, coordenadaTextura), colorB = texture(imagenB, coordenadaTextura);
    colorFragmento = mix(colorA, colorB, alfa);
}
