#version 140
#include "ch09_imagen/filtro.glsl"

const int tallaFiltro = 9;

uniform vec2 desplazamiento[tallaFiltro];
uniform float filtro[tallaFiltro];
uniform bool sumaCero, conSigno;
uniform sampler2D imagen;

in vec2 coordenadaTextura;
out vec4 colorFragmento;

// Listado 9.3, que filtra también la opacidad: con un filtro que suma 0 quedaría todo transparente.
void main() {
    vec3 suma = vec3(0.0);
    for (int i = 0; i < tallaFiltro; i++)
        suma += texture(imagen, coordenadaTextura + desplazamiento[i]).rgb * filtro[i];
    if (sumaCero)
        suma = muestraSigno(suma, conSigno);
    colorFragmento = vec4(suma, texture(imagen, coordenadaTextura).a);
}
