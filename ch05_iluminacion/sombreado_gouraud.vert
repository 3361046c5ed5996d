#version 140
#include "ch05_iluminacion/phong.glsl"

uniform mat4 proyeccion, camara, M; // en el libro, projection, camera y transf
uniform mat3 N; // transformación de la normal a coordenadas de la cámara (normal)
uniform Material material;
uniform vec3 La; // luz ambiente
uniform Luz luz;

in vec3 posicion, vNormal;
out vec3 nuevoColor;

// Listado 5.2: se ilumina el vértice y se interpola su color.
void main() {
    vec4 P = camara * M * vec4(posicion, 1.0);
    // L5.2: el color del vértice: phong, en su punto y con su normal
    nuevoColor = phong(material, La, luz, P.xyz, N * vNormal);
    // de partida: nuevoColor = material.Ka * La;
    // fin de L5.2
    gl_Position = proyeccion * P;
}
