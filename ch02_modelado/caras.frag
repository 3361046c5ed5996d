#version 140

uniform vec3 colorAnverso; // de las caras que se ven girar en sentido antihorario
uniform vec3 colorReverso; // de las que se ven girar en sentido horario

in vec3 punto;
out vec4 colorFragmento;

const vec3 haciaLuz = vec3(-0.41, 0.65, 0.64); // unitario

// La normal de un polígono plano sale de cuánto cambia el punto de un píxel al de su derecha y al de encima;
// apunta siempre hacia quien mira, así que las dos caras se iluminan igual.
void main() {
    vec3 normal = normalize(cross(dFdx(punto), dFdy(punto)));
    vec3 color = gl_FrontFacing ? colorAnverso : colorReverso;
    colorFragmento = vec4(color * (0.74 + 0.30 * dot(normal, haciaLuz)), 1.0);
}
