#version 140

uniform mat4 M;      // transformación del modelo: un giro, que vale también para la normal
uniform mat4 camara; // proyección por vista (capítulo 4)

in vec3 posicion, vNormal;
out vec3 punto, normal; // en coordenadas del mundo

void main() {
    punto = vec3(M * vec4(posicion, 1.0));
    normal = mat3(M) * vNormal;
    gl_Position = camara * vec4(punto, 1.0);
}
