#version 140

// Cubre el único píxel de la sonda.
void main() {
    gl_Position = vec4(4 * (gl_VertexID % 2) - 1, 4 * (gl_VertexID / 2) - 1, 0.0, 1.0);
}
