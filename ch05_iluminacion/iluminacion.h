// Materiales y fuentes de luz para los shaders que incluyen phong.glsl: los mismos campos, cómo se envían y cómo se
// dibuja un sólido iluminado.
#pragma once
#include "buferes.h"
#include "ch03_transformaciones/transformaciones.h"
#include "materiales.h"
#include "shader.h"
#include <string>

/// Una fuente de luz, en coordenadas del mundo. Por omisión es blanca, no se atenúa y no es un foco.
struct Luz {
    glm::vec4 Lp; // w = 1: posición; w = 0: dirección HACIA una fuente en el infinito
    glm::vec3 Ld = glm::vec3(1), Ls = glm::vec3(1);
    glm::vec3 atenuacion = glm::vec3(1, 0, 0); // a, b, c de la ecuación 5.3
    glm::vec3 S = glm::vec3(0, 0, -1);         // foco: hacia dónde apunta, unitaria
    float cosDelta = -1;                       // foco: coseno del ángulo del cono; -1 si no es un foco
    float exponente = 0;                       // foco: cuánto se concentra la luz alrededor del eje
};

/// El programa de un modelo de sombreado: «plano», «gouraud» o «phong».
inline GLuint creaSombreado(const std::string &modelo) {
    const std::string shaders = "ch05_iluminacion/sombreado_" + modelo;
    return creaPrograma(shaders + ".vert", shaders + ".frag");
}

/// Envía el uniform `material` del programa en uso.
inline void enviaMaterial(GLuint programa, const Material &m) {
    envia(programa, "material.Ka", m.Ka);
    envia(programa, "material.Kd", m.Kd);
    envia(programa, "material.Ks", m.Ks);
    envia(programa, "material.alfa", m.alfa);
}

/// Envía el uniform `nombre` («luz», «luces[2]») del programa en uso. phong.glsl ilumina en coordenadas de la
/// cámara, y a ellas se llevan aquí la posición y la dirección del foco.
inline void enviaLuz(GLuint programa, const std::string &nombre, const Luz &luz, const glm::mat4 &camara) {
    const auto campo = [&](const char *cual, const auto &valor) {
        envia(programa, (nombre + "." + cual).c_str(), valor);
    };
    campo("Lp", camara * luz.Lp);
    campo("Ld", luz.Ld);
    campo("Ls", luz.Ls);
    campo("atenuacion", luz.atenuacion);
    campo("S", glm::mat3(camara) * luz.S);
    campo("cosDelta", luz.cosDelta);
    campo("exponente", luz.exponente);
}

/// Pone en uso un programa de sombreado con esa vista y esa luz, y con luz ambiente blanca.
inline void usaIluminado(GLuint programa, const glm::mat4 &camara, const glm::mat4 &proyeccion,
                         const Luz &luz) {
    usaPrograma(programa, camara, proyeccion);
    envia(programa, "La", glm::vec3(1));
    // E5.1: la luz, como la quiere phong.glsl
    enviaLuz(programa, "luz", luz, camara);
    // de partida: (void)luz;
    // fin de E5.1
}

/// Dibuja el sólido de ese material con el programa en uso, que tiene ya `camara`, `proyeccion` y la luz.
inline void dibujaIluminado(GLuint programa, const Buferes &solido, const glm::mat4 &M,
                            const glm::mat4 &camara, const Material &material) {
    envia(programa, "M", M);
    // E5.1: la matriz de la normal, que va a coordenadas de la cámara, y el material
    envia(programa, "N", matrizNormal(camara * M));
    enviaMaterial(programa, material);
    // de partida: envia(programa, "N", glm::mat3(camara));
    // de partida: envia(programa, "material.Ka", material.Kd);
    // fin de E5.1
    dibujaMalla(solido);
}
