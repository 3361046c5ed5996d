#version 140
#include "ch09_imagen/filtro.glsl"

uniform sampler2D imagen, filtro;
uniform bool sumaCero, conSigno; // en la última pasada de un filtro que suma 0

in vec2 coordenadaTextura;
out vec4 colorFragmento;

void main() {
    vec3 suma = convoluciona(imagen, coordenadaTextura, filtro);
    if (sumaCero)
        suma = muestraSigno(suma, conSigno);
    colorFragmento = vec4(suma, texture(imagen, coordenadaTextura).a);
}
