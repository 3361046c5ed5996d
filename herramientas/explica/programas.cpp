#include "programas.h"
#include "enviado.h"
#include "nombres.h"
#include "tipos.h"
#include <algorithm>
#include <cctype>
#include <map>

namespace explica {

std::vector<Fuente> fuentesDe(GLuint programa) {
    std::vector<Fuente> fuentes;
    GLuint shaders[8];
    GLsizei n = 0;
    if (programa)
        glGetAttachedShaders(programa, 8, &n, shaders);
    for (GLsizei i = 0; i < n; ++i) {
        const GLint tipo = contesta(glGetShaderiv, shaders[i], GL_SHADER_TYPE);
        const GLint largo =
            4 * contesta(glGetShaderiv, shaders[i], GL_SHADER_SOURCE_LENGTH); // Emscripten da letras
        GLsizei escritos = 0;
        std::string texto(std::size_t(largo), '\0');
        glGetShaderSource(shaders[i], largo, &escritos, texto.data());
        texto.resize(std::size_t(escritos));
        fuentes.push_back({GLenum(tipo), shaders[i], texto});
    }
    return fuentes;
}

std::vector<GLuint> shadersDe(GLuint programa) {
    std::vector<GLuint> shaders;
    for (const Fuente &f : fuentesDe(programa))
        shaders.push_back(f.shader);
    return shaders;
}

std::string fuenteDe(GLuint programa, GLenum tipo) {
    std::string texto;
    for (const Fuente &f : fuentesDe(programa))
        texto += f.tipo == tipo ? f.texto : "";
    return texto;
}

GLuint compila(GLenum tipo, const std::string &fuente) {
    const GLuint shader = glCreateShader(tipo);
    const GLchar *const texto = fuente.c_str();
    glShaderSource(shader, 1, &texto, nullptr);
    glCompileShader(shader);
    if (contesta(glGetShaderiv, shader, GL_COMPILE_STATUS))
        return shader;
    glDeleteShader(shader);
    return 0;
}

bool nombra(const std::string &texto, const std::string &palabra) {
    const auto sigue = [&](std::size_t i) {
        return i < texto.size() && (std::isalnum(static_cast<unsigned char>(texto[i])) || texto[i] == '_');
    };
    for (std::size_t i = texto.find(palabra); i != texto.npos; i = texto.find(palabra, i + 1))
        if (!sigue(i - 1) && !sigue(i + palabra.size())) // antes del primero, i - 1 es más que lo que mide
            return true;
    return false;
}

std::vector<Variable> uniformsDe(GLuint programa) {
    std::vector<Variable> variables;
    for (GLint i = 0; i < contesta(glGetProgramiv, programa, GL_ACTIVE_UNIFORMS); ++i) {
        GLchar nombre[256];
        GLint elementos = 0;
        GLenum tipo = 0;
        glGetActiveUniform(programa, GLuint(i), sizeof nombre, nullptr, &elementos, &tipo, nombre);
        std::string base = nombre;
        const bool lista = base.size() > 3 && base.compare(base.size() - 3, 3, "[0]") == 0;
        if (lista)
            base.resize(base.size() - 3);
        for (GLint e = 0; e < elementos; ++e) {
            const std::string entero = lista ? base + "[" + std::to_string(e) + "]" : base;
            const GLint donde = glGetUniformLocation(programa, entero.c_str());
            if (donde >= 0) // si no, está en un bloque
                variables.push_back({entero, tipo, donde});
        }
    }
    return variables;
}

std::vector<Variable> atributosDe(GLuint programa) {
    std::vector<Variable> variables;
    for (GLint i = 0; i < contesta(glGetProgramiv, programa, GL_ACTIVE_ATTRIBUTES); ++i) {
        GLchar nombre[256];
        GLint elementos = 0;
        GLenum tipo = 0;
        glGetActiveAttrib(programa, GLuint(i), sizeof nombre, nullptr, &elementos, &tipo, nombre);
        const GLint donde = glGetAttribLocation(programa, nombre);
        if (donde >= 0) // si no, es gl_VertexID
            variables.push_back({nombre, tipo, donde});
    }
    return variables;
}

std::vector<Bloque> bloquesDe(GLuint programa) {
    std::vector<Bloque> bloques;
    for (GLint i = 0; i < contesta(glGetProgramiv, programa, GL_ACTIVE_UNIFORM_BLOCKS); ++i) {
        GLchar nombre[256];
        GLint enlace = 0;
        glGetActiveUniformBlockName(programa, GLuint(i), sizeof nombre, nullptr, nombre);
        glGetActiveUniformBlockiv(programa, GLuint(i), GL_UNIFORM_BLOCK_BINDING, &enlace);
        bloques.push_back({nombre, GLuint(enlace)});
    }
    return bloques;
}

namespace {

union Valor {
    GLfloat real[16];
    GLint entero[16];
    GLuint natural[16];
};

void lee(GLuint programa, const Variable &v, Valor &valor) {
    if (esEntero(v.tipo))
        glGetUniformiv(programa, v.donde, valor.entero);
    else
        glGetUniformfv(programa, v.donde, valor.real);
}

void da(GLint donde, GLenum tipo, const Valor &valor) {
    using Enteros = decltype(&glUniform1iv);
    using Reales = decltype(&glUniform1fv);
    using Matrices = decltype(&glUniformMatrix2fv);
    const Enteros DE_ENTEROS[] = {glUniform1iv, glUniform2iv, glUniform3iv, glUniform4iv};
    const decltype(&glUniform1uiv) DE_NATURALES[] = {glUniform1uiv, glUniform2uiv, glUniform3uiv,
                                                     glUniform4uiv};
    const Reales DE_REALES[] = {glUniform1fv, glUniform2fv, glUniform3fv, glUniform4fv};
    const Matrices DE_MATRICES[][3] = {{glUniformMatrix2fv, glUniformMatrix2x3fv, glUniformMatrix2x4fv},
                                       {glUniformMatrix3x2fv, glUniformMatrix3fv, glUniformMatrix3x4fv},
                                       {glUniformMatrix4x2fv, glUniformMatrix4x3fv, glUniformMatrix4fv}};
    const Forma f = forma(tipoDe(tipo));
    if (f.columnas > 1)
        DE_MATRICES[f.columnas - 2][f.filas - 2](donde, 1, GL_FALSE, valor.real);
    else if (f.escalar == "float")
        DE_REALES[f.filas - 1](donde, 1, valor.real);
    else if (f.escalar == "uint")
        DE_NATURALES[f.filas - 1](donde, 1, valor.natural);
    else // int, bool y los sampler
        DE_ENTEROS[f.filas - 1](donde, 1, valor.entero);
}

} // namespace

int componentesDe(GLenum tipo) {
    const Forma f = forma(tipoDe(tipo));
    return f.columnas * f.filas;
}

bool esEntero(GLenum tipo) {
    return forma(tipoDe(tipo)).escalar != "float";
}

void daOtroValor(const Variable &uniform) {
    Valor valor{};
    for (int i = 0; i < 16; ++i)
        if (esEntero(uniform.tipo))
            valor.entero[i] = 1 + i;
        else
            valor.real[i] = 0.3f + 0.17f * float((5 * i) % 16);
    da(uniform.donde, uniform.tipo, valor);
}

std::vector<double> valorDe(GLuint programa, const Variable &uniform) {
    Valor valor{};
    lee(programa, uniform, valor);
    std::vector<double> numeros;
    for (int i = 0; i < componentesDe(uniform.tipo); ++i)
        numeros.push_back(esEntero(uniform.tipo) ? valor.entero[i] : double(valor.real[i]));
    return numeros;
}

Desconocidas copiaUniforms(GLuint original, GLuint otro) {
    const std::vector<Variable> uniforms = uniformsDe(original);
    std::vector<Valor> valores(uniforms.size());
    glUseProgram(original); // Emscripten solo los lee del que está en uso
    for (std::size_t i = 0; i < uniforms.size(); ++i)
        lee(original, uniforms[i], valores[i]);
    glUseProgram(otro);
    for (std::size_t i = 0; i < uniforms.size(); ++i)
        if (const GLint donde = glGetUniformLocation(otro, uniforms[i].nombre.c_str()); donde >= 0)
            da(donde, uniforms[i].tipo, valores[i]);
    for (const Bloque &bloque : bloquesDe(original)) {
        const GLuint suyo = glGetUniformBlockIndex(otro, bloque.nombre.c_str());
        if (suyo != GL_INVALID_INDEX)
            glUniformBlockBinding(otro, suyo, bloque.enlace);
    }
    return daLoEnviado(original, otro);
}

GLuint enlazaComo(GLuint original, const std::vector<GLuint> &shaders,
                  const std::function<void(GLuint)> &antes) {
    const GLuint programa = glCreateProgram();
    for (const GLuint shader : shaders)
        glAttachShader(programa, shader);
    antes(programa);
    for (bool otraVez = true; otraVez; otraVez = ataComo(original, programa)) {
        ataComo(original, programa);
        glLinkProgram(programa);
    }
    if (contesta(glGetProgramiv, programa, GL_LINK_STATUS))
        return programa;
    glDeleteProgram(programa);
    return 0;
}

namespace {
std::map<std::pair<GLuint, std::string>, GLuint> gemelos;
}

GLuint gemelo(GLuint original, const std::string &clase, const std::function<GLuint()> &hace) {
    const auto [hecho, nuevo] = gemelos.insert({{original, clase}, 0});
    if (nuevo)
        hecho->second = hace();
    if (hecho->second)
        copiaUniforms(original, hecho->second);
    return hecho->second;
}

void olvidaGemelos() {
    for (const auto &hecho : gemelos)
        glDeleteProgram(hecho.second);
    gemelos.clear();
}

GLuint sinDescartar(GLuint original) {
    const GLuint otro = gemelo(original, "sin descartar", [&]() -> GLuint {
        std::vector<GLuint> shaders;
        for (const Fuente &f : fuentesDe(original))
            if (f.tipo == GL_VERTEX_SHADER)
                shaders.push_back(f.shader);
        if (shaders.empty())
            return 0;
        shaders.push_back(compila(GL_FRAGMENT_SHADER,
                                  "#version 140\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n"));
        const GLuint hecho = enlazaComo(original, shaders);
        glDeleteShader(shaders.back());
        return hecho;
    });
    return otro ? otro : original; // sin sus fuentes, lo que descarta no se ve
}

} // namespace explica
