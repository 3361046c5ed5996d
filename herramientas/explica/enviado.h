// Lo que el programa da a sus uniforms, apuntado por su nombre: de los que el enlazador quita porque nada los usa,
// OpenGL no guarda el valor, y el shader reescrito, que apunta lo que nadie usaba aún, lo necesita.
#pragma once
#include "programas.h"

namespace explica {

/// La función por la que se cambia esa, o nulo: las que dan valor a un uniform, y las que preguntan dónde está algo o a
/// qué se ata. Hacen lo mismo, y lo apuntan.
Direccion tapaEnvio(const std::string &nombre);

/// Si a ese uniform de ese programa, que está donde dice, se le ha dado un valor.
bool seHaDado(GLuint programa, GLint donde);

/// Desde dónde se le ha dado, la última vez: el número de la pila (pila.h), o -1.
int pilaDelEnvio(GLuint programa, GLint donde);

/// La función que no es la suya con que se le ha dado: glUniform1f a un sampler. Vacío si ninguna.
std::string malDado(GLuint programa, const Variable &uniform);

/// Ata cada atributo donde lo ha atado el original, aunque en él no esté, y los que no se sabe dónde, donde no hay
/// ningún array. Hay que llamarla antes de enlazar y, si devuelve verdadero, enlazar otra vez.
bool ataComo(GLuint original, GLuint programa);

/// Lo que en el original no está, porque nada lo usa, y no se sabe qué vale.
struct Desconocidas {
    std::vector<Variable> uniforms, atributos;
    std::string otra; // un sampler o un bloque, si lo hay

    /// Por qué lo que depende de ello no se dice.
    std::string motivo() const;
    /// A todo, otro valor; los atributos, que no vienen de un array, quedan como estaban si no es `otro`.
    void pon(bool otro) const;
};

/// Da a los uniforms de `otro`, que está en uso, lo que se ha enviado a los que en el original no están.
Desconocidas daLoEnviado(GLuint original, GLuint otro);

} // namespace explica
