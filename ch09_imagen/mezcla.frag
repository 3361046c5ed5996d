#version 140

uniform float alfa;
uniform sampler2D imagenA, imagenB;

in vec2 coordenadaTextura;
out vec4 colorFragmento;

// Listado 9.2.
void main() {
    vec4 colorA = texture(imagenA, coordenadaTextura), colorB = texture(imagenB, coordenadaTextura);
    // L9.2: la mezcla de los dos colores: con alfa = 0, el de A; con 1, el de B
    colorFragmento = mix(colorA, colorB, alfa);
    // de partida: colorFragmento = colorA;
    // fin de L9.2
}
