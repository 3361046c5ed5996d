#version 140
#include "ch05_iluminacion/phong.glsl"

uniform int cual;
uniform vec3 a, b;

out vec4 colorFragmento;

// Una luz en el origen y un punto en −z a distancia d.
float atenuada(vec3 coeficientes, float cosDelta, float exponente, vec3 P) {
    Luz luz = Luz(vec4(0.0, 0.0, 0.0, 1.0), vec3(1.0), vec3(1.0), coeficientes, vec3(0.0, 0.0, -1.0), cosDelta, exponente);
    return atenua(luz, unitario(-P), length(P));
}

void main() {
    vec3 r = vec3(0.0);
    if (cual == 0) r = vec3(potencia(a.x, a.y));
    else if (cual == 1) r = unitario(a);
    else if (cual == 2) r = vec3(pow(a.x, a.y));
    else if (cual == 3) r = normalize(a);
    else if (cual == 4) r = vec3(acos(a.x));
    else if (cual == 5) r = vec3(atan(a.x, a.y));
    else if (cual == 6) r = vec3(fract(a.x));
    else if (cual == 7) r = vec3(smoothstep(a.x, a.y, a.z));
    else if (cual == 8) r = vec3(dot(normalize(a), normalize(b)));
    else if (cual == 9) r = vec3(abs(sin(a.x)));
    else if (cual == 10) r = vec3(atenuada(a, -1.0, 0.0, vec3(0.0, 0.0, -b.x)));
    else if (cual == 11) r = vec3(atenuada(vec3(1.0, 0.0, 0.0), a.x, a.y, 3.0 * vec3(sin(a.z), 0.0, -cos(a.z))));
    else if (cual == 12) r = reflect(a, b);
    else if (cual == 13) r = vec3(0.0, sqrt(a.x), 1.0 / a.y);
    colorFragmento = vec4(r, 1.0);
}
