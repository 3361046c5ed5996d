#version 140

uniform vec4 color;
uniform vec4 luz;        // w = 0: en el infinito
uniform float alturaLuz; // sobre el plano

in float altura;
out vec4 colorFragmento;

// No da sombra lo que está bajo el plano, ni lo que está más alto que la luz: la proyección lo llevaría al otro lado.
void main() {
    if (altura < 0.0 || altura * luz.w >= alturaLuz)
        discard;
    colorFragmento = color;
}
