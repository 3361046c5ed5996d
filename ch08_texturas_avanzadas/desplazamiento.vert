#version 140

uniform mat4 M, camara, proyeccion;
uniform mat3 N;            // transformación de la normal a coordenadas de la cámara
uniform sampler2D alturas; // el mapa de desplazamiento
uniform float amplitud;
uniform float lado; // texeles de un lado del mapa: uno por vértice

in vec3 posicion, vNormal;
in vec2 coordTextura;
out vec3 ecPosicion, normal; // en coordenadas de la cámara
out float altura;            // la del mapa, de 0 a 1

// textureLod: un vertex shader no sabe cuánto abarca un píxel, y hay que decirle el nivel.
float lee(vec2 st) {
    return textureLod(alturas, (st * (lado - 1.0) + 0.5) / lado, 0.0).r;
}

// §8.5: cada vértice se desplaza en la dirección de su normal, y la normal se rehace con las alturas de sus vecinos:
// con la del plano, la isla se iluminaría como si fuera llana. El plano mide 1, como s y t, y su normal es +Z.
void main() {
    float paso = 1.0 / (lado - 1.0);
    altura = lee(coordTextura);
    vec2 antes = vec2(lee(coordTextura - vec2(paso, 0.0)), lee(coordTextura - vec2(0.0, paso)));
    vec2 despues = vec2(lee(coordTextura + vec2(paso, 0.0)), lee(coordTextura + vec2(0.0, paso)));
    vec2 pendiente = amplitud * (despues - antes) / (2.0 * paso);
    vec4 P = camara * M * vec4(posicion + amplitud * altura * vNormal, 1.0);
    ecPosicion = P.xyz;
    normal = normalize(N * vec3(-pendiente, 1.0));
    gl_Position = proyeccion * P;
}
