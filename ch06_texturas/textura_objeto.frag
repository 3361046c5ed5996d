#version 140
#include "ch05_iluminacion/phong.glsl"

// Metal, y una fuente sobre el hombro izquierdo del observador: en coordenadas de la cámara, que es donde se ilumina.
const vec3 KA = vec3(0.22), KD = vec3(0.85), KS = vec3(0.45), LA = vec3(1.0);
const float ALFA = 40.0;
const Luz LUZ =
    Luz(vec4(-5.0, 2.5, 3.0, 1.0), vec3(1.0), vec3(1.0), vec3(1.0, 0.0, 0.0), vec3(0.0), -1.0, 0.0);

uniform sampler2D Img; // el número de la unidad de textura

in vec3 ecPosicion, normal;
in vec2 nuevaCoordTextura;
out vec4 colorFragmento;

// La textura (listado 6.3) tiñe lo que la superficie refleja en todas direcciones; el brillo es del color de la luz.
void main() {
    // L6.3: el color de la textura en las coordenadas del fragmento
    vec3 texel = texture(Img, nuevaCoordTextura).rgb;
    // de partida: vec3 texel = vec3(1.0);
    // fin de L6.3
    colorFragmento = vec4(phong(Material(KA * texel, KD * texel, KS, ALFA), LA, LUZ, ecPosicion, normal), 1.0);
}
