#version 140

uniform mat4 M;      // transformación del modelo
uniform mat3 N;      // transformación de la normal
uniform mat4 camara; // proyección por vista (capítulo 4)

in vec3 posicion, vNormal;
out vec3 normal;

void main() {
    vec3 n = N * vNormal;
    normal = dot(n, n) > 0.0 ? normalize(n) : vec3(0.0); // una cara aplastada no tiene normal
    gl_Position = camara * M * vec4(posicion, 1.0);
}
