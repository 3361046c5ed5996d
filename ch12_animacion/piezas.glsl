// Lo común a las partículas de las figuras 12.1 y 12.2: si la pieza vive y su vaivén.
#include "ch08_texturas_avanzadas/ruido.glsl"

uniform float t; // segundos, de 0 a PERIODO_PIEZAS

in vec2 celda;    // columna y fila
in vec2 posicion; // esquina del cuadrado, de -1 a 1
in vec2 vida;     // instantes en que nace y en que muere

const float BROTE = 0.4; // segundos que tarda en crecer, y en menguar antes de morir

// De 0 (aún no ha nacido, o ya ha muerto) a 1.
float crecida() {
    return clamp(min(t - vida.x, vida.y - t) / BROTE, 0.0, 1.0);
}

// Ruido de -1 a 1 para la pieza: el instante es una de sus coordenadas, y así no lee siempre el mismo valor. Con
// periodo 20 en el tiempo, al volver a empezar no salta.
float vaiven(float cual) {
    return ruido(vec3(0.31 * celda + cual, 2.0 * t), ivec3(0, 0, 20));
}
