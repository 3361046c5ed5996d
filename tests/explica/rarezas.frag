#version 140
in vec3 vColor;
uniform float opacidad;
out vec4 colorFragmento;
void main() {
    if (vColor.r > 0.95)
        discard;
    colorFragmento = vec4(vColor, opacidad);
}
