#version 140
#include "ch08_texturas_avanzadas/ruido.glsl"

uniform mat4 M, camara, proyeccion;
uniform float tiempo; // qué parte del periodo ha pasado, de 0 a 1
uniform float S1, S2; // frecuencia y amplitud
uniform float centro; // lo que se resta al ruido, que va de 0 a 1: el listado, 0; centrado, 0.5

in vec3 posicion;
out vec3 normal;

const int CELDAS = 4; // las que avanza la coordenada en un periodo, y el periodo del ruido en ese eje

// Gradiente y valor, de 0 a 1, del canal `cual`.
vec4 canal(float cual) {
    vec3 lugar = S1 * posicion + vec3(cual, tiempo * float(CELDAS), cual);
    return 0.5 * ruidoConGradiente(lugar, ivec3(0, CELDAS, 0)) + vec4(0.0, 0.0, 0.0, 0.5);
}

// Listado 12.1. La normal de la superficie deformada es la de la esfera por la matriz de cofactores de la jacobiana J.
void main() {
    vec4 x = canal(0.0), y = canal(11.5), z = canal(23.5);
    vec3 valor = (vec3(x.w, y.w, z.w) - centro) * S2, nuevaPosicion = posicion + valor;

    vec3 J0 = vec3(1.0, 0.0, 0.0) + S1 * S2 * x.xyz, J1 = vec3(0.0, 1.0, 0.0) + S1 * S2 * y.xyz,
         J2 = vec3(0.0, 0.0, 1.0) + S1 * S2 * z.xyz; // sus filas
    normal = normalize(vec3(dot(cross(J1, J2), posicion), dot(cross(J2, J0), posicion), dot(cross(J0, J1), posicion)));
    gl_Position = proyeccion * camara * M * vec4(nuevaPosicion, 1.0);
}
