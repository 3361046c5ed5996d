#version 140

uniform float t;

float azar(uint n) { // particulas.vert
    n = (n ^ (n >> 16)) * 0x7feb352du;
    n = (n ^ (n >> 15)) * 0x846ca68bu;
    n = n ^ (n >> 16);
    return float(n >> 8) / 16777216.0;
}

void main() {
    uint semilla = 3u * uint(gl_VertexID);
    float s = 2.0 * fract(0.5 * t + azar(semilla));
    vec2 v = vec2(2.0 * azar(semilla + 1u) - 1.0, 4.0 + azar(semilla + 2u));
    gl_Position = vec4(0.2 * v.x * s, 0.4 * (v.y * s - 2.5 * s * s) - 0.8, 0.0, 1.0);
}
