#version 140

flat in vec3 colorPrimitiva;
out vec4 colorFragmento;

void main() {
    colorFragmento = vec4(colorPrimitiva, 1.0);
}
