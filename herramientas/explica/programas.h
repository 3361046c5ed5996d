// Los programas de GLSL: sus fuentes y uniforms, y otros que comparten el vertex shader.
#pragma once
#include "opengl.h"
#include <functional>
#include <string>
#include <vector>

namespace explica {

struct Desconocidas;

struct Fuente {
    GLenum tipo; // GL_VERTEX_SHADER o GL_FRAGMENT_SHADER
    GLuint shader;
    std::string texto;
};

/// Los shaders de un programa; ninguno si ya se los han quitado.
std::vector<Fuente> fuentesDe(GLuint programa);

std::vector<GLuint> shadersDe(GLuint programa);
std::string fuenteDe(GLuint programa, GLenum tipo);

/// El shader de esa fuente, o 0 si no compila.
GLuint compila(GLenum tipo, const std::string &fuente);

/// Si está esa palabra en el texto de un shader.
bool nombra(const std::string &texto, const std::string &palabra);

/// Una variable activa de un programa: un uniform o un atributo.
struct Variable {
    std::string nombre; // de un array, cada elemento: «pesos[2]»
    GLenum tipo;
    GLint donde;
};
std::vector<Variable> uniformsDe(GLuint programa);
std::vector<Variable> atributosDe(GLuint programa);

/// Cuántos números tiene un valor de ese tipo, y si son enteros: GL_FLOAT_VEC3, 3.
int componentesDe(GLenum tipo);
bool esEntero(GLenum tipo);

struct Bloque {
    std::string nombre;
    GLuint enlace;
};
std::vector<Bloque> bloquesDe(GLuint programa);

/// Le da un valor que no es el de entrada. El programa tiene que estar en uso.
void daOtroValor(const Variable &uniform);

/// Lo que vale un uniform, por columnas.
std::vector<double> valorDe(GLuint programa, const Variable &uniform);

/// Enlaza un programa con esos shaders y con los atributos en el sitio que tienen en `original`. `antes`: lo que haya
/// que decirle antes de enlazar. 0 si no enlaza.
GLuint enlazaComo(
    GLuint original, const std::vector<GLuint> &shaders,
    const std::function<void(GLuint)> &antes = [](GLuint) {});

/// Da a los uniforms de `otro` el valor que tienen en `original` o, si ahí no están, lo que se les ha enviado. Lo deja
/// en uso.
Desconocidas copiaUniforms(GLuint original, GLuint otro);

/// Otro como ese, de esa clase, con sus uniforms y en uso: lo que da `hace` la primera vez. 0 si no se puede.
GLuint gemelo(GLuint original, const std::string &clase, const std::function<GLuint()> &hace);
void olvidaGemelos(); // los programas pueden haber cambiado

/// El mismo, con un fragment shader que no descarta nada. Si no se puede, él.
GLuint sinDescartar(GLuint original);

} // namespace explica
