#version 140
#include "ch05_iluminacion/phong.glsl"

uniform mat4 proyeccion, vista, M;
uniform mat3 N; // transformación de la normal a coordenadas de la cámara
uniform vec2 repeticiones;

in vec3 posicion, vNormal;
in vec2 coordTextura;
out vec3 ecPosicion, normal; // en coordenadas de la cámara
out vec2 nuevaCoordTextura;

void main() {
    vec4 P = vista * M * vec4(posicion, 1.0);
    ecPosicion = P.xyz;
    normal = unitario(N * vNormal);
    nuevaCoordTextura = repeticiones * coordTextura;
    gl_Position = proyeccion * P;
}
