#version 140

uniform mat4 camara, proyeccion; // capítulo 4
uniform float diametroPunto;     // de GL_POINTS, en píxeles

in vec3 posicion;
in vec3 color;
flat out vec3 colorPrimitiva; // sin interpolar: el del último vértice de cada punto, segmento o triángulo

void main() {
    colorPrimitiva = color;
    gl_PointSize = diametroPunto;
    gl_Position = proyeccion * camara * vec4(posicion, 1.0);
}
