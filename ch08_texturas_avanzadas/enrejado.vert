#version 140

uniform mat4 M, camara, proyeccion;
uniform mat3 N; // transformación de la normal a coordenadas de la cámara

in vec3 posicion, vNormal;
in vec2 coordTextura;
out vec3 ecPosicion, normal; // en coordenadas de la cámara
out vec2 nuevaCoordTextura;

void main() {
    vec4 P = camara * M * vec4(posicion, 1.0);
    ecPosicion = P.xyz;
    normal = normalize(N * vNormal);
    nuevaCoordTextura = coordTextura;
    gl_Position = proyeccion * P;
}
