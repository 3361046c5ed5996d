#version 140

#include "common/luz_fija.glsl"

uniform vec3 colorAnverso; // de las caras que se ven girar en sentido antihorario
uniform vec3 colorReverso; // de las que se ven girar en sentido horario

in vec3 punto;
out vec4 colorFragmento;

// La normal de un polígono plano sale de cuánto cambia el punto de un píxel al de su derecha y al de encima;
// apunta siempre hacia quien mira, así que las dos caras se iluminan igual.
void main() {
    vec3 normal = normalize(cross(dFdx(punto), dFdy(punto)));
    vec3 color = gl_FrontFacing ? colorAnverso : colorReverso;
    colorFragmento = vec4(color * luzFija(normal), 1.0);
}
