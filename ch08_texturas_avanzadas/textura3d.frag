#version 140
#include "ch05_iluminacion/phong.glsl"

uniform sampler3D ruido; // de 0 a 1
uniform float S1, S2;    // frecuencia y amplitud de la textura
uniform int elegido;     // 0 madera, 1 mármol, 2 el ruido tal cual
uniform vec3 La;
uniform Luz luz;

in vec3 coordVertice, ecPosicion, normal;
out vec4 colorFragmento;

// §8.3: con S2 = 0 el ruido no tuerce nada.
float lee(vec3 p) {
    // L8.4: el ruido en el punto p de la textura 3D, multiplicado por S2
    return texture(ruido, p).r * S2;
    // de partida: return 0.0;
    // fin de L8.4
}

// Anillos alrededor de un eje casi vertical: cada uno se oscurece poco a poco y acaba de golpe.
vec3 madera(vec3 p) {
    vec2 torcido = vec2(lee(0.4 * p), lee(0.4 * p + 0.5)) - 0.5 * S2;
    float r = 13.0 * length(p.xz + 0.08 * p.y + 0.22 * torcido + vec2(0.22, 0.10));
    float anillo = fract(r), tardia = anillo * anillo * (1.0 - smoothstep(0.86, 1.0, anillo));
    float hebras = texture(ruido, p * vec3(6.0, 0.35, 6.0)).r;
    return mix(vec3(0.87, 0.63, 0.37), vec3(0.48, 0.25, 0.11), clamp(1.15 * tardia + 0.9 * (hebras - 0.45), 0.0, 1.0));
}

// Vetas donde una onda plana, muy torcida por el ruido, pasa por cero.
vec3 marmol(vec3 p) {
    float torcido = lee(0.35 * p) + 0.4 * lee(0.9 * p + 0.3);
    float onda = abs(sin(5.0 * (p.x + 0.7 * p.y + 0.4 * p.z) + 6.0 * torcido));
    float nube = texture(ruido, 0.3 * p + 0.25).r, fuerza = texture(ruido, 0.7 * p + 0.6).r;
    vec3 fondo = mix(vec3(0.97, 0.96, 0.94), vec3(0.74, 0.77, 0.82), smoothstep(0.35, 0.75, nube));
    float veta = pow(max(1.0 - onda, 0.0), 3.0) * smoothstep(0.25, 0.65, fuerza);
    return mix(fondo, vec3(0.24, 0.28, 0.34), min(1.2 * veta, 1.0));
}

void main() {
    vec3 p = coordVertice * S1;
    vec3 color;
    if (elegido == 0)
        color = madera(p);
    else if (elegido == 1)
        color = marmol(p);
    else
        color = vec3(lee(p));
    float brillo = elegido == 1 ? 0.45 : 0.15;
    Material material = Material(0.35 * color, 0.75 * color, vec3(brillo), 40.0);
    colorFragmento = vec4(phong(material, La, luz, ecPosicion, normal), 1.0);
}
