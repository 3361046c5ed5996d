#version 140

uniform mat4 M;                  // de la pieza al bloque del que se talla
uniform mat4 camara, proyeccion;
uniform mat3 N;                  // transformación de la normal a coordenadas de la cámara

in vec3 posicion, vNormal;
out vec3 coordVertice, ecPosicion, normal;

// §8.3: las coordenadas de textura son las del propio bloque, así que la veta pasa de una pieza a otra.
void main() {
    vec4 P = M * vec4(posicion, 1.0);
    coordVertice = P.xyz;
    ecPosicion = (camara * P).xyz;
    normal = normalize(N * vNormal);
    gl_Position = proyeccion * camara * P;
}
