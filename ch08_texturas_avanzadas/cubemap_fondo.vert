#version 140

uniform mat3 base;      // lo que hay a la derecha, arriba y enfrente, en el mundo
uniform vec2 semitalla; // lo que se ve a los lados y en vertical, a distancia 1

out vec3 hacia;

// Un triángulo que llena la vista, detrás de todo; cada fragmento mira en su dirección.
void main() {
    vec2 p = vec2(4 * (gl_VertexID % 2) - 1, 4 * (gl_VertexID / 2) - 1);
    hacia = base * vec3(semitalla * p, 1.0);
    gl_Position = vec4(p, 1.0, 1.0);
}
