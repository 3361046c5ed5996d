#version 140
#include "ch05_iluminacion/phong.glsl"

uniform vec2 nVeces; // que se repite en s y en t
uniform vec2 talla;  // parte de cada repetición que es barrote, en s y en t
uniform Material material;
uniform vec3 colorInterior; // mate
uniform vec3 La;
uniform Luz luz;

in vec3 ecPosicion, normal;
in vec2 nuevaCoordTextura; // coordTextura en el listado, que ya es el atributo del vértice
out vec4 colorFragmento;

// Listado 8.3. Por los huecos se ve la otra cara de la superficie, que tiene la normal opuesta.
void main() {
    // L8.3: de cada una de las nVeces repeticiones se descarta lo que no es barrote
    float s = fract(nuevaCoordTextura.s * nVeces.s), t = fract(nuevaCoordTextura.t * nVeces.t);
    if (s > talla.s && t > talla.t)
        discard;
    // fin de L8.3
    Material interior = Material(0.25 * colorInterior, 0.8 * colorInterior, vec3(0.0), 1.0);
    vec3 color = gl_FrontFacing ? phong(material, La, luz, ecPosicion, normal)
                                : phong(interior, La, luz, ecPosicion, -normal);
    colorFragmento = vec4(color, 1.0);
}
