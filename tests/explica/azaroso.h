// Da a un fragment shader cualquiera todo lo que pide, al azar: el vertex shader de sus `in`, uniforms y texturas.
#pragma once
#include "prueba.h"
#include <GL/glew.h>
#include <cctype>

namespace azaroso {

/// De 0 a 1, siempre el mismo para el mismo nombre y la misma semilla.
inline double numero(const std::string &nombre, int semilla, int cual = 0) {
    std::uint32_t h = 2166136261u;
    for (const char c : nombre + "/" + std::to_string(semilla) + "/" + std::to_string(cual))
        h = (h ^ std::uint8_t(c)) * 16777619u;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    return (h >> 8) / double(1 << 24);
}

/// Un vertex shader que cubre la ventana y da, distinto en cada vértice, cada `in` de ese fragment shader.
inline std::string vertex(const std::string &frag, int semilla) {
    static const std::regex ENTRADA(
        R"((?:^|[;\n\r])[ \t]*((?:flat |smooth |centroid |noperspective )*)in\s+(\w+)\s+([^;(){}]+);)");
    std::string declara, da;
    const std::string sinComentarios = std::regex_replace(frag, std::regex("//[^\n]*"), "");
    std::string resto = sinComentarios;
    for (std::smatch m; std::regex_search(resto, m, ENTRADA);) {
        const std::string tipo = m[2];
        declara += m.str(1) + "out " + tipo + " " + m.str(3) + ";\n";
        std::istringstream nombres(m.str(3));
        for (std::string nombre; std::getline(nombres, nombre, ',');) {
            nombre = std::regex_replace(nombre, std::regex("\\s"), "");
            const int n = std::isdigit(tipo.back()) ? tipo.back() - '0' : 1;
            da += nombre + " = " + tipo + "(";
            for (int k = 0; k < n; ++k) {
                const std::string v = "azar(" + std::to_string(numero(nombre, semilla, k)) + ")";
                da +=
                    (k ? ", " : "") + (tipo.find("vec") == 0 || tipo == "float" ? v : "int(4.0 * " + v + ")");
            }
            da += ");\n";
        }
        resto = ";" + m.suffix().str(); // el ; que acaba una puede ser el que va delante de la siguiente
    }
    return "#version 140\n" + declara +
           "float azar(float k) { return fract(sin(k * 91.7 + float(gl_VertexID) * 3.1) * 437.58) * 4.0 - "
           "2.0; }\n"
           "void main() {\n" +
           da + "gl_Position = vec4(4 * (gl_VertexID % 2) - 1, 4 * (gl_VertexID / 2) - 1, 0.0, 1.0);\n}\n";
}

/// Una textura de 4 en cada dimensión, con lo que sea, en esa unidad.
inline void textura(GLenum tipo, int unidad) {
    static std::map<GLenum, GLuint> hechas;
    const bool enteros = tipo == GL_UNSIGNED_INT_SAMPLER_2D, sombra = tipo == GL_SAMPLER_2D_SHADOW;
    const GLenum donde = tipo == GL_SAMPLER_3D     ? GL_TEXTURE_3D
                         : tipo == GL_SAMPLER_CUBE ? GL_TEXTURE_CUBE_MAP
                                                   : GL_TEXTURE_2D;
    glActiveTexture(GL_TEXTURE0 + unidad);
    GLuint &t = hechas[tipo];
    if (t != 0)
        return glBindTexture(donde, t);
    glGenTextures(1, &t);
    glBindTexture(donde, t);
    std::vector<std::uint32_t> datos(64);
    for (std::size_t k = 0; k < datos.size(); ++k)
        datos[k] = std::uint32_t(4294967295.0 * numero("textura", int(k)));
    const GLenum filtro = enteros ? GL_NEAREST : GL_LINEAR;
    glTexParameteri(donde, GL_TEXTURE_MIN_FILTER, filtro);
    glTexParameteri(donde, GL_TEXTURE_MAG_FILTER, filtro);
    if (donde == GL_TEXTURE_3D)
        glTexImage3D(donde, 0, GL_RGBA8, 4, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, datos.data());
    else if (enteros)
        glTexImage2D(donde, 0, GL_R32UI, 4, 4, 0, GL_RED_INTEGER, GL_UNSIGNED_INT, datos.data());
    else if (sombra)
        glTexImage2D(donde, 0, GL_DEPTH_COMPONENT24, 4, 4, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                     datos.data());
    else
        for (int cara = 0; cara < (donde == GL_TEXTURE_CUBE_MAP ? 6 : 1); ++cara)
            glTexImage2D(donde == GL_TEXTURE_CUBE_MAP ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + cara : donde, 0,
                         GL_RGBA8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, datos.data() + 8 * cara);
    if (sombra)
        glTexParameteri(donde, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
}

/// Un valor a un uniform, por su nombre.
inline void uniform(GLuint programa, const std::string &nombre, GLenum tipo, int semilla, int &unidad) {
    const GLint donde = glGetUniformLocation(programa, nombre.c_str());
    float f[16];
    int e[4];
    for (int k = 0; k < 16; ++k)
        f[k] = float(3 * numero(nombre, semilla, k) - 1);
    for (int k = 0; k < 4; ++k)
        e[k] = int(4 * numero(nombre, semilla, k));
    const int b[] = {e[0] & 1, e[1] & 1};
    switch (tipo) {
    case GL_FLOAT: return glUniform1fv(donde, 1, f);
    case GL_FLOAT_VEC2: return glUniform2fv(donde, 1, f);
    case GL_FLOAT_VEC3: return glUniform3fv(donde, 1, f);
    case GL_FLOAT_VEC4: return glUniform4fv(donde, 1, f);
    case GL_FLOAT_MAT2: return glUniformMatrix2fv(donde, 1, GL_FALSE, f);
    case GL_FLOAT_MAT3: return glUniformMatrix3fv(donde, 1, GL_FALSE, f);
    case GL_FLOAT_MAT4: return glUniformMatrix4fv(donde, 1, GL_FALSE, f);
    case GL_INT: return glUniform1iv(donde, 1, e);
    case GL_INT_VEC2: return glUniform2iv(donde, 1, e);
    case GL_INT_VEC3: return glUniform3iv(donde, 1, e);
    case GL_BOOL: return glUniform1iv(donde, 1, b);
    case GL_BOOL_VEC2: return glUniform2iv(donde, 1, b);
    default: textura(tipo, unidad); glUniform1i(donde, unidad++);
    }
}

/// A todos los del programa, que se pone en uso.
inline void uniforms(GLuint programa, int semilla) {
    glUseProgram(programa);
    GLint cuantos = 0, bloques = 0;
    glGetProgramiv(programa, GL_ACTIVE_UNIFORMS, &cuantos);
    int unidad = 0;
    for (GLuint k = 0; k < GLuint(cuantos); ++k) {
        char nombre[200];
        GLint n = 0;
        GLenum tipo = 0;
        glGetActiveUniform(programa, k, sizeof nombre, nullptr, &n, &tipo, nombre);
        const std::string base = std::regex_replace(std::string(nombre), std::regex("\\[0\\]$"), "");
        for (int j = 0; j < n; ++j)
            if (base.compare(0, 8, "explica_") != 0)
                uniform(programa, n > 1 ? base + "[" + std::to_string(j) + "]" : nombre, tipo, semilla,
                        unidad);
    }
    static GLuint bufer = 0; // el de todos los bloques
    if (bufer == 0) {
        glGenBuffers(1, &bufer);
        glBindBuffer(GL_UNIFORM_BUFFER, bufer);
        std::vector<float> datos(256);
        for (int k = 0; k < 256; ++k)
            datos[k] = float(numero("bloque", k));
        glBufferData(GL_UNIFORM_BUFFER, 1024, datos.data(), GL_STATIC_DRAW);
    }
    glGetProgramiv(programa, GL_ACTIVE_UNIFORM_BLOCKS, &bloques);
    for (GLuint k = 0; k < GLuint(bloques); ++k) {
        glUniformBlockBinding(programa, k, k);
        glBindBufferBase(GL_UNIFORM_BUFFER, k, bufer);
    }
}

} // namespace azaroso
