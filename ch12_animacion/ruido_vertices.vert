#version 140

const float DOS_PI = 6.2831853, RADIO_TUBO = 0.42; // el del toro
const float PASO = 1.0 / 64.0;                     // un texel: de ahí a ahí se mide cuánto cambia el ruido

uniform mat4 M, camara, proyeccion;
uniform sampler2D ruido;      // tres ruidos de 0 a 1, uno por canal
uniform float tiempo, S1, S2; // tiempo, de 0 a 1: la parte que ha pasado de su periodo
uniform float centro;         // lo que se le resta: el listado, 0; centrado, 0.5

in vec3 posicion, vNormal;
in vec2 coordTextura;
out vec3 normal;

// Listado 12.1.
vec3 lee(vec2 coordTextura) {
    // L12.1: los tres ruidos que hay en S1 por coordTextura más tiempo, menos centro, y todo por S2
    return (texture(ruido, coordTextura * S1 + tiempo).rgb - centro) * S2;
    // de partida: return vec3(0.0);
    // fin de L12.1
}

// Lo que cambian la superficie y el ruido con s y con t son dos tangentes de la superficie desplazada, y su producto
// vectorial, la normal.
void main() {
    vec3 valor = lee(coordTextura), nuevaPosicion = posicion + valor;

    vec2 ds = vec2(PASO, 0.0), dt = vec2(0.0, PASO);
    vec3 ruidoS = (lee(coordTextura + ds) - lee(coordTextura - ds)) / (2.0 * PASO);
    vec3 ruidoT = (lee(coordTextura + dt) - lee(coordTextura - dt)) / (2.0 * PASO);
    vec3 toroS = DOS_PI * vec3(-posicion.y, posicion.x, 0.0);
    vec3 toroT = DOS_PI * RADIO_TUBO * cross(vNormal, normalize(toroS));
    normal = normalize(cross(toroS + ruidoS, toroT + ruidoT));
    gl_Position = proyeccion * camara * M * vec4(nuevaPosicion, 1.0);
}
