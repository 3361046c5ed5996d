#version 140

in vec2 posicion;
in vec3 color;
flat out vec3 colorPrimitiva; // sin interpolar: el del último vértice de cada punto, segmento o triángulo

void main() {
    colorPrimitiva = color;
    gl_Position = vec4(posicion, 0.0, 1.0);
}
