#version 140

#include "common/luz_fija.glsl"

uniform vec3 colorObjeto;

in vec3 normal;
in vec4 recortado;
out vec4 colorFragmento;

const vec3 COLOR_FUERA = vec3(0.80, 0.82, 0.84);

// La condición del recortado: −w ≤ x, y, z ≤ w.
void main() {
    bool dentro = all(lessThanEqual(abs(recortado.xyz), vec3(recortado.w)));
    colorFragmento = vec4((dentro ? colorObjeto : COLOR_FUERA) * luzFija(normalize(normal)), 1.0);
}
