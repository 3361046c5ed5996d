#version 140
#include "ch09_imagen/filtro.glsl"

uniform bool conSigno;
uniform sampler2D imagenA, imagenB;

in vec2 coordenadaTextura;
out vec4 colorFragmento;

void main() {
    vec4 colorA = texture(imagenA, coordenadaTextura);
    // E9.1: |A − B| o, con signo, (A − B)/2 como la enseña muestraSigno; la opacidad, la de A
    vec3 resta = colorA.rgb - texture(imagenB, coordenadaTextura).rgb;
    // de −1 a 1, con signo solo cabe entera si se divide por dos
    colorFragmento = vec4(muestraSigno(conSigno ? resta / 2.0 : resta, conSigno), colorA.a);
    // de partida: colorFragmento = colorA;
    // fin de E9.1
}
