// El modelo de iluminación de Phong (ecuaciones 5.1 a 5.7, listado 5.1) con los focos de §5.2. Lo incluye el
// shader que ilumina, y todo va en coordenadas de la cámara: el observador está en el origen. La phong(N, L, V) del
// libro es aquí phong(m, La, luz, P, N): las propiedades van en structs, L y V salen del punto P, R no se normaliza (lo
// es si N y L lo son) y se cuenta la atenuación. La difusa sigue la ley de Lambert (ecuación 5.2).

struct Material {
    vec3 Ka, Kd, Ks;
    float alfa;
};

struct Luz {
    vec4 Lp;         // w = 1: posición de la fuente; w = 0: dirección HACIA una fuente en el infinito
    vec3 Ld, Ls;
    vec3 atenuacion; // a, b, c de la ecuación 5.3; una luz direccional no se atenúa
    vec3 S;          // foco: hacia dónde apunta, unitaria
    float cosDelta;  // foco: coseno del ángulo del cono, de 0 a 90 grados; -1 si no es un foco
    float exponente; // foco: cuánto se concentra la luz alrededor del eje
};

// normalize(0) no está definido: sin normal, o con la fuente en el propio punto, no hay reflexión.
vec3 unitario(vec3 v) {
    float longitud = length(v);
    return longitud > 0.0 ? v / longitud : vec3(0.0);
}

// pow no está definida en 0 elevado a 0 ni con base negativa. Una base negativa cuenta como 0, y con y = 0 el
// resultado es siempre 1: un brillo o un foco sin concentrar.
float potencia(float x, float y) {
    if (y == 0.0)
        return 1.0;
    return x > 0.0 ? pow(x, y) : 0.0;
}

// Atenuación por la distancia d (ecuación 5.3) y por el cono del foco. L va hacia la luz y S sale de ella:
// el ángulo que se compara con delta es el del rayo que llega, -L, con S.
float atenua(Luz luz, vec3 L, float d) {
    float factor = 1.0;
    if (luz.Lp.w != 0.0) // acotada, para que 1/0 no dé infinitos cuando a = 0 y d = 0
        factor = 1.0 / max(luz.atenuacion.x + d * (luz.atenuacion.y + d * luz.atenuacion.z), 1e-6);
    if (luz.cosDelta > -1.0) {
        float cosRayo = dot(-L, luz.S);
        factor *= cosRayo < luz.cosDelta ? 0.0 : potencia(cosRayo, luz.exponente);
    }
    return factor;
}

// Lo que refleja de una fuente el punto P, de normal N: el sumando de la ecuación 5.7.
vec3 reflejada(Material m, Luz luz, vec3 P, vec3 N) {
    vec3 haciaLuz = luz.Lp.xyz - luz.Lp.w * P;
    vec3 L = unitario(haciaLuz), V = unitario(-P);
    N = unitario(N); // interpolada, ya no es unitaria
    vec3 suma = vec3(0.0);
    // L5.1: la suma de la difusa y la especular, sin atenuar; nada si la luz llega por detrás
    float NdotL = dot(N, L);
    if (NdotL > 0.0) {
        vec3 R = 2.0 * N * NdotL - L;
        float RdotV_n = potencia(dot(R, V), m.alfa);
        suma = NdotL * (luz.Ld * m.Kd) + RdotV_n * (luz.Ls * m.Ks);
    }
    // fin de L5.1
    return atenua(luz, L, length(haciaLuz)) * suma;
}

// Ecuación 5.6. Con varias fuentes (5.7) se suma una vez Ka·La y una vez cada `reflejada`.
vec3 phong(Material m, vec3 La, Luz luz, vec3 P, vec3 N) {
    return m.Ka * La + reflejada(m, luz, P, N);
}
