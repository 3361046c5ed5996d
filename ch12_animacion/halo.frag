#version 140

uniform vec3 colorLuz;

in vec2 lugar;
out vec4 colorFragmento;

void main() {
    float queda = max(1.0 - length(lugar), 0.0);
    colorFragmento = vec4(0.8 * queda * queda * colorLuz, 1.0);
}
