#version 140

uniform mat4 M, camara, proyeccion;
uniform mat3 N; // transformación de la normal
uniform vec2 repeticiones;

in vec3 posicion, vNormal;
in vec2 coordTextura;
out vec3 ecPosicion, normal; // ecPosicion, en coordenadas de la cámara; la normal, en las que diga N
out vec2 nuevaCoordTextura;

void main() {
    ecPosicion = (camara * M * vec4(posicion, 1.0)).xyz;
    normal = normalize(N * vNormal);
    nuevaCoordTextura = repeticiones * coordTextura;
    gl_Position = proyeccion * camara * M * vec4(posicion, 1.0);
}
