#version 140

uniform vec2 sentido; // 1, o −1 en los ejes que se voltean

out vec2 coordenadaTextura;

// Ejercicio 9.4: se cambia de signo la posición de los vértices, no la de los texels.
void main() {
    coordenadaTextura = vec2(gl_VertexID % 2, gl_VertexID / 2);
    gl_Position = vec4(sentido * (2.0 * coordenadaTextura - 1.0), 0.0, 1.0);
}
