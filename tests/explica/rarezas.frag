#version 140
in vec3 vColor;
uniform float opacidad, copia;
out vec4 colorFragmento;
void main() {
    bool igual = copia == opacidad;
    if (vColor.r > 0.95)
        discard;
    colorFragmento = vec4(vColor, opacidad);
}
