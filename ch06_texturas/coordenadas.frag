#version 140
#include "common/luz_fija.glsl"

uniform sampler2D Img;

in vec3 normal; // en coordenadas del mundo
in vec2 nuevaCoordTextura;
out vec4 colorFragmento;

void main() {
    colorFragmento = vec4(texture(Img, nuevaCoordTextura).rgb * luzFija(normal), 1.0);
}
