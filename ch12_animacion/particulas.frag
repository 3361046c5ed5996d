#version 140

in vec4 color;
out vec4 colorFragmento;

void main() {
    vec2 d = 2.0 * gl_PointCoord - 1.0; // un disco que se desvanece hacia el borde
    float borde = max(1.0 - dot(d, d), 0.0);
    colorFragmento = vec4(color.rgb, color.a * borde);
}
