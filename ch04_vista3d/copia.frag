#version 140

uniform sampler2D imagen; // del tamaño de la ventana

out vec4 colorFragmento;

void main() {
    colorFragmento = texelFetch(imagen, ivec2(gl_FragCoord.xy), 0);
}
