#version 140

uniform sampler2D atlas; // distancia con signo al borde de cada letra; sin mipmaps: pedir su nivel compila antes
uniform vec3 tinta;
uniform float borde, nitidez;

in vec2 enAtlas;

out vec4 colorFragmento;

void main() {
    float cubierto = clamp((textureLod(atlas, enAtlas, 0.0).r - borde) * nitidez + 0.5, 0.0, 1.0);
    colorFragmento = vec4(tinta, cubierto);
}
