#version 140

uniform mat4 M;          // transformación del modelo (en el libro, transf)
uniform mat3 N;          // transformación de la normal (normal)
uniform mat4 camara;     // transformación de la cámara, capítulo 4 (camera)
uniform mat4 proyeccion; // capítulo 4 (projection)

in vec3 posicion, vNormal;
out vec3 normal;

void main() {
    // L3.1: la normal, con N y unitaria; la posición, con M, la cámara y la proyección
    vec3 n = N * vNormal;
    normal = dot(n, n) > 0.0 ? normalize(n) : vec3(0.0); // una cara aplastada no tiene normal
    gl_Position = proyeccion * camara * M * vec4(posicion, 1.0);
    // de partida: normal = vNormal;
    // de partida: gl_Position = proyeccion * camara * vec4(posicion, 1.0);
    // fin de L3.1
}
