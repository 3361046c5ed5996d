#version 140

uniform vec3 identificador; // del objeto, como color plano: sin luz, para leer justo lo que se escribe

out vec4 colorFragmento;

void main() {
    colorFragmento = vec4(identificador, 1.0);
}
