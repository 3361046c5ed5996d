#version 140
#include "ch08_texturas_avanzadas/ruido.glsl"

uniform vec3 p, periodo;
uniform int octavas; // 0, el ruido

out vec4 colorFragmento;

void main() {
    colorFragmento = octavas == 0 ? ruidoConGradiente(p, ivec3(periodo))
                                  : turbulenciaConGradiente(p, octavas, ivec3(periodo));
}
