#version 140

uniform mat4 M;       // transformación del modelo
uniform mat3 N;       // transformación de la normal
uniform mat4 camara;  // proyección por vista de quien mira desde fuera
uniform mat4 volumen; // proyección por vista de la cámara que se estudia

in vec3 posicion, vNormal;
out vec3 normal;
out vec4 recortado; // coordenadas de recortado en el volumen que se estudia

void main() {
    normal = normalize(N * vNormal);
    recortado = volumen * M * vec4(posicion, 1.0);
    gl_Position = camara * M * vec4(posicion, 1.0);
}
