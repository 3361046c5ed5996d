#version 140
#include "ch08_texturas_avanzadas/ruido.glsl"

uniform vec3 p;
uniform int periodoX, periodoY, periodoZ, octavas;

out vec4 colorFragmento;

void main() {
    ivec3 periodo = ivec3(periodoX, periodoY, periodoZ);
    if (octavas == 0)
        colorFragmento = ruidoConGradiente(p, periodo);
    else
        colorFragmento = turbulenciaConGradiente(p, octavas, periodo);
}
