#version 140
#include "ch05_iluminacion/phong.glsl"

uniform float altura;
uniform Material material;
uniform vec3 La;
uniform Luz luz;

in vec3 ecPosicion, normal;
in vec2 st;
out vec4 colorFragmento;

const float RADIO = 0.42, ALTO = 0.15; // los de mapa_normales.h

// bump.frag, con la pendiente de mapa_normales.h en vez de leída de la textura.
void main() {
    vec2 d = (fract(st) - 0.5) / RADIO, dh = -altura * 4.0 * ALTO / RADIO * max(1.0 - dot(d, d), 0.0) * d;
    vec3 N = normalize(normal), Px = dFdx(ecPosicion), Py = dFdy(ecPosicion);
    float hx = dot(dh, dFdx(st)), hy = dot(dh, dFdy(st)), det = dot(Px, cross(Py, N));
    N = normalize(abs(det) * N - sign(det) * (hx * cross(Py, N) + hy * cross(N, Px)));
    colorFragmento = vec4(phong(material, La, luz, ecPosicion, N), 1.0);
}
