#version 140

uniform mat4 M;          // transformación del modelo
uniform mat3 N;          // transformación de la normal
uniform mat4 camara;     // de quien mira desde fuera
uniform mat4 proyeccion;
uniform mat4 aRecortado; // del objeto a coordenadas de recortado del volumen que se estudia

in vec3 posicion, vNormal;
out vec3 normal;
out vec4 recortado;

void main() {
    normal = normalize(N * vNormal);
    recortado = aRecortado * vec4(posicion, 1.0);
    gl_Position = proyeccion * camara * M * vec4(posicion, 1.0);
}
