#version 140
#include "ch09_imagen/filtro.glsl"

const int tallaFiltro = 9;

uniform vec2 desplazamiento[tallaFiltro];
uniform float filtro[tallaFiltro];
uniform bool sumaCero, conSigno, ceroFuera;
uniform float ganancia; // de lo que suma 0
uniform sampler2D imagen;

in vec2 coordenadaTextura;
out vec4 colorFragmento;

// Listado 9.3, que filtra también la opacidad: con un filtro que suma 0 quedaría todo transparente.
void main() {
    vec3 suma = vec3(0.0);
    // L9.3: cada texel vecino por su número del filtro; si ceroFuera, los de fuera no cuentan
    for (int i = 0; i < tallaFiltro; i++) {
        vec2 st = coordenadaTextura + desplazamiento[i];
        bool dentro = st == clamp(st, 0.0, 1.0);
        if (dentro || !ceroFuera)
            suma += texture(imagen, st).rgb * filtro[i];
    }
    // de partida: suma = texture(imagen, coordenadaTextura).rgb;
    // fin de L9.3
    if (sumaCero)
        suma = muestraSigno(ganancia * suma, conSigno);
    colorFragmento = vec4(suma, texture(imagen, coordenadaTextura).a);
}
