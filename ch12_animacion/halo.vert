#version 140

uniform mat4 camara, proyeccion;
uniform vec3 centro;
uniform float radio;

in vec3 posicion; // del cuadrado de lado 1
out vec2 lugar;   // de -1 a 1

// El cuadrado, siempre de cara a la cámara.
void main() {
    lugar = 2.0 * posicion.xy;
    gl_Position = proyeccion * (camara * vec4(centro, 1.0) + vec4(radio * lugar, 0.0, 0.0));
}
