#version 140

uniform vec2 sentido; // 1, o −1 en los ejes que se voltean

out vec2 coordenadaTextura;

void main() {
    coordenadaTextura = vec2(gl_VertexID % 2, gl_VertexID / 2);
    // E9.4: cada vértice del rectángulo, de −1 a 1, volteado según sentido
    // se cambia de signo la posición de los vértices, no la de los texeles
    gl_Position = vec4(sentido * (2.0 * coordenadaTextura - 1.0), 0.0, 1.0);
    // de partida: gl_Position = vec4(2.0 * coordenadaTextura - 1.0, 0.0, 1.0);
    // fin de E9.4
}
