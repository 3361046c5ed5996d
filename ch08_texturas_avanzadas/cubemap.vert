#version 140

uniform mat4 M, camara, proyeccion; // en el libro, transf, camera y projection
uniform mat3 N;                     // transformación de la normal, aquí al mundo (normal)
uniform vec3 ojo;                   // la posición de la cámara en el mundo

in vec3 posicion, vNormal;
out vec3 haciaPunto, normal, reflexion;

// Listado 8.1, pero en coordenadas del mundo, que son las del mapa: en las de la cámara, el entorno giraría con ella.
void main() {
    haciaPunto = (M * vec4(posicion, 1.0)).xyz - ojo;
    normal = normalize(N * vNormal);
    // L8.1: la reflexión, en el vértice, de la dirección en que se le mira, sin hacerla unitaria: se interpola
    reflexion = reflect(haciaPunto, normal);
    // de partida: reflexion = normal;
    // fin de L8.1
    gl_Position = proyeccion * camara * M * vec4(posicion, 1.0);
}
