#version 140

uniform vec2 giro; // coseno y seno

in vec3 posicion; // en coordenadas normalizadas del dispositivo

void main() {
    gl_Position = vec4(mat2(giro.x, giro.y, -giro.y, giro.x) * posicion.xy, 0.0, 1.0);
}
