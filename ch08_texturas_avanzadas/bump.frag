#version 140
#include "ch05_iluminacion/phong.glsl"

uniform sampler2D mapaNormales;
uniform float altura; // lo que mide una unidad de altura del mapa, en la escena; 0: superficie lisa
uniform Material material;
uniform vec3 La;
uniform Luz luz;

in vec3 ecPosicion, normal;
in vec2 st;
out vec4 colorFragmento;

// La normal de la superficie desplazada P + h·N: N − ∇h, con el gradiente de h en la superficie. De lo que cambian P y
// (s, t) de un píxel al siguiente salen los ejes de la textura en la superficie, con la longitud que tengan: vale con
// cualquier transformación y no hacen falta más atributos.
vec3 perturba(vec3 N, vec2 dh) {
    vec3 Px = dFdx(ecPosicion), Py = dFdy(ecPosicion);
    float hx = dot(dh, dFdx(st)), hy = dot(dh, dFdy(st)), det = dot(Px, cross(Py, N));
    if (det == 0.0) // de canto no hay ejes
        return N;
    vec3 gradiente = sign(det) * (hx * cross(Py, N) + hy * cross(N, Px));
    return normalize(abs(det) * N - gradiente);
}

void main() {
    vec3 n = 2.0 * texture(mapaNormales, st).xyz - 1.0;
    vec3 N = perturba(normalize(normal), -altura * n.xy / n.z);
    colorFragmento = vec4(phong(material, La, luz, ecPosicion, N), 1.0);
}
