#version 140
#include "ch09_imagen/filtro.glsl"

uniform bool conSigno;
uniform sampler2D imagenA, imagenB;

in vec2 coordenadaTextura;
out vec4 colorFragmento;

// Ejercicio 9.1. De −1 a 1, la diferencia con signo solo cabe entera si se divide por dos.
void main() {
    vec4 colorA = texture(imagenA, coordenadaTextura);
    vec3 resta = colorA.rgb - texture(imagenB, coordenadaTextura).rgb;
    colorFragmento = vec4(muestraSigno(conSigno ? resta / 2.0 : resta, conSigno), colorA.a);
}
