// Lo que puede usar una expresión de dificil_glsl_test.cpp.
#include "ch05_iluminacion/phong.glsl"

uniform vec3 a, b;

out vec4 colorFragmento;

// Una luz en el origen y un punto P.
float atenuada(vec3 coeficientes, float cosDelta, float exponente, vec3 P) {
    Luz luz = Luz(vec4(0.0, 0.0, 0.0, 1.0), vec3(1.0), vec3(1.0), coeficientes, vec3(0.0, 0.0, -1.0), cosDelta, exponente);
    return atenua(luz, unitario(-P), length(P));
}
