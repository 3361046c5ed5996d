#version 140

uniform vec3 ojo; // posición de la cámara
uniform vec3 colorObjeto;

in vec3 punto, normal;
out vec4 colorFragmento;

const vec3 haciaLuz = vec3(-0.62, 0.45, 0.643); // unitario

// Un esmalte: difuso, brillo de la luz y, en los bordes, reflejo de un cielo claro. El modelo de iluminación
// es el capítulo 5; aquí basta con que la normal se vea.
void main() {
    vec3 haciaOjo = normalize(ojo - punto);
    vec3 n = normalize(normal);
    if (dot(n, haciaOjo) < 0.0)
        n = -n; // el interior, que se ve por la boca y por el pitorro
    float difuso = 0.36 + 0.68 * max(dot(n, haciaLuz), 0.0) + 0.26 * n.y;
    float brillo = pow(max(dot(n, normalize(haciaLuz + haciaOjo)), 0.0), 70.0);
    float borde = pow(1.0 - max(dot(n, haciaOjo), 0.0), 4.0);
    vec3 color = colorObjeto * difuso + 0.7 * brillo + 0.35 * borde * vec3(0.75, 0.86, 1.0);
    colorFragmento = vec4(color, 1.0);
}
