#version 140

uniform vec3 colorObjeto;

in vec3 normal;
out vec4 colorFragmento;

const vec3 haciaLuz = vec3(0.20, 0.78, 0.593); // unitario, en coordenadas del mundo

// Un sombreado suficiente para ver las formas: el modelo de iluminación es el capítulo 5.
void main() {
    float luz = 0.58 + 0.42 * dot(normal, haciaLuz);
    colorFragmento = vec4(colorObjeto * luz, 1.0);
}
