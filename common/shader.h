// Programas GLSL leídos de fichero (listados 1.3 y 2.3), con errores que nombran fichero y línea.
#pragma once
#include <GL/glew.h>
#include <glm/glm.hpp>
#include <string>

/// Índices que creaPrograma da a los atributos de nombre conocido, los mismos en todos los programas:
/// así un VAO vale para cualquiera, y sigue valiendo cuando F5 vuelve a enlazar.
enum Atributo : GLuint {
    ATRIBUTO_POSICION = 0,      // in vec3 posicion
    ATRIBUTO_NORMAL = 1,        // in vec3 vNormal
    ATRIBUTO_COORD_TEXTURA = 2, // in vec2 coordTextura
    ATRIBUTO_COLOR = 3          // in vec3 color
};

/// Compila y enlaza los dos shaders, dados por su ruta desde la raíz del laboratorio. Una línea
/// `#include "ruta/desde/la/raiz.glsl"` se sustituye por el contenido de ese fichero.
/// El vertex shader debe usar el atributo `posicion`, o gl_VertexID si no le hacen falta vértices.
/// Si algo falla, termina con «fichero:línea: error — «la línea»».
GLuint creaPrograma(const std::string &vert, const std::string &frag);

/// Como creaPrograma, pero si algo falla devuelve 0 y deja en `error` lo que ha pasado.
GLuint intentaPrograma(const std::string &vert, const std::string &frag, std::string &error);

/// Borra un programa y sus shaders; 0 se ignora.
void borraPrograma(GLuint programa);

/// Posición de un uniform; si el programa no lo usa avisa una vez y devuelve −1, que OpenGL ignora.
/// Se pregunta al dibujar: cada vez que F5 vuelve a enlazar, posiciones y valores empiezan de nuevo.
GLint uniforme(GLuint programa, const char *nombre);

/// Da valor a un uniform del programa en uso (glUniform de cada tipo).
void envia(GLuint programa, const char *nombre, float valor);
void envia(GLuint programa, const char *nombre, int valor); // también la unidad de una textura
void envia(GLuint programa, const char *nombre, const glm::vec2 &valor);
void envia(GLuint programa, const char *nombre, const glm::vec3 &valor);
void envia(GLuint programa, const char *nombre, const glm::vec4 &valor);
void envia(GLuint programa, const char *nombre, const glm::mat3 &valor);
void envia(GLuint programa, const char *nombre, const glm::mat4 &valor);

/// Pone en uso un programa cuyos shaders tienen esas dos matrices y se las envía (capítulo 4).
void usaPrograma(GLuint programa, const glm::mat4 &camara, const glm::mat4 &proyeccion);

/// Vuelve a leer los shaders de todos los programas creados con creaPrograma. El que falla conserva los que tenía, su
/// error se escribe en stderr y los demás programas se releen igual. Devuelve los errores, uno por línea.
std::string recargaProgramas();

/// Si alguno de los ficheros leídos ha cambiado después.
bool hanCambiadoLosShaders();
