#version 140
#include "ch05_iluminacion/phong.glsl"

uniform Material material;
uniform vec3 La;
uniform Luz luz;
uniform vec4 corte; // plano, en coordenadas de la cámara: lo que está en su lado positivo no se dibuja

in vec3 ecPosicion, normal;
out vec4 colorFragmento;

void main() {
    if (dot(corte, vec4(ecPosicion, 1.0)) > 0.02) // y no 0: junto al marco, una muestra del píxel puede estar detrás
        discard;
    colorFragmento = vec4(phong(material, La, luz, ecPosicion, normal), 1.0);
}
