#version 140

// Los listados 5.1 y 5.3 al pie de la letra, para medir en qué se apartan del modelo que implementan.
uniform vec4 Ka, Kd, Ks, Lp, La, Ld, Ls;
uniform float alfa;
uniform vec3 P, N;

out vec4 colorFragmento;

vec4 phong(vec3 n, vec3 L, vec3 V) {
    float NdotL = dot(n, L);
    vec4 color = Ka * La;
    if (NdotL > 0.0) {
        vec3 R = normalize(2 * n * NdotL - L);
        float RdotV_n = pow(max(0.0, dot(R, V)), alfa);
        color = color + ((NdotL * (Ld * Kd)) + (RdotV_n * (Ls * Ks)));
    }
    return color;
}

void main() {
    vec4 ecPosition = vec4(P, 1.0);
    vec3 L = vec3(normalize(Lp - ecPosition));
    vec3 V = normalize(vec3(-ecPosition));
    colorFragmento = phong(N, L, V);
}
