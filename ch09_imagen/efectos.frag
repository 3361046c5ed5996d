#version 140

uniform sampler2D imagen;
uniform int elegido;
uniform float alfa; // brillo

in vec2 coordenadaTextura;
out vec4 colorFragmento;

// Listado 9.1 y siguientes, sobre R, G y B: el libro multiplica o resta también la opacidad, y el negativo de una
// imagen opaca sería transparente.
void main() {
    vec4 color = texture(imagen, coordenadaTextura);
    // L9.1: según elegido (la tecla 2 elige el 1): 1, por alfa; 2, negativo; 3, media; 4, 0.2126·R + 0.7152·G + 0.0722·B
    if (elegido == 1)
        color.rgb *= alfa;
    else if (elegido == 2)
        color.rgb = 1.0 - color.rgb;
    else if (elegido == 3)
        color.rgb = vec3((color.r + color.g + color.b) / 3.0);
    else if (elegido == 4)
        color.rgb = vec3(dot(color.rgb, vec3(0.2126, 0.7152, 0.0722))); // luminancia, ITU-R BT.709
    // fin de L9.1
    colorFragmento = color;
}
