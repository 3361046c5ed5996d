#version 140

// Sistema de partículas sin estado (§12.3): la posición y el aspecto de cada una salen de su número y del tiempo. No
// hay nada que actualizar en la CPU, ni buffer object: sus atributos son un hash de gl_VertexID.
uniform mat4 camara, proyeccion;
uniform int elegido;   // 0 fuente, 1 humo, 2 fuego
uniform float vida;    // segundos que vive cada una; al morir vuelve a nacer igual
uniform float tau;     // qué parte de ese tiempo ha pasado, de 0 a 1
uniform int grupos;    // chorros, bocanadas o lenguas: las partículas de un grupo van juntas
uniform float talla;   // píxeles que mide un objeto de lado 1 a distancia 1
uniform float escala;  // de las partículas: cuantas más, menores

out vec4 color;

const float DOS_PI = 6.2831853;

float azar(uint n) { // de 0 a 1
    n = (n ^ (n >> 16)) * 0x7feb352du;
    n = (n ^ (n >> 15)) * 0x846ca68bu;
    n = n ^ (n >> 16);
    return float(n >> 8) / 16777216.0;
}

vec2 giro(float vueltas) {
    return vec2(cos(DOS_PI * vueltas), sin(DOS_PI * vueltas));
}

void main() {
    uint id = uint(gl_VertexID), grupo = id % uint(grupos);
    // las bocanadas nacen enteras; lo demás, cada partícula en su momento
    float edad = fract(tau + azar(elegido == 1 ? grupo : id)), s = edad * vida;
    uint semilla = 4u * id + 0x9e3779b9u;
    float a = azar(semilla), b = azar(semilla + 1u), c = azar(semilla + 2u);

    vec3 P;
    float diametro;
    if (elegido == 0) { // tiro parabólico: chorros altos y bajos, por turnos, y en medio, el mayor, que acaba en punta
        bool medio = grupo == 0u, alto = grupo % 2u == 0u;
        float lejos = (alto ? 0.60 : 1.05) + 0.14 * b, v = (alto ? 4.9 : 3.7) + 0.35 * c;
        float vuelta = (float(grupo) + 0.16 * a) / float(grupos - 1);
        if (medio) {
            lejos = 0.30 * sqrt(b) * (1.0 - c);
            v = 5.6 + 1.0 * c;
            vuelta = a;
        }
        vec2 lado = lejos * giro(vuelta);
        P = vec3(lado.x * s, v * s - 2.5 * s * s, lado.y * s);
        diametro = 0.07;
        color = vec4(mix(vec3(0.20, 0.50, 0.95), vec3(0.85, 0.95, 1.0), c), 0.4);
    } else if (elegido == 1) { // cada bocanada sube, se hincha y rueda; el viento se la lleva
        float radio = pow(b, 0.33), alto = 2.0 * c - 1.0;
        vec3 n = vec3(sqrt(1.0 - alto * alto) * giro(a + 0.5 * edad), alto);
        vec2 sale = sqrt(azar(grupo + 100u)) * giro(azar(grupo + 200u));
        P = (0.20 + 0.85 * edad) * radio * n;
        P += vec3(sale.x * edad + 0.09 * s * s, 0.93 * s + 0.12, sale.y * edad);
        diametro = 0.15 + 0.24 * edad;
        float luz = 0.5 + 0.5 * radio * dot(n, vec3(-0.49, 0.78, 0.39)); // la bocanada, clara por donde le da
        color = vec4(mix(vec3(0.16, 0.17, 0.21), vec3(0.98, 0.96, 0.92), luz), 0.20 * (1.0 - edad) * min(8.0 * edad, 1.0));
    } else { // cada lengua sube, se estrecha y se mece a su aire; de blanco amarillo a rojo
        bool medio = grupo == 0u;
        float llega = medio ? 1.0 : 0.45 + 0.4 * azar(grupo), fase = azar(grupo + 50u);
        float mece = sin(DOS_PI * (edad - tau + fase)) + 0.5 * sin(DOS_PI * (2.3 * edad - 3.0 * tau + 3.0 * fase));
        vec2 base = (medio ? 0.0 : 0.75 * (1.0 - 0.8 * edad)) * giro(float(grupo) / float(grupos - 1));
        vec2 r = 0.5 * sqrt(b) * (1.0 - edad) * (0.7 + 2.0 * edad) * giro(a);
        P = vec3(base.x + r.x + 0.28 * edad * mece, 4.8 * llega * edad * (0.7 + 0.3 * c), base.y + r.y);
        diametro = 0.26 * (1.0 - 0.7 * edad);
        color = vec4(mix(vec3(1.0, 0.62, 0.18), vec3(0.85, 0.10, 0.02), edad), 0.11 * (1.0 - edad * edad));
    }
    gl_Position = P.y < 0.0 ? vec4(2.0, 2.0, 2.0, 1.0) // ya ha caído: fuera de la vista
                            : proyeccion * camara * vec4(P, 1.0);
    float mide = talla * diametro * escala / gl_Position.w; // en píxeles
    gl_PointSize = max(mide, 1.0);
    color.a *= min(mide * mide, 1.0); // la que no llega a un píxel lo pinta solo en parte
}
