#version 140
#include "ch09_imagen/filtro.glsl"

uniform sampler2D imagen, filtro;
uniform bool sumaCero, conSigno; // en la última pasada de un filtro que suma 0

in vec2 coordenadaTextura;
out vec4 colorFragmento;

void main() {
    // E9.2: la suma de todos los texeles que abarca el filtro, que es una textura de números
    vec3 suma = convoluciona(imagen, coordenadaTextura, filtro);
    // de partida: vec3 suma = texture(imagen, coordenadaTextura).rgb;
    // fin de E9.2
    if (sumaCero)
        suma = muestraSigno(suma, conSigno);
    colorFragmento = vec4(suma, texture(imagen, coordenadaTextura).a);
}
