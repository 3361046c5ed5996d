#version 140
#include "ch05_iluminacion/phong.glsl"

uniform mat4 proyeccion, camara, M; // en el libro, projection, camera y transf
uniform mat3 N; // transformación de la normal a coordenadas de la cámara (normal)

in vec3 posicion, vNormal;
out vec3 ecPosicion, normal; // en coordenadas de la cámara

// Listado 5.3. L y V se calculan en cada fragmento, a partir del punto: interpolados desde los vértices ni
// son unitarios ni llevan la dirección debida.
void main() {
    vec4 P = camara * M * vec4(posicion, 1.0);
    // L5.3: el punto y la normal, en coordenadas de la cámara, para que se interpolen
    ecPosicion = P.xyz;
    normal = unitario(N * vNormal);
    // de partida: ecPosicion = posicion;
    // de partida: normal = vNormal;
    // fin de L5.3
    gl_Position = proyeccion * P;
}
