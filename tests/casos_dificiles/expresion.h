// El valor de una expresión de GLSL, en la GPU y leído en float.
#pragma once
#include "ejecuta.h"
#include "sonda.h"

/// La expresión, de tipo float o vec3, puede ser de los vec3 `a` y `b`, de lo que hay en las texturas `imagen` y
/// `filtro`, en las unidades 0 y 1, y de lo que tienen phong.glsl y filtro.glsl.
inline glm::vec3 glsl(const std::string &expresion, const glm::vec3 &a, const glm::vec3 &b = glm::vec3(0)) {
    static std::map<std::string, GLuint> programas;
    GLuint &programa = programas[expresion];
    if (programa == 0) {
        const ConRaiz raiz(carpetaTemporal());
        std::ofstream(carpetaTemporal() / "expresion.frag")
            << "#version 140\n#include \"tests/casos_dificiles/expresion.glsl\"\nvoid main() {\n"
            << "    colorFragmento = vec4(vec3(" << expresion << "), 1.0);\n}\n";
        programa = creaSonda("expresion.frag");
    }
    glUseProgram(programa);
    // ninguna usa todos estos uniforms: los que no, son −1, que OpenGL ignora
    const auto donde = [&](const char *nombre) { return glGetUniformLocation(programa, nombre); };
    glUniform3fv(donde("a"), 1, glm::value_ptr(a));
    glUniform3fv(donde("b"), 1, glm::value_ptr(b));
    glUniform1i(donde("imagen"), 0);
    glUniform1i(donde("filtro"), 1);
    return glm::vec3(leeSonda());
}
