#version 140

uniform mat4 M, camara, proyeccion;
uniform mat3 N;
uniform float escala, tau; // tau: qué parte del periodo ha pasado, de 0 a 1

in vec3 posicion, vNormal;
out vec3 coordTextura3D, normal;

// La textura llena el espacio y el objeto la corta: sus coordenadas son las del punto, trasladadas con el tiempo. La
// textura se repite cada 1, y al cabo de un periodo ha avanzado justo 1.
void main() {
    vec4 P = M * vec4(posicion, 1.0);
    coordTextura3D = escala * P.xyz - vec3(0.0, tau, 0.0);
    normal = normalize(N * vNormal);
    gl_Position = proyeccion * camara * P;
}
