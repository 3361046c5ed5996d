#version 140
#include "ch08_texturas_avanzadas/ruido.glsl"

// Las olas: frecuencia (celdas de ruido por unidad), altura, octavas y periodo del tiempo
const float FRECUENCIA = 0.55, ALTURA = 0.10;
const int OCTAVAS = 4, PERIODO = 64;
const vec3 HACIA_SOL = vec3(0.121905, 0.097504, -0.987741); // unitario

uniform mat3 base;      // lo que hay a la derecha, arriba y enfrente, en el mundo
uniform vec2 semitalla; // lo que se ve a los lados y en vertical, a distancia 1
uniform vec2 ventana;   // su tamaño, en píxeles
uniform vec3 ojo;
uniform float tiempo; // de 0 a PERIODO

out vec4 colorFragmento;

// Un anochecer y, contra él, unas colinas. d es unitario y no mira hacia abajo.
vec3 cielo(vec3 d) {
    float haciaSol = max(dot(d, HACIA_SOL), 0.0);
    vec3 color = mix(vec3(1.00, 0.62, 0.30), vec3(0.74, 0.42, 0.50), smoothstep(0.0, 0.22, d.y));
    color = mix(color, vec3(0.14, 0.20, 0.44), smoothstep(0.10, 0.65, d.y));
    color += vec3(1.0, 0.55, 0.20) * (0.45 * pow(haciaSol, 24.0) + 0.5 * pow(haciaSol, 400.0));
    color = mix(color, vec3(1.0, 0.95, 0.75), smoothstep(0.9990, 0.9993, haciaSol));
    if (d.y > 0.19) // más alto que ninguna colina
        return color;
    vec3 horizonte = normalize(vec3(d.x, 1e-6, d.z));
    float cumbre = 0.055 + 0.07 * turbulencia(vec3(3.0 * horizonte.xz, 0.5), 3, ivec3(0));
    vec3 colina = mix(vec3(0.42, 0.26, 0.30), vec3(0.13, 0.11, 0.20), smoothstep(0.0, 0.09, d.y));
    return mix(colina, color, smoothstep(-0.002, 0.002, d.y - cumbre));
}

void main() {
    // del centro del píxel, que es exacto: interpolada, la dirección se redondea, y las olas lejanas lo notan
    vec3 d = normalize(base * vec3(semitalla * (2.0 * gl_FragCoord.xy / ventana - 1.0), 1.0));
    vec3 R = d, agua = vec3(0.0), brillo = vec3(0.0);
    float fresnel = 1.0;
    if (d.y < 0.0) {
        // Donde este rayo corta al plano y = 0, la superficie es y = ALTURA · turbulencia, y su normal (−∂y/∂x, 1,
        // −∂y/∂z). Lejos, las olas son más pequeñas que un píxel: se alisan.
        float lejos = -ojo.y / d.y;
        vec2 P = ojo.xz + lejos * d.xz;
        vec4 ola = turbulenciaConGradiente(vec3(FRECUENCIA * P, tiempo), OCTAVAS, ivec3(0, 0, PERIODO));
        vec2 pendiente = ALTURA * FRECUENCIA * ola.xy / (1.0 + 0.0012 * lejos * lejos);
        vec3 N = normalize(vec3(-pendiente.x, 1.0, -pendiente.y));

        // Lo que refleja depende del ángulo (Fresnel, según Schlick); lo demás es el color del agua.
        R = reflect(d, N);
        // cuanto más baja el rayo reflejado de lo que iría en agua llana, más probable es que dé en otra ola: agua
        float alCielo = smoothstep(-0.3, -0.1, R.y + d.y);
        R.y = max(R.y, 0.0);
        float cosV = clamp(-dot(d, N), 0.0, 1.0);
        fresnel = alCielo * (0.02 + 0.98 * pow(1.0 - cosV, 5.0));
        agua = mix(vec3(0.02, 0.10, 0.16), vec3(0.05, 0.24, 0.28), clamp(0.5 + ola.w, 0.0, 1.0));
        brillo = alCielo * 0.8 * vec3(1.0, 0.75, 0.45) * pow(max(dot(R, HACIA_SOL), 0.0), 300.0);
    }
    colorFragmento = vec4(mix(agua, cielo(R), fresnel) + brillo, 1.0); // el cielo, una sola vez: es lo que más cuesta
}
