// Ruido de gradiente (Perlin) en tres dimensiones. Las `noise` de GLSL dan 0 (§8.3): esta da lo mismo en todas
// partes, y lo mismo que ruido.h. Cada nodo de la rejilla de enteros tiene un gradiente que sale de un hash de sus
// coordenadas; en un punto se mezclan las ocho rampas de su celda con una quíntica (derivadas primera y segunda
// continuas).
//
// Vale 0 en los nodos y está entre −1.04 y 1.04. Una celda mide 1: a escala menor parece lisa. `periodo`, el de cada
// eje en celdas; 0, ninguno (se repite a las 2^32). La parte decimal de p es la que tenga un float: más allá de
// ±2^20 se ven escalones y desde ±2^23 todo son nodos, o sea 0. p debe ser finito, y periodo · 2^octavas, un int.

const uvec3 PRIMOS_RUIDO = uvec3(0x8da6b343u, 0xd8163841u, 0xcb1ab31fu);

// El gradiente de un nodo, de lo que aporta al hash cada una de sus coordenadas: la coordenada por su primo.
vec3 gradienteRuido(uvec3 n) {
    uint h = n.x ^ n.y ^ n.z;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    h ^= h >> 15;
    // del centro de un cubo al de una de sus doce aristas
    vec3 g = 1.0 - 2.0 * vec3(uvec3(h & 1u, (h >> 1) & 1u, (h >> 2) & 1u));
    int eje = int(((h >> 16) * 3u) >> 16);
    return vec3(eje == 0 ? 0.0 : g.x, eje == 1 ? 0.0 : g.y, eje == 2 ? 0.0 : g.z);
}

// i módulo n, de 0 a n − 1 aunque i sea negativo; i si no hay periodo.
int restoRuido(int i, int n) {
    if (n == 0)
        return i;
    return i >= 0 ? i % n : n - 1 - (-1 - i) % n;
}

ivec3 nodoRuido(ivec3 i, ivec3 periodo) {
    return ivec3(restoRuido(i.x, periodo.x), restoRuido(i.y, periodo.y), restoRuido(i.z, periodo.z));
}

// Gradiente (x, y, z) y valor (w) del ruido en p.
vec4 ruidoConGradiente(vec3 p, ivec3 periodo) {
    vec3 base = floor(p), f = p - base;
    ivec3 celda = ivec3(clamp(base, vec3(-1073741824.0), vec3(1073741824.0)));
    ivec3 nodo = nodoRuido(celda, periodo), siguiente = (nodo + 1) * ivec3(notEqual(nodo + 1, periodo));
    uvec3 primero = uvec3(nodo) * PRIMOS_RUIDO, ultimo = uvec3(siguiente) * PRIMOS_RUIDO;
    vec3 u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0), du = 30.0 * f * f * (f - 1.0) * (f - 1.0);
    vec4 suma = vec4(0.0);
    for (int i = 0; i < 8; ++i) {
        uvec3 esquina = uvec3(i & 1, (i >> 1) & 1, i >> 2);
        vec3 e = vec3(esquina), peso = mix(1.0 - u, u, e), dPeso = (2.0 * e - 1.0) * du;
        vec3 g = gradienteRuido(primero + esquina * (ultimo - primero));
        float rampa = dot(g, f - e), total = peso.x * peso.y * peso.z;
        vec3 dTotal = dPeso * vec3(peso.y * peso.z, peso.x * peso.z, peso.x * peso.y);
        suma += vec4(total * g + rampa * dTotal, total * rampa);
    }
    return suma;
}

float ruido(vec3 p, ivec3 periodo) {
    return ruidoConGradiente(p, periodo).w;
}

// Suma de `octavas` ruidos, cada uno del doble de frecuencia y la mitad de amplitud que el anterior. Los nodos de uno
// se corren respecto a los de otro: si no, en los enteros todos valdrían 0.
vec4 turbulenciaConGradiente(vec3 p, int octavas, ivec3 periodo) {
    vec4 suma = vec4(0.0);
    float frecuencia = 1.0;
    for (int i = 0; i < octavas; ++i) {
        vec4 r = ruidoConGradiente(p * frecuencia + vec3(5.375, 3.625, 7.75) * float(i), periodo << i);
        suma += vec4(r.xyz, r.w / frecuencia); // la derivada de ruido(f·p) / f es la del ruido en f·p
        frecuencia *= 2.0;
    }
    return suma;
}

float turbulencia(vec3 p, int octavas, ivec3 periodo) {
    return turbulenciaConGradiente(p, octavas, periodo).w;
}
