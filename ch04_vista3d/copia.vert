#version 140

// Un solo triángulo, sin buffers, que cubre el panel entero.
void main() {
    vec2 esquina = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(esquina, 0.0, 1.0);
}
