// Lo común a las partículas de las figuras 12.1 y 12.2: si la pieza vive y su vaivén.

uniform float t;         // segundos, de 0 a PERIODO_PIEZAS
uniform sampler2D ruido; // tres ruidos de 0 a 1, uno por canal

in vec2 celda;    // columna y fila
in vec2 posicion; // esquina del cuadrado, de -1 a 1
in vec2 vida;     // instantes en que nace y en que muere

const float BROTE = 0.4; // segundos que tarda en crecer, y en menguar antes de morir

// De 0 (aún no ha nacido, o ya ha muerto) a 1.
float crecida() {
    return clamp(min(t - vida.x, vida.y - t) / BROTE, 0.0, 1.0);
}

// Tres ruidos de -1 a 1 para la pieza (§12.3): el instante se suma a las coordenadas y así no lee siempre el mismo sitio
// de la textura, y el vaivén corre de pieza en pieza como el viento. En PERIODO_PIEZAS avanza cinco texturas enteras: al
// volver a empezar no salta.
vec3 vaiven() {
    return 2.0 * texture(ruido, 0.08 * celda + 0.5 * t).rgb - 1.0;
}
