// La luz de los programas anteriores al modelo de iluminación (capítulo 5): una dirección y un mínimo, lo justo para
// que se vean las formas. La dirección hacia la luz es unitaria y está en coordenadas del mundo.
const vec3 HACIA_LUZ_FIJA = vec3(0.20, 0.78, 0.593);

float luzFija(vec3 normal) {
    return 0.58 + 0.42 * dot(normal, HACIA_LUZ_FIJA);
}
