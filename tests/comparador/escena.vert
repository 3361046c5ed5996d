#version 140

uniform mat4 camara;

in vec3 posicion, vNormal;
in vec2 coordTextura;
out vec3 normal;
out vec2 st;

void main() {
    normal = vNormal;
    st = coordTextura;
    gl_Position = camara * vec4(posicion, 1.0);
}
