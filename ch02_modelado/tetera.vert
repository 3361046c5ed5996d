#version 140

uniform mat4 M;                  // transformación del modelo: un giro, que vale también para la normal
uniform mat4 camara, proyeccion; // capítulo 4

in vec3 posicion, vNormal;
in vec2 coordTextura; // columna y fila en la cuadrícula de su parche
out vec3 punto, normal; // en coordenadas del mundo
out vec2 cuadricula;

void main() {
    punto = vec3(M * vec4(posicion, 1.0));
    normal = mat3(M) * vNormal;
    cuadricula = coordTextura;
    gl_Position = proyeccion * camara * vec4(punto, 1.0);
}
