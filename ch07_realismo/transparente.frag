#version 140
#include "ch05_iluminacion/phong.glsl"

uniform Material material;
uniform vec3 La;
uniform Luz luz;
uniform float alfaMaterial; // opacidad: 1, opaco; 0, no se ve

in vec3 ecPosicion, normal;
out vec4 colorFragmento;

void main() {
    vec3 N = gl_FrontFacing ? normal : -normal; // por dentro también se ve
    colorFragmento = vec4(phong(material, La, luz, ecPosicion, N), alfaMaterial);
}
