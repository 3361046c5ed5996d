#version 140

uniform mat4 proyeccion;

out vec2 nuevaCoordTextura;

const float LADO = 20.0; // llena cualquier ventana hasta 5 veces más larga que ancha

// Un cuadrado sin buffers: la posición de cada vértice sale de su número, y sus coordenadas de textura, de la
// posición, con (0.5, 0.5) en el centro de la ventana: van de -9.5 a 10.5.
void main() {
    vec2 posicion = LADO * (vec2(gl_VertexID % 2, gl_VertexID / 2) - 0.5);
    nuevaCoordTextura = posicion + 0.5;
    gl_Position = proyeccion * vec4(posicion, 0.0, 1.0);
}
