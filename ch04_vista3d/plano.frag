#version 140

uniform vec3 colorObjeto;

out vec4 colorFragmento;

void main() {
    colorFragmento = vec4(colorObjeto, 1.0);
}
