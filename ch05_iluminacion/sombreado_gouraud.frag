#version 140

in vec3 nuevoColor;
out vec4 colorFragmento;

void main() {
    // el color llega interpolado de los vértices, que son los que se iluminan
    colorFragmento = vec4(nuevoColor, 1.0);
}
