#version 140

#include "common/luz_fija.glsl"

uniform vec3 colorObjeto;

in vec3 normal;
in vec4 recortado;
out vec4 colorFragmento;

// Lo de fuera, en gris, y cada objeto en el suyo: un cubo no se pierde en el suelo.
vec3 gris(vec3 color) {
    return vec3(0.70 + 0.20 * dot(color, vec3(0.299, 0.587, 0.114)));
}

// La condición del recortado: −w ≤ x, y, z ≤ w.
void main() {
    bool dentro = all(lessThanEqual(abs(recortado.xyz), vec3(recortado.w)));
    colorFragmento = vec4((dentro ? colorObjeto : gris(colorObjeto)) * luzFija(normalize(normal)), 1.0);
}
