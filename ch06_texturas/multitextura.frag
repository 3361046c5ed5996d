#version 140

uniform sampler2D ladrillo, musgo, mascara, luz; // cada uno, en su unidad de textura
uniform bool conMusgo, conLuz;

in vec2 coordMaterial, coordPared; // las de lo que se repite y las de toda la pared
out vec4 colorFragmento;

void main() {
    vec3 color = texture(ladrillo, coordMaterial).rgb;
    if (conMusgo)
        color = mix(color, texture(musgo, coordMaterial).rgb, texture(mascara, coordPared).r);
    if (conLuz)
        color *= texture(luz, coordPared).rgb;
    colorFragmento = vec4(color, 1.0);
}
