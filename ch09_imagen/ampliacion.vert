#version 140

uniform vec2 escala; // el factor por la proporción del rectángulo (§9.4, paso 3)

out vec2 coordenadaTextura;

void main() {
    coordenadaTextura = vec2(gl_VertexID % 2, gl_VertexID / 2);
    gl_Position = vec4(escala * (2.0 * coordenadaTextura - 1.0), 0.0, 1.0);
}
