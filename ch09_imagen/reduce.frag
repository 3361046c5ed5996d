#version 140

uniform sampler2D imagen;
uniform int veces; // cada píxel es la media de veces × veces texeles

out vec4 colorFragmento;

void main() {
    ivec2 esquina = ivec2(gl_FragCoord.xy) * veces;
    vec4 suma = vec4(0.0);
    for (int j = 0; j < veces; j++)
        for (int i = 0; i < veces; i++)
            suma += texelFetch(imagen, esquina + ivec2(i, j), 0);
    colorFragmento = suma / float(veces * veces);
}
