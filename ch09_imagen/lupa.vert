#version 140

uniform vec2 primero, tramo; // de la imagen, esquina y tamaño de lo que se ve en el área de dibujo: de 0 a 1

out vec2 coordenadaTextura;

void main() {
    vec2 rectangulo = vec2(gl_VertexID % 2, gl_VertexID / 2);
    coordenadaTextura = primero + tramo * rectangulo;
    gl_Position = vec4(2.0 * rectangulo - 1.0, 0.0, 1.0);
}
