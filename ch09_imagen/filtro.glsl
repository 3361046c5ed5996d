// Filtros de imagen (§9.2). La opacidad no se filtra: cada cual conserva la de su imagen.

// Ecuación 9.1, tal cual (una correlación: el filtro no se da la vuelta), en el texel de coordenadas `st`. `filtro` es
// una textura de m × n números. El paso de un texel al siguiente es 1/ancho; fuera de la imagen vale lo que diga su
// textura (GL_CLAMP_TO_EDGE: el borde). Con m par no hay texel central y (m - 1)/2 se redondea hacia abajo: el filtro
// abarca uno más a la derecha que a la izquierda, y lo mismo, con n, hacia arriba.
vec3 convoluciona(sampler2D imagen, vec2 st, sampler2D filtro) {
    vec3 suma = vec3(0.0);
    // E9.2: la suma, con filtro, de los m × n texeles que abarca; el central es el ((m − 1)/2, (n − 1)/2)
    ivec2 talla = textureSize(filtro, 0), centro = (talla - 1) / 2;
    vec2 paso = 1.0 / vec2(textureSize(imagen, 0));
    for (int j = 0; j < talla.y; j++)
        for (int i = 0; i < talla.x; i++)
            suma += texelFetch(filtro, ivec2(i, j), 0).r *
                    texture(imagen, st + vec2(ivec2(i, j) - centro) * paso).rgb;
    // de partida: suma = texture(imagen, st).rgb;
    // fin de E9.2
    return suma;
}

// Si el filtro suma 0 el resultado tiene signo: 0 es el gris 128, lo positivo es más claro y lo negativo más oscuro,
// hasta ±0.5. O se ve su valor absoluto.
vec3 muestraSigno(vec3 suma, bool conSigno) {
    return conSigno ? 128.0 / 255.0 + suma : abs(suma);
}
