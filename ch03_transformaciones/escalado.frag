#version 140

// El color depende de qué lado de la cara se ve, y eso lo decide el sentido en que giran sus vértices ya en la
// ventana: un escalado de determinante negativo lo invierte.
uniform vec3 colorFuera, colorDentro;

in vec3 normal;
out vec4 colorFragmento;

const vec3 haciaLuz = vec3(0.20, 0.78, 0.593); // la de objeto.frag

void main() {
    float luz = 0.58 + 0.42 * dot(normal, haciaLuz);
    colorFragmento = vec4((gl_FrontFacing ? colorFuera : colorDentro) * luz, 1.0);
}
