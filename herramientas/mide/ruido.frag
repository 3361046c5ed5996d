#version 140
#include "ch08_texturas_avanzadas/ruido.glsl"

const float CELDAS = 4.0;

uniform sampler3D ruidoGuardado;
uniform int octavas; // 0: el guardado

in vec2 coordenadaTextura;
out vec4 colorFragmento;

void main() {
    vec3 p = vec3(coordenadaTextura, 0.3);
    float valor = octavas == 0 ? texture(ruidoGuardado, p).r : 0.5 + 0.5 * turbulencia(CELDAS * p, octavas, ivec3(CELDAS));
    colorFragmento = vec4(vec3(valor), 1.0);
}
