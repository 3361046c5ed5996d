#version 140
in vec3 posicion;
in vec3 color;
out vec3 vColor;
void main() {
    vColor = color;
    gl_Position = vec4(posicion, 1.0);
    gl_PointSize = 9.0;
}
