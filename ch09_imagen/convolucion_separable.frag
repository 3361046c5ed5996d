#version 140
#include "ch09_imagen/filtro.glsl"

const int TALLA_MAXIMA = 31; // nucleos.h

uniform sampler2D imagen;
// no en una textura, que cuesta leer tanto como la imagen; los 31² de la directa no cabrían
uniform float filtro[TALLA_MAXIMA];
uniform int talla;
uniform vec2 eje;                // (1, 0), la fila del filtro; (0, 1), su columna
uniform bool sumaCero, conSigno; // en la última pasada de un filtro que suma 0

in vec2 coordenadaTextura;
out vec4 colorFragmento;

// Una pasada de un filtro separable: la ecuación 9.1 con un filtro de talla × 1 o de 1 × talla.
void main() {
    // E9.2: la suma, con filtro, de los texeles que hay a lo largo de eje, tantos como talla; el central, (talla − 1) / 2
    vec2 paso = eje / vec2(textureSize(imagen, 0));
    int centro = (talla - 1) / 2;
    vec3 suma = vec3(0.0);
    for (int i = -centro; i < talla - centro; i++) // desde 0, Mesa desenrolla el bucle: siempre 31 vueltas
        suma += filtro[i + centro] * texture(imagen, coordenadaTextura + float(i) * paso).rgb;
    // de partida: vec3 suma = texture(imagen, coordenadaTextura).rgb;
    // fin de E9.2
    if (sumaCero)
        suma = muestraSigno(suma, conSigno);
    colorFragmento = vec4(suma, texture(imagen, coordenadaTextura).a);
}
