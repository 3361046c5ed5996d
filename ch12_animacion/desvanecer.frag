#version 140
#include "common/luz_fija.glsl"

uniform vec3 colorObjeto;
uniform float alfa; // opacidad: 0, no se ve; 1, tapa lo que tiene detrás

in vec3 normal;
out vec4 colorFragmento;

void main() {
    colorFragmento = vec4(colorObjeto * luzFija(normal), alfa);
}
