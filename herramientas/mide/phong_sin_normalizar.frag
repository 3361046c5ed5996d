#version 140
#include "ch05_iluminacion/phong.glsl"

uniform Material material;
uniform vec3 La;
uniform Luz luz;

in vec3 ecPosicion, normal;
out vec4 colorFragmento;

// Como phong.glsl, pero con la normal tal como llega de interpolarla: más corta que 1.
void main() {
    vec3 L = unitario(luz.Lp.xyz - ecPosicion), V = unitario(-ecPosicion);
    float NdotL = max(dot(normal, L), 0.0);
    vec3 R = 2.0 * normal * NdotL - L;
    colorFragmento = vec4(material.Ka * La + NdotL * luz.Ld * material.Kd +
                          potencia(dot(R, V), material.alfa) * luz.Ls * material.Ks, 1.0);
}
