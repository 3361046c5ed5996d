#version 140

#include "common/luz_fija.glsl"

uniform vec3 colorObjeto;

in vec3 normal;
out vec4 colorFragmento;

void main() {
    colorFragmento = vec4(colorObjeto * luzFija(normal), 1.0);
}
