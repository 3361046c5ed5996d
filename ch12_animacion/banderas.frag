#version 140

in vec3 color;
in vec2 tela;
in float onda;
out vec4 colorFragmento;

// El cuadrado de la partícula lleva el asta y, arriba, la tela, que ondea más cuanto más lejos del asta.
void main() {
    float ola = sin(7.0 * tela.x - onda), y = tela.y + 0.06 * tela.x * ola;
    bool asta = tela.x < 0.07;
    if (!asta && (y < 0.45 || y > 0.94))
        discard;
    colorFragmento = vec4(asta ? vec3(0.35, 0.25, 0.18) : color * (0.86 + 0.14 * cos(7.0 * tela.x - onda)), 1.0);
}
