#version 140

uniform sampler2D Img;
uniform float tau;      // qué parte del periodo ha pasado, de 0 a 1
uniform float amplitud; // de la onda, en partes de la textura

in vec2 nuevaCoordTextura;
out vec4 colorFragmento;

const float DOS_PI = 6.2831853, ONDAS = 3.0;

// Cada fila se corre a un lado y cada columna arriba o abajo: una onda que avanza, seno de la posición y del tiempo.
void main() {
    vec2 onda = sin(DOS_PI * (ONDAS * nuevaCoordTextura.ts - tau));
    colorFragmento = texture(Img, nuevaCoordTextura + amplitud * onda);
}
