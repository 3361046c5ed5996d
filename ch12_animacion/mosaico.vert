#version 140
#include "ch12_animacion/piezas.glsl"

uniform mat4 proyeccion;
uniform vec2 talla;    // columnas y filas
uniform vec3 paleta[5];

out vec3 color;

// Una flor de ocho pétalos, con su centro, su orla y el fondo.
int dibujo(vec2 p) {
    float r = length(p), petalo = 0.62 + 0.22 * cos(8.0 * atan(p.y, p.x + 1e-6));
    if (r < 0.2)
        return 0;
    if (r < petalo - 0.22)
        return 1;
    if (r < petalo)
        return 2;
    return max(abs(p.x) * talla.y / talla.x, abs(p.y)) > 0.9 ? 3 : 4;
}

void main() {
    vec2 centro = (2.0 * celda + 1.0 - talla) / talla.y; // y, de -1 a 1
    color = paleta[dibujo(centro)] * (1.0 + 0.12 * sin(91.0 * celda.x + 57.0 * celda.y)); // no hay dos teselas iguales
    vec3 va = vaiven();
    float lado = 0.9 * crecida(), giro = 0.5 * va.z;
    vec2 corrido = 0.9 * va.xy; // en medias celdas
    vec2 esquina = mat2(cos(giro), sin(giro), -sin(giro), cos(giro)) * posicion;
    gl_Position = proyeccion * vec4(centro + (lado * esquina + corrido) / talla.y, 0.0, 1.0);
}
