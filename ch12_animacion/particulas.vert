#version 140

// Sistema de partículas sin estado (§12.3): la posición y el aspecto de cada una salen de su número y del tiempo. No hay
// nada que actualizar en la CPU, ni buffer object: sus atributos son un hash de gl_VertexID.
uniform mat4 camara, proyeccion;
uniform int elegido;   // 0 fuente, 1 humo, 2 fuego
uniform float tau;     // qué parte de PERIODO ha pasado, de 0 a 1
uniform float periodo; // segundos
uniform int vidas;     // las de cada partícula en un periodo
uniform float talla;   // píxeles que mide un objeto de lado 1 a distancia 1
uniform float escala;  // de las partículas: cuantas más, menores
uniform float opacidad;

out vec4 color;

const float DOS_PI = 6.2831853;

float azar(uint n) { // de 0 a 1
    n = (n ^ (n >> 16)) * 0x7feb352du;
    n = (n ^ (n >> 15)) * 0x846ca68bu;
    n = n ^ (n >> 16);
    return float(n >> 8) / 16777216.0;
}

void main() {
    uint id = uint(gl_VertexID);
    float x = tau * float(vidas) + azar(id); // cada una nació en un momento distinto
    float edad = fract(x), s = edad * periodo / float(vidas);
    uint semilla = (id * 8u + uint(x) % uint(vidas)) * 4u + 0x9e3779b9u; // en cada vida, otra
    float a = azar(semilla), b = azar(semilla + 1u), c = azar(semilla + 2u);
    vec2 giro = vec2(cos(DOS_PI * a), sin(DOS_PI * a));

    vec3 P;
    float diametro;
    if (elegido == 0) { // tiro parabólico
        vec2 v = (0.2 + 0.65 * sqrt(b)) * giro;
        P = vec3(v.x * s, (5.5 + 1.3 * c) * s - 2.5 * s * s, v.y * s);
        diametro = 0.055;
        color = vec4(mix(vec3(0.25, 0.55, 0.95), vec3(0.9, 0.97, 1.0), c), 0.35);
    } else if (elegido == 1) { // sube, se ensancha y se lo lleva el viento
        float r = (0.15 + 0.75 * edad) * sqrt(b);
        P = vec3(r * giro.x + 0.06 * s * s, 0.72 * s + 0.25 * c, r * giro.y);
        P.x += 0.22 * edad * sin(1.7 * P.y + DOS_PI * tau);
        diametro = 0.10 + 0.30 * edad;
        color = vec4(vec3(0.35 + 0.55 * c), 0.22 * (1.0 - edad) * min(8.0 * edad, 1.0));
    } else { // sube y se estrecha; de blanco amarillo a rojo
        float r = sqrt(b) * (1.0 - edad) * (0.8 + 1.8 * edad);
        P = vec3(r * giro.x, 5.5 * edad * (0.4 + 0.6 * c) * (1.0 - 0.5 * b), r * giro.y);
        P.x += 0.25 * edad * sin(3.0 * P.y - 4.0 * DOS_PI * tau);
        diametro = 0.22 * (1.0 - 0.6 * edad);
        color = vec4(mix(vec3(1.0, 0.75, 0.25), vec3(0.85, 0.12, 0.02), sqrt(edad)), 0.14 * (1.0 - edad));
    }
    color.a *= opacidad;
    gl_Position = P.y < 0.0 ? vec4(2.0, 2.0, 2.0, 1.0) // ya ha caído: fuera de la vista
                            : proyeccion * camara * vec4(P, 1.0);
    gl_PointSize = max(talla * diametro * escala / gl_Position.w, 1.0);
}
