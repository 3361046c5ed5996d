#version 140

uniform vec3 ojo; // posición de la cámara
uniform vec3 colorObjeto, colorLinea;
uniform float grosor; // de las líneas, en píxeles; 0, sin ellas
uniform bool hayDiagonales;

in vec3 punto, normal;
in vec2 cuadricula;
out vec4 colorFragmento;

const vec3 haciaLuz = vec3(-0.62, 0.45, 0.643); // unitario

// Un esmalte: difuso, brillo de la luz y, en los bordes, reflejo de un cielo claro. El modelo de iluminación
// es el capítulo 5; aquí basta con que la normal se vea.
vec3 esmalte() {
    vec3 haciaOjo = normalize(ojo - punto);
    vec3 n = normalize(normal);
    if (dot(n, haciaOjo) < 0.0)
        n = -n; // el interior, que se ve por la boca y por el pitorro
    float difuso = 0.36 + 0.68 * max(dot(n, haciaLuz), 0.0) + 0.26 * n.y;
    float brillo = pow(max(dot(n, normalize(haciaLuz + haciaOjo)), 0.0), 70.0);
    // redondeado, N·V pasa de 1, y pow no admite negativos
    float borde = pow(clamp(1.0 - dot(n, haciaOjo), 0.0, 1.0), 4.0);
    return colorObjeto * difuso + 0.7 * brillo + 0.35 * borde * vec3(0.75, 0.86, 1.0);
}

// Píxeles hasta el punto más cercano en que x es entero: lo que falta, entre lo que x cambia de un píxel a otro.
float distanciaAEntero(float x) {
    return abs(fract(x + 0.5) - 0.5) / max(length(vec2(dFdx(x), dFdy(x))), 1e-6);
}

// Las aristas no son líneas de OpenGL: los fragmentos próximos a un lado toman su color.
void main() {
    float lados = min(distanciaAEntero(cuadricula.x), distanciaAEntero(cuadricula.y));
    float diagonal = distanciaAEntero(cuadricula.x - cuadricula.y);
    float distancia = hayDiagonales ? min(lados, diagonal) : lados;
    float linea = grosor > 0.0 ? clamp(0.5 * grosor + 0.5 - distancia, 0.0, 1.0) : 0.0;
    colorFragmento = vec4(mix(esmalte(), colorLinea, linea), 1.0);
}
