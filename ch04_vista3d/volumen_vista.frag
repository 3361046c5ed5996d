#version 140

uniform vec3 colorObjeto;

in vec3 normal;
in vec4 recortado;
out vec4 colorFragmento;

const vec3 haciaLuz = vec3(0.20, 0.78, 0.593); // unitario, en coordenadas del mundo
const vec3 colorFuera = vec3(0.80, 0.82, 0.84);

// La condición del recortado: −w ≤ x, y, z ≤ w.
void main() {
    bool dentro = all(lessThanEqual(abs(recortado.xyz), vec3(recortado.w)));
    float luz = 0.58 + 0.42 * dot(normalize(normal), haciaLuz);
    colorFragmento = vec4((dentro ? colorObjeto : colorFuera) * luz, 1.0);
}
