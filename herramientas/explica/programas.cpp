#include "programas.h"
#include "enviado.h"
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
        GLint tipo = 0, largo = 0;
        glGetShaderiv(shaders[i], GL_SHADER_TYPE, &tipo);
        glGetShaderiv(shaders[i], GL_SHADER_SOURCE_LENGTH, &largo);
        largo *= 4; // el de Emscripten es en letras, y no en bytes
        GLsizei escritos = 0;
        std::string texto(std::size_t(largo), '\0');
        glGetShaderSource(shaders[i], largo, &escritos, texto.data());
        texto.resize(std::size_t(escritos));
        fuentes.push_back({GLenum(tipo), shaders[i], texto});
    }
    return fuentes;
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
    GLint n = 0;
    glGetProgramiv(programa, GL_ACTIVE_UNIFORMS, &n);
    for (GLint i = 0; i < n; ++i) {
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
    GLint n = 0;
    glGetProgramiv(programa, GL_ACTIVE_ATTRIBUTES, &n);
    for (GLint i = 0; i < n; ++i) {
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
    GLint n = 0;
    glGetProgramiv(programa, GL_ACTIVE_UNIFORM_BLOCKS, &n);
    for (GLint i = 0; i < n; ++i) {
        GLchar nombre[256];
        GLint enlace = 0;
        glGetActiveUniformBlockName(programa, GLuint(i), sizeof nombre, nullptr, nombre);
        glGetActiveUniformBlockiv(programa, GLuint(i), GL_UNIFORM_BLOCK_BINDING, &enlace);
        bloques.push_back({nombre, GLuint(enlace)});
    }
    return bloques;
}

namespace {

struct Envia {
    int componentes;
    bool entero;
    void (*pon)(GLint donde, const void *valor);
};

#define DE_FLOAT(funcion) [](GLint d, const void *v) { funcion(d, 1, static_cast<const GLfloat *>(v)); }
#define DE_MATRIZ(funcion)                                                                                   \
    [](GLint d, const void *v) { funcion(d, 1, GL_FALSE, static_cast<const GLfloat *>(v)); }
#define DE_ENTERO(funcion) [](GLint d, const void *v) { funcion(d, 1, static_cast<const GLint *>(v)); }
#define DE_NATURAL(funcion) [](GLint d, const void *v) { funcion(d, 1, static_cast<const GLuint *>(v)); }

const std::map<GLenum, Envia> ENVIOS = {
    {GL_FLOAT, {1, false, DE_FLOAT(glUniform1fv)}},
    {GL_FLOAT_VEC2, {2, false, DE_FLOAT(glUniform2fv)}},
    {GL_FLOAT_VEC3, {3, false, DE_FLOAT(glUniform3fv)}},
    {GL_FLOAT_VEC4, {4, false, DE_FLOAT(glUniform4fv)}},
    {GL_FLOAT_MAT2, {4, false, DE_MATRIZ(glUniformMatrix2fv)}},
    {GL_FLOAT_MAT3, {9, false, DE_MATRIZ(glUniformMatrix3fv)}},
    {GL_FLOAT_MAT4, {16, false, DE_MATRIZ(glUniformMatrix4fv)}},
    {GL_FLOAT_MAT2x3, {6, false, DE_MATRIZ(glUniformMatrix2x3fv)}},
    {GL_FLOAT_MAT3x2, {6, false, DE_MATRIZ(glUniformMatrix3x2fv)}},
    {GL_FLOAT_MAT2x4, {8, false, DE_MATRIZ(glUniformMatrix2x4fv)}},
    {GL_FLOAT_MAT4x2, {8, false, DE_MATRIZ(glUniformMatrix4x2fv)}},
    {GL_FLOAT_MAT3x4, {12, false, DE_MATRIZ(glUniformMatrix3x4fv)}},
    {GL_FLOAT_MAT4x3, {12, false, DE_MATRIZ(glUniformMatrix4x3fv)}},
    {GL_INT_VEC2, {2, true, DE_ENTERO(glUniform2iv)}},
    {GL_INT_VEC3, {3, true, DE_ENTERO(glUniform3iv)}},
    {GL_INT_VEC4, {4, true, DE_ENTERO(glUniform4iv)}},
    {GL_BOOL_VEC2, {2, true, DE_ENTERO(glUniform2iv)}},
    {GL_BOOL_VEC3, {3, true, DE_ENTERO(glUniform3iv)}},
    {GL_BOOL_VEC4, {4, true, DE_ENTERO(glUniform4iv)}},
    {GL_UNSIGNED_INT, {1, true, DE_NATURAL(glUniform1uiv)}},
    {GL_UNSIGNED_INT_VEC2, {2, true, DE_NATURAL(glUniform2uiv)}},
    {GL_UNSIGNED_INT_VEC3, {3, true, DE_NATURAL(glUniform3uiv)}},
    {GL_UNSIGNED_INT_VEC4, {4, true, DE_NATURAL(glUniform4uiv)}},
};
const Envia SUELTO = {1, true, DE_ENTERO(glUniform1iv)}; // int, bool y los sampler

const Envia &envioDe(GLenum tipo) {
    const auto hallado = ENVIOS.find(tipo);
    return hallado == ENVIOS.end() ? SUELTO : hallado->second;
}

union Valor {
    GLfloat real[16];
    GLint entero[16];
};

void lee(GLuint programa, const Variable &v, Valor &valor) {
    if (esEntero(v.tipo))
        glGetUniformiv(programa, v.donde, valor.entero);
    else
        glGetUniformfv(programa, v.donde, valor.real);
}

} // namespace

int componentesDe(GLenum tipo) {
    return envioDe(tipo).componentes;
}

bool esEntero(GLenum tipo) {
    return envioDe(tipo).entero;
}

void daOtroValor(const Variable &uniform) {
    Valor valor{};
    for (int i = 0; i < 16; ++i)
        if (esEntero(uniform.tipo))
            valor.entero[i] = 1 + i;
        else
            valor.real[i] = 0.3f + 0.17f * float((5 * i) % 16);
    envioDe(uniform.tipo).pon(uniform.donde, &valor);
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
            envioDe(uniforms[i].tipo).pon(donde, &valores[i]);
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
    GLint enlazado = GL_FALSE;
    glGetProgramiv(programa, GL_LINK_STATUS, &enlazado);
    if (enlazado)
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
    return gemelo(original, "sin descartar", [&]() -> GLuint {
        std::vector<GLuint> shaders;
        for (const Fuente &f : fuentesDe(original))
            if (f.tipo == GL_VERTEX_SHADER)
                shaders.push_back(f.shader);
        if (shaders.empty())
            return 0;
        const char *const texto = "#version 140\nout vec4 color;\nvoid main() {\n    color = vec4(1.0);\n}\n";
        const GLuint fragmento = glCreateShader(GL_FRAGMENT_SHADER);
        glShaderSource(fragmento, 1, &texto, nullptr);
        glCompileShader(fragmento);
        shaders.push_back(fragmento);
        const GLuint hecho = enlazaComo(original, shaders);
        glDeleteShader(fragmento);
        return hecho;
    });
}

} // namespace explica
