#version 140

uniform mat4 M, camara, proyeccion;

in vec3 posicion;

// Los productos, de derecha a izquierda: multiplicar antes las matrices pierde cifras de la profundidad.
void main() {
    gl_Position = proyeccion * (camara * (M * vec4(posicion, 1.0)));
}
