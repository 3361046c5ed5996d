#version 140
#include "ch12_animacion/piezas.glsl"

uniform mat4 camara, proyeccion;
uniform vec2 talla;        // columnas y filas
uniform vec3 asiento;      // de una fila a la siguiente: 0, lo que sube y lo que se aleja
uniform float separacion;  // de una columna a la siguiente
uniform vec3 paleta[3];

out vec3 color;
out vec2 tela;             // de 0 a 1; el asta es tela.x = 0
out float onda;

void main() {
    // un sol: el dibujo que hace la grada entera
    float lejos = distance(celda, 0.5 * (talla - 1.0));
    int cual = lejos < 5.6 ? 1 : 2;
    color = paleta[lejos < 3.2 ? 0 : cual];
    tela = 0.5 * posicion + 0.5;
    vec3 va = vaiven();
    onda = 6.0 * va.y;

    float crece = crecida(), inclina = 0.7 * va.x;
    vec2 p = crece * vec2(0.9, 1.1) * tela;
    p = mat2(cos(inclina), sin(inclina), -sin(inclina), cos(inclina)) * p; // gira con la mano que la lleva
    p += vec2(0.0, 0.25 + 0.3 * va.z);
    // dos vecinas se tapan: en un mismo plano, el redondeo decidiría en cada píxel cuál se ve
    float adelante = 0.02 * mod(celda.x, 2.0);
    vec3 pie = vec3(separacion * (celda.x - 0.5 * (talla.x - 1.0)) - 0.25, 0.0, adelante) + celda.y * asiento;
    gl_Position = proyeccion * camara * vec4(pie + vec3(p, 0.0), 1.0);
}
