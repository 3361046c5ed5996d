#version 140

out vec2 coordenadaTextura;

// Un rectángulo sin buffers que llena el área de dibujo: (s, t) va de (0, 0), abajo a la izquierda, a (1, 1).
void main() {
    coordenadaTextura = vec2(gl_VertexID % 2, gl_VertexID / 2);
    gl_Position = vec4(2.0 * coordenadaTextura - 1.0, 0.0, 1.0);
}
