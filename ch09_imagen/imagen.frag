#version 140

uniform sampler2D imagen;

in vec2 coordenadaTextura;
out vec4 colorFragmento;

void main() {
    colorFragmento = texture(imagen, coordenadaTextura);
}
