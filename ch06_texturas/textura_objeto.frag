#version 140
#include "ch05_iluminacion/phong.glsl"

uniform sampler2D Img; // el número de la unidad de textura
uniform Material material;
uniform vec3 La; // luz ambiente
uniform Luz luz;

in vec3 ecPosicion, normal;
in vec2 nuevaCoordTextura;
out vec4 colorFragmento;

// La textura (listado 6.3) tiñe lo que la superficie refleja en todas direcciones; el brillo es del color de
// la luz.
void main() {
    vec3 texel = texture(Img, nuevaCoordTextura).rgb;
    Material tenido = Material(material.Ka * texel, material.Kd * texel, material.Ks, material.alfa);
    colorFragmento = vec4(phong(tenido, La, luz, ecPosicion, normal), 1.0);
}
