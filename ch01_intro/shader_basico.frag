#version 140

out vec4 color;

void main() {
    // L1.2: el color de cada fragmento: rojo
    color = vec4(1.0, 0.0, 0.0, 1.0);
    // de partida: color = vec4(0.6, 0.6, 0.6, 1.0);
    // fin de L1.2
}
