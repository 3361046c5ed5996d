#version 140

uniform mat4 M, camara, proyeccion; // en el libro, transf, camera y projection
uniform mat4 S;                     // proyección de la sombra, ecuación 7.4
uniform vec4 plano;                 // aquel en que cae

in vec3 posicion;
out float altura; // de lo que da la sombra, sobre el plano

void main() {
    vec4 P = M * vec4(posicion, 1.0);
    altura = dot(plano, P);
    gl_Position = proyeccion * camara * S * P;
}
