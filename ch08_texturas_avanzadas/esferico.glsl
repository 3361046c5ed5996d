// Las coordenadas esféricas de una dirección, de 0 a 1: la longitud, desde −Z hacia +X con medio en −Z, y la latitud.
vec2 enEsfera(vec3 R) {
    const float PI = 3.14159265;
    return vec2(atan(R.x, -R.z + 1e-6) / (2.0 * PI), asin(clamp(normalize(R).y, -1.0, 1.0)) / PI) + 0.5;
}
