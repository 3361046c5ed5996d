#version 140
#include "common/luz_fija.glsl"

uniform sampler3D Ruido;

in vec3 coordTextura3D, normal;
out vec4 colorFragmento;

// De la roca oscura a la lava: los valores altos del ruido, incandescentes y sin sombra.
void main() {
    float v = texture(Ruido, coordTextura3D).r;
    float calor = smoothstep(0.40, 0.75, v);
    vec3 roca = vec3(0.26, 0.20, 0.19) * luzFija(normal);
    colorFragmento = vec4(mix(roca, mix(vec3(0.85, 0.15, 0.02), vec3(1.0, 0.85, 0.30), calor), calor), 1.0);
}
