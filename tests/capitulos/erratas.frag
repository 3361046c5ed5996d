#version 140

uniform int cual;
uniform vec4 v;
uniform mat4 M;

out vec4 colorFragmento;

void main() {
    if (cual == 0) colorFragmento = v * M;
    else if (cual == 1) colorFragmento = M * v;
    else colorFragmento = 1.0 - v;
}
