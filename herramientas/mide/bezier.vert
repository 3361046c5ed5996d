#version 140

uniform vec3 G[4];
uniform float ultimo;

out vec3 punto;

void main() {
    float u = float(gl_VertexID) / ultimo, c = 1.0 - u;
    punto = c * c * c * G[0] + 3.0 * c * c * u * G[1] + 3.0 * c * u * u * G[2] + u * u * u * G[3];
    gl_Position = vec4(punto, 1.0);
}
