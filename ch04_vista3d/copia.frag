#version 140

uniform sampler2D imagen; // del tamaño del panel
uniform vec2 esquina;     // del panel en la ventana, en píxeles

out vec4 colorFragmento;

void main() {
    colorFragmento = texelFetch(imagen, ivec2(gl_FragCoord.xy - esquina), 0);
}
