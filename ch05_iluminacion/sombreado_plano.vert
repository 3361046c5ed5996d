#version 140
#include "ch05_iluminacion/phong.glsl"

uniform mat4 proyeccion, camara, M; // en el libro, projection, camera y transf
uniform mat3 N; // transformación de la normal a coordenadas de la cámara (normal)
uniform Material material;
uniform vec3 La; // luz ambiente
uniform Luz luz;

in vec3 posicion, vNormal;
flat out vec3 nuevoColor;

// Se ilumina una vez por polígono: vale el color de su último vértice, y vNormal es la del polígono.
void main() {
    vec4 P = camara * M * vec4(posicion, 1.0);
    nuevoColor = phong(material, La, luz, P.xyz, N * vNormal);
    gl_Position = proyeccion * P;
}
