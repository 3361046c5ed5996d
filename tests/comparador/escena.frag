#version 140

uniform sampler2D textura;
uniform vec3 luz;

in vec3 normal;
in vec2 st;
out vec4 colorFragmento;

void main() {
    float difusa = max(dot(normalize(normal), normalize(luz)), 0.0);
    colorFragmento = vec4((0.2 + 0.8 * difusa) * texture(textura, st).rgb, 1.0);
}
