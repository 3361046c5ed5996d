#version 140

uniform sampler2D Img; // el número de la unidad de textura

in vec2 nuevaCoordTextura;
out vec4 colorFragmento;

// Listado 6.3: el color llega ya repetido y filtrado según los parámetros del objeto textura.
void main() {
    colorFragmento = texture(Img, nuevaCoordTextura);
}
