// Los #include de los shaders y la traducción del informe del compilador. La entrada son, separados por bytes nulos:
// el shader, el informe que da el compilador y dos ficheros, a y b, que se pueden incluir.
#include "shader.h"
#include "soporte.h"
#include <cstring>
#include <vector>

static std::string informe;

// Un compilador que rechaza todos los shaders con ese informe.
static GLuint crea(GLenum) {
    return 1;
}
static void fuente(GLuint, GLsizei, const GLchar *const *texto, const GLint *) {
    exige(std::strlen(*texto) < 100000000);
}
static void nada(GLuint) {
}
static void parametro(GLuint, GLenum cual, GLint *valor) {
    *valor = cual == GL_INFO_LOG_LENGTH ? GLint(informe.size()) + 1 : GL_FALSE;
}
static void daInforme(GLuint, GLsizei cabe, GLsizei *, GLchar *texto) {
    exige(std::size_t(cabe) > informe.size());
    std::memcpy(texto, informe.c_str(), informe.size() + 1);
}

int LLVMFuzzerTestOneInput(const std::uint8_t *datos, std::size_t n) {
    glCreateShader = crea;
    glShaderSource = fuente;
    glCompileShader = glDeleteShader = nada;
    glGetShaderiv = parametro;
    glGetShaderInfoLog = daInforme;

    const std::string entrada(datos, datos + n);
    std::vector<std::string> partes(1);
    for (const char c : entrada)
        if (c == '\0' && partes.size() < 4)
            partes.emplace_back();
        else
            partes.back() += c;
    partes.resize(4);
    informe = partes[1].c_str(); // sin bytes nulos, como lo da OpenGL
    ficheros = {{"shader", partes[0]}, {"a", partes[2]}, {"b", partes[3]}};
    std::string error;
    exige(intentaPrograma("shader", "shader", error) == 0 && !error.empty());
    return 0;
}
