// Materiales y fuentes de luz para los shaders que incluyen phong.glsl: los mismos campos, y cómo se envían.
#pragma once
#include "materiales.h"
#include "shader.h"
#include <glm/gtc/type_ptr.hpp>
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

/// Envía el uniform `material` del programa en uso.
inline void enviaMaterial(GLuint programa, const Material &m) {
    envia(programa, "material.Ka", m.Ka);
    envia(programa, "material.Kd", m.Kd);
    envia(programa, "material.Ks", m.Ks);
    envia(programa, "material.alfa", m.alfa);
}

/// Envía el uniform `nombre` («luz», «luces[2]») del programa en uso. phong.glsl ilumina en coordenadas de la
/// cámara, y a ellas se llevan aquí la posición y la dirección del foco.
inline void enviaLuz(GLuint programa, const std::string &nombre, const Luz &luz, const glm::mat4 &vista) {
    const auto campo = [&](const char *cual) { return uniforme(programa, (nombre + "." + cual).c_str()); };
    const glm::vec4 Lp = vista * luz.Lp;
    const glm::vec3 S = glm::mat3(vista) * luz.S;
    glUniform4fv(campo("Lp"), 1, glm::value_ptr(Lp));
    glUniform3fv(campo("Ld"), 1, glm::value_ptr(luz.Ld));
    glUniform3fv(campo("Ls"), 1, glm::value_ptr(luz.Ls));
    glUniform3fv(campo("atenuacion"), 1, glm::value_ptr(luz.atenuacion));
    glUniform3fv(campo("S"), 1, glm::value_ptr(S));
    glUniform1f(campo("cosDelta"), luz.cosDelta);
    glUniform1f(campo("exponente"), luz.exponente);
}
