#version 140

uniform sampler2D imagen;
uniform float angulo; // radianes, en el centro

in vec2 coordenadaTextura;
out vec4 colorFragmento;

// Cada píxel busca su color donde estaba antes de girar: alrededor del centro, menos cuanto más lejos y nada desde el
// círculo que cabe en la imagen. Las distancias son en texeles, para que sea un círculo.
void main() {
    vec2 talla = vec2(textureSize(imagen, 0)), p = (coordenadaTextura - 0.5) * talla;
    float cerca = max(1.0 - length(p) / (0.5 * min(talla.x, talla.y)), 0.0), giro = -angulo * cerca * cerca;
    vec2 antes = mat2(cos(giro), sin(giro), -sin(giro), cos(giro)) * p;
    colorFragmento = texture(imagen, antes / talla + 0.5);
}
